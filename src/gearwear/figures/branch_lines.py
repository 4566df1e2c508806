"""Branches of periodic orbits over a bifurcation diagram: stable solid, unstable dashed, special points labelled."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import xarray as xr
from matplotlib import patheffects
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from gearwear.codes.branch_codes import FOLD, NONE, PERIOD_DOUBLING, SPECIAL_POINTS, STABILITY, TORUS

_STABLE, _UNSTABLE = "#0072B2", "#B8478F"
_LINES: dict[str, dict[str, Any]] = {
    "stable": {"color": _STABLE, "linewidth": 0.8, "zorder": 2.5},
    "unstable": {"color": _UNSTABLE, "linewidth": 0.6, "linestyle": "--", "dashes": (3.5, 1.5), "zorder": 2.4},
}
_MARKS = {FOLD: ("^", "fold"), PERIOD_DOUBLING: ("D", "period doubling"), TORUS: ("s", "torus")}
_MARK: dict[str, Any] = {
    "linestyle": "none",
    "markersize": 2.6,
    "markeredgewidth": 0.5,
    "markerfacecolor": "white",
    "zorder": 3,
}
_ROOM = 0.25  # of the height of the diagram, above and below it, beyond which no branch is shown
_EDGE = 0.03  # of the height, left free beyond the outermost orbit
_LABEL: dict[str, Any] = {"rotation": 90, "fontsize": 6, "ha": "center", "textcoords": "offset points", "zorder": 3.5}
_ABOVE = 2.8  # points from a mark to its label
_WIDE, _LONG = 0.02, 0.15  # of a label, over the width and the height of the diagram
_RIM = [patheffects.withStroke(linewidth=1.0, foreground="white")]


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
    _label(axes, values, branches["special_point"].values, section)


def _label(axes: Axes, values: np.ndarray, special: np.ndarray, section: np.ndarray) -> None:
    """Write the swept value beside one mark of every special point, the highest that other labels leave free."""
    bounds, height = np.sort(axes.get_xlim()), np.ptp(axes.get_ylim())
    low, high = axes.get_ylim()
    taken: list[tuple[float, float]] = []
    for node in sorted(np.flatnonzero(special != NONE), key=lambda node: values[node]):
        seen = section[node][(section[node] >= low) & (section[node] <= high)]
        if not seen.size or not bounds[0] <= values[node] <= bounds[1]:
            continue
        spots = [(y, side) for side in (1, -1) for y in sorted(seen, reverse=True)]
        places = [(values[node] / np.ptp(bounds) / _WIDE, y / height / _LONG + side / 2) for y, side in spots]
        inside = [abs(place[1] - (low + high) / 2 / height / _LONG) < 0.5 / _LONG - 0.5 for place in places]
        apart = [all(max(np.abs(np.subtract(place, other))) >= 1 for other in taken) for place in places]
        free = np.flatnonzero(np.logical_and(inside, apart))
        if not free.size:
            continue
        taken.append(places[free[0]])
        y, side = spots[free[0]]
        axes.annotate(
            f"{values[node]:.3f}",
            (values[node], y),
            (0, side * _ABOVE),
            va="bottom" if side > 0 else "top",
            color=_edge(special[node]),
            path_effects=_RIM,
            **_LABEL,
        )


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
