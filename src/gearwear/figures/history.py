"""What becomes of a state with the revolutions: panels over the running cycles, one line a case."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from matplotlib.figure import Figure

from gearwear.figures import legend, states
from gearwear.figures.sheet import letter

LABEL = "Revolutions of the pinion (10⁹)"
_DOT: dict[str, Any] = {"marker": "o", "markersize": 1.8, "markeredgewidth": 0}


class Panel(NamedTuple):
    """Title, label of the ordinate, and for every case the values after each wear cycle, in the unit of the label."""

    title: str
    label: str
    values: Sequence[np.ndarray]


def draw(
    figure: Figure, cycles: Sequence[np.ndarray], panels: Sequence[Panel], drawn: Sequence[dict[str, Any]]
) -> None:
    """Draw two panels a row.

    Parameters
    ----------
    cycles : running cycles of every case, (q,) each.
    panels : an even number.
    drawn : the cases at the end of their life, each with its `place` in the order of colours.
    """
    grid = figure.subplots(len(panels) // 2, 2, sharex=True, squeeze=False)
    for position, (axes, panel) in enumerate(zip(grid.flat, panels, strict=True)):
        for count, values, state in zip(cycles, panel.values, drawn, strict=True):
            line = states.line(state["place"], state) | {"label": states.in_words(state)}
            axes.plot(1e-9 * count, values, **line, **_DOT)
        axes.set_title(f"{letter(position)} {panel.title}", loc="left")
        axes.set_ylabel(panel.label)
    for axes in grid[-1]:
        axes.set_xlabel(LABEL)
        axes.set_xlim(left=0)
    for column in grid.T:
        figure.align_ylabels(column)
    lines, _ = grid[0, 0].get_legend_handles_labels()
    legend.above(figure, lines, len(lines))
