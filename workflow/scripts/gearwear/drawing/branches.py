"""Branches of periodic orbits over a bifurcation diagram: stable solid, unstable dashed, special points marked."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from gearwear.orbits.codes import FOLD, NONE, PERIOD_DOUBLING, SPECIAL_POINTS, STABILITY, TORUS

_STABLE, _UNSTABLE = "#0072B2", "#B8478F"
_LINES = {
    "stable": {"color": _STABLE, "linewidth": 0.8, "zorder": 2.5},
    "unstable": {"color": _UNSTABLE, "linewidth": 0.6, "linestyle": "--", "dashes": (3.5, 1.5), "zorder": 2.4},
}
_MARKS = {FOLD: ("^", "fold"), PERIOD_DOUBLING: ("D", "period doubling"), TORUS: ("s", "torus")}
_MARK = {"linestyle": "none", "markersize": 2.6, "markeredgewidth": 0.5, "markerfacecolor": "white", "zorder": 3}
_ROOM = 0.25  # of the height of the diagram, above and below it, beyond which no branch is shown
_EDGE = 0.03  # of the height, left free beyond the outermost orbit


def draw(axes: Axes, sweep: str, branches: xr.Dataset) -> None:
    """Draw section displacements of all branches, keeping to the neighbourhood of what is drawn already."""
    low, high = axes.get_ylim()
    room = _ROOM * (high - low)
    values, section = branches[sweep].values, branches["branch_displacement"].values
    for nodes, stability in runs(branches):
        period = int(branches["branch_period"].values[branches["branch_index"].values[nodes[0]]])
        for iterate in range(period):
            axes.plot(values[nodes], section[nodes, iterate], **_LINES[stability])
    for code, (marker, _) in _MARKS.items():
        found = np.flatnonzero(branches["special_point"].values == code)
        if not found.size:
            continue
        at = np.repeat(values[found], section.shape[1])
        axes.plot(at, section[found].ravel(), marker=marker, markeredgecolor=_edge(code), **_MARK)
    drawn = section[np.isfinite(section)]
    if drawn.size:
        edge = _EDGE * (high - low)
        axes.set_ylim(max(low - room, min(low, drawn.min() - edge)), min(high + room, max(high, drawn.max() + edge)))


def runs(branches: xr.Dataset) -> Iterator[tuple[np.ndarray, str]]:
    """Yield the nodes of every piece of a branch of one stability, and which it has.

    A piece ends at the special point it shares with the next. There, and where a branch begins or ends, a multiplier
    may be on the unit circle, so a step between two nodes goes by the one inside the piece.
    """
    stable, index = branches["stable"].values, branches["branch_index"].values
    special = branches["special_point"].values != NONE
    words = {code: word for word, code in STABILITY.items()}
    for branch in range(branches.sizes["branch"]):
        nodes = np.flatnonzero(index == branch)
        sure = ~special[nodes]
        sure[[0, -1]] = False
        steps = [stable[a] if known else stable[b] for a, b, known in zip(nodes, nodes[1:], sure, strict=False)]
        cuts = [0, *(1 + np.flatnonzero(np.diff(steps))), len(steps)]
        for first, last in zip(cuts, cuts[1:], strict=False):
            if last > first:
                yield nodes[first : last + 1], words[int(steps[first])]


def keys(special: set[int], lines: bool) -> list[Line2D]:
    """Return the legend entries of the lines and of the kinds of special points given by their codes."""
    entries = [Line2D([], [], label=f"{name} orbits", **style) for name, style in _LINES.items()] if lines else []
    for code in sorted(special - {SPECIAL_POINTS["none"]}):
        marker, label = _MARKS[code]
        entries.append(Line2D([], [], marker=marker, markeredgecolor=_edge(code), label=label, **_MARK))
    return entries


def _edge(code: int) -> str:
    return _UNSTABLE if code == FOLD else _STABLE
