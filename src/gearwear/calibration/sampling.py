"""Which points of the sweeps a search looks at: a few for every claim, out of those that the study computes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from gearwear.claims import rules

POINTS = 9  # of a window, and on either side of an event
_SPACING = 2  # points of the sweep from one of those near an event to the next


def points(claims: Iterable[Mapping[str, Any]], sweep: str, grid: np.ndarray) -> np.ndarray:
    """Return the indices, ascending, of the points of a sweep that suffice to judge the claims about it.

    A window gives at most `POINTS` of its points, evenly spread; an event those within `POINTS` steps of two points
    of the sweep of where it is expected; an amplitude jump every fourth point of its range.

    Parameters
    ----------
    claims : the statements, as in `config/paper_claims.yaml`; those about other sweeps are passed over.
    grid : the swept values, ascending.
    """
    wanted: set[int] = set()
    for claim in claims:
        if claim.get("sweep") != sweep:
            continue
        if claim["kind"] == "window":
            wanted.update(_spread(_within(grid, *claim["range"]), POINTS))
        elif claim["event"] == "amplitude jump":
            wanted.update(_within(grid, *rules.AMPLITUDE_JUMP_RANGE)[:: 2 * _SPACING])
        else:
            centre = int(np.abs(grid - claim["expected"]).argmin())
            near = np.arange(centre - POINTS * _SPACING, centre + POINTS * _SPACING + 1, _SPACING)
            wanted.update(near[(near >= 0) & (near < len(grid))])
    return np.array(sorted(wanted), dtype=int)


def _within(grid: np.ndarray, low: float, high: float) -> np.ndarray:
    tolerance = rules.GRID_TOLERANCE
    return np.flatnonzero((grid >= low - tolerance) & (grid <= high + tolerance))


def _spread(inside: np.ndarray, count: int) -> np.ndarray:
    if len(inside) <= count:
        return inside
    return inside[np.linspace(0, len(inside) - 1, count).round().astype(int)]
