"""Figure 11: half backlash of one pair along the path of contact."""

from typing import TYPE_CHECKING

from gearwear.figures import legend, path_axis, states
from gearwear.figures.sheet import SINGLE, sheet
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    geometry, drawn = store.load(job.input.geometry), job.params.cfg["states"]
    clearances = [store.load(path) for path in job.input.backlash]
    with sheet(job, SINGLE, 74) as figure:
        axes = figure.subplots()
        for place, (clearance, state) in enumerate(zip(clearances, drawn, strict=True)):
            path_axis.draw(axes, clearance["backlash_path"], 1e6, **states.line(place, state))
        initial = 1e6 * float(clearances[0]["initial_half_backlash"])
        axes.axhline(initial, color="#777777", linewidth=0.6, label=f"initial, {initial:g} µm")
        path_axis.mark(axes, geometry)
        axes.set_ylabel("Half backlash (µm)")
        lines, _ = axes.get_legend_handles_labels()
        legend.above(figure, [*lines, *path_axis.keys()], 2)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
