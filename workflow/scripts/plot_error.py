"""Figure 9: loaded static transmission error, and its rise by heat and wear."""

from typing import TYPE_CHECKING

from gearwear.figures import legend, path_axis, phase_axis, states
from gearwear.figures.sheet import DOUBLE, letter, sheet
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    geometry, drawn = store.load(job.input.geometry), job.params.cfg["states"]
    errors = [store.load(path)["transmission_error"].values for path in job.input.transmission_error]
    with sheet(job, DOUBLE, 68) as figure:
        panels = figure.subplots(1, 2)
        for place, (error, state) in enumerate(zip(errors, drawn, strict=True)):
            line = states.line(place, state)
            phase_axis.draw(panels[0], geometry, 1e6 * error, **line)
            phase_axis.draw(panels[1], geometry, 1e6 * (error - errors[0]), **line)
        titles = ("Transmission error", f"Rise from {states.name(drawn[0])}")
        labels = ("Static transmission error (µm)", "Rise of transmission error (µm)")
        for position, axes in enumerate(panels):
            phase_axis.mark(axes, geometry)
            axes.set_title(f"{letter(position)} {titles[position]}", loc="left")
            axes.set_ylabel(labels[position])
        lines, _ = panels[0].get_legend_handles_labels()
        keys = [*lines, *path_axis.keys(with_pitch_point=False)]
        legend.above(figure, keys, len(drawn))


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
