"""Figure 10: thermal growth of the four flanks beside elastic deflection and wear."""

from typing import TYPE_CHECKING

import numpy as np

from gearwear.figures import legend, path_axis, states
from gearwear.figures.sheet import DOUBLE, letter, sheet
from gearwear.geometry.path_mean import path_mean
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

QUANTITIES = {
    "growth of the four flanks": {"color": "#D55E00", "dashes": ()},
    "elastic deflection": {"color": "#0072B2", "dashes": (5, 1.4)},
    "wear of both flanks": {"color": "#000000", "dashes": (5, 1.4, 1, 1.4)},
}


def lengths(job):
    """Return for every state the three lengths along the path, m, in the order of `QUANTITIES`."""
    for files in zip(job.input.deformation, job.input.transmission_error, job.input.wear, strict=True):
        deformation, transmission, wear = (store.load(path) for path in files)
        growth = 2 * deformation["thermal_growth"].sum("gear")
        yield growth, transmission["elastic_deflection"], wear["wear_depth"].sum("gear")


def main(job):
    geometry, drawn = store.load(job.input.geometry), job.params.cfg["states"]
    fields = list(lengths(job))
    means = np.array([[1e6 * path_mean(field) for field in state] for state in fields])
    means = np.round(means, 3) + 0.0  # no label may read -0.0
    with sheet(job, DOUBLE, 72) as figure:
        along, grouped = figure.subplots(1, 2, sharey=True, width_ratios=(1, 1.15))
        width = 0.84 / len(QUANTITIES)
        for place, (label, line) in enumerate(QUANTITIES.items()):
            path_axis.draw(along, fields[-1][place], 1e6, label=label, **line)
            along.axhline(means[-1, place], 0, 1, color=line["color"], linewidth=0.6)
            at = np.arange(len(drawn)) + (place - 1) * width
            bars = grouped.bar(at, means[:, place], width, color=line["color"])
            grouped.bar_label(bars, fmt="%.1f", padding=1.5, fontsize=6.5)
        path_axis.mark(along, geometry)
        along.set_ylabel("Length on the line of action (µm)")
        along.set_ylim(0, 1.08 * 1e6 * max(float(field.max()) for state in fields for field in state))
        along.set_title(f"{letter(0)} {states.name(drawn[-1])}; thin lines: means", loc="left")
        grouped.set_ylabel("Mean length (µm)")
        grouped.tick_params(labelleft=True)
        grouped.set_title(f"{letter(1)} Means over the path", loc="left")
        grouped.set_xticks(
            range(len(drawn)),
            [f"{states.temperature(s)}\n{states.cycles(s)}".replace(" cycles", "\ncycles") for s in drawn],
        )
        grouped.tick_params(axis="x", which="both", length=0)
        lines, _ = along.get_legend_handles_labels()
        keys = [*lines, *path_axis.keys()]
        legend.above(figure, keys, len(keys))


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
