"""Figure of the wear history: wear, transmission error and mesh stiffness over the revolutions, one line a case."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from gearwear.figures import labels
from gearwear.figures.sheet import DOUBLE, legend_above, letter, sheet
from gearwear.oscillator.harmonics import mean_over_mesh

_READ = {
    "wear": ("wear_depth", "running_cycles"),
    "transmission_error": ("transmission_error", "effective_stiffness"),
}
_PANELS = (
    ("Pinion", "Greatest wear depth (µm)"),
    ("Gear", "Greatest wear depth (µm)"),
    ("Transmission error", "Mean over the mesh (µm)"),
    ("Effective mesh stiffness", "Mean over the mesh (10⁸ N/m)"),
)
_DOT: dict[str, Any] = {"marker": "o", "markersize": 1.8, "markeredgewidth": 0}


@sheet(DOUBLE, 105.0, variables=_READ)
def draw(
    figure: Figure,
    geometry: xr.Dataset,
    wear: Sequence[xr.Dataset],
    transmission_error: Sequence[xr.Dataset],
    cfg: dict[str, Any],
) -> None:
    """Draw the deepest wear of either flank and the means of transmission error and effective stiffness.

    Parameters
    ----------
    geometry : dataset of the geometry stage.
    wear, transmission_error : of every case, one after another, after every wear cycle.
    cfg : `states`, the cases at the end of their life, each with its `place` in the order of colours.
    """
    width = geometry["mesh_phase_width"].values
    rows = np.array([_row(*files, width) for files in zip(wear, transmission_error, strict=True)])
    ends = np.cumsum([state["cycle"] + 1 for state in cfg["states"]])
    grid = figure.subplots(2, 2, sharex=True)
    for position, (axes, (title, label)) in enumerate(zip(grid.flat, _PANELS, strict=True)):
        for state, history in zip(cfg["states"], np.split(rows, ends[:-1]), strict=True):
            line = labels.line(state["place"], state)
            line["label"] = f"{state['case']}, {labels.temperature(state)}"
            axes.plot(1e-9 * history[:, 0], history[:, 1 + position], **line, **_DOT)
        axes.set_title(f"{letter(position)} {title}", loc="left")
        axes.set_ylabel(label)
    for axes in grid[-1]:
        axes.set_xlabel("Revolutions of the pinion (10⁹)")
        axes.set_xlim(left=0)
    for column in grid.T:
        figure.align_ylabels(column)
    lines, _ = grid[0, 0].get_legend_handles_labels()
    legend_above(figure, lines, len(lines))


def _row(wear: xr.Dataset, transmission: xr.Dataset, width: np.ndarray) -> tuple[float, ...]:
    """Return the running cycles and what the panels show, in their units."""
    deepest = 1e6 * wear["wear_depth"].values.max(axis=1)
    error = 1e6 * mean_over_mesh(transmission["transmission_error"].values, width)
    effective = 1e-8 * mean_over_mesh(transmission["effective_stiffness"].values, width)
    return float(wear["running_cycles"]), *deepest, error, effective
