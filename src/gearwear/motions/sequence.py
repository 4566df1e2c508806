"""The sequence of motion classes along a sweep: runs of one class, and what follows what."""

from __future__ import annotations

import numpy as np

from gearwear.codes.motion_class import NOT_CONVERGED


def runs(motion_class: np.ndarray) -> list[tuple[int, int, int]]:
    """Return the runs of equal classes as (class, first index, last index)."""
    starts = np.concatenate([[0], np.flatnonzero(np.diff(motion_class)) + 1])
    ends = np.concatenate([starts[1:] - 1, [motion_class.size - 1]])
    return [(int(motion_class[a]), int(a), int(b)) for a, b in zip(starts, ends, strict=True)]


def changes(motion_class: np.ndarray, before: int, after: int, least: int) -> list[tuple[int, int]]:
    """Return where a run of class `before` is followed by one of class `after`: its last index, and their first.

    Points that did not converge are left out first, then runs shorter than `least` points.
    """
    kept, long_runs = _converged(motion_class, least)
    return [
        (int(kept[one[2]]), int(kept[other[1]]))
        for one, other in zip(long_runs, long_runs[1:], strict=False)
        if (one[0], other[0]) == (before, after)
    ]


def first_run(motion_class: np.ndarray, wanted: int, least: int) -> tuple[int, int] | None:
    """Return the first and last index of the first run of a class of at least `least` points, None without one.

    Points that did not converge are left out first.
    """
    kept, long_runs = _converged(motion_class, least)
    return next(((int(kept[a]), int(kept[b])) for code, a, b in long_runs if code == wanted), None)


def _converged(motion_class: np.ndarray, least: int) -> tuple[np.ndarray, list[tuple[int, int, int]]]:
    kept = np.flatnonzero(np.asarray(motion_class) != NOT_CONVERGED)
    if not kept.size:
        return kept, []
    return kept, [run for run in runs(np.asarray(motion_class)[kept]) if run[2] - run[1] + 1 >= least]
