"""Figure 8: mesh stiffness, nominal and effective, and how heat and wear change it."""

from typing import TYPE_CHECKING

from matplotlib.lines import Line2D

from gearwear.figures import legend, path_axis, phase_axis, states
from gearwear.figures.sheet import DOUBLE, letter, sheet
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

LINES = {"nominal": (), "effective": (3, 1.2)}


def main(job):
    geometry, drawn = store.load(job.input.geometry), job.params.cfg["states"]
    stiffness = {
        "nominal": [store.load(path)["mesh_stiffness"].values for path in job.input.mesh_stiffness],
        "effective": [store.load(path)["effective_stiffness"].values for path in job.input.transmission_error],
    }
    with sheet(job, DOUBLE, 72) as figure:
        panels = figure.subplots(1, 2)
        for kind, dashes in LINES.items():
            for place, values in enumerate(stiffness[kind]):
                line = {"color": states.colour(place), "dashes": dashes}
                phase_axis.draw(panels[0], geometry, 1e-8 * values, **line)
                phase_axis.draw(panels[1], geometry, 100 * (values / stiffness[kind][0] - 1), **line)
        titles = ("Mesh stiffness", f"Change from {states.name(drawn[0])}")
        labels = ("Mesh stiffness (10⁸ N/m)", "Change of mesh stiffness (%)")
        for position, axes in enumerate(panels):
            phase_axis.mark(axes, geometry)
            axes.set_title(f"{letter(position)} {titles[position]}", loc="left")
            axes.set_ylabel(labels[position])
        colours = [Line2D([], [], color=states.colour(i), label=states.name(one)) for i, one in enumerate(drawn)]
        kinds = [Line2D([], [], color="black", dashes=dashes, label=kind) for kind, dashes in LINES.items()]
        keys = [*colours, *kinds, *path_axis.keys(with_pitch_point=False)]
        legend.above(figure, keys, len(drawn))


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
