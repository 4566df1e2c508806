"""Pseudo-arclength continuation: a branch of periodic orbits, step by step, through its folds."""

from __future__ import annotations

from functools import partial
from typing import Any, NamedTuple

import numpy as np

from gearwear.codes.branch_codes import NONE
from gearwear.orbits import ends
from gearwear.orbits.curve import ALONG_PARAMETER, Curve, Point, Trial
from gearwear.orbits.ends import End
from gearwear.orbits.locating import locate, locate_half_period
from gearwear.orbits.newton import Orbit
from gearwear.orbits.special_points import crossings, margins

_FIRST_STEP = 0.1  # of the largest
_LEAST_COSINE = 0.96  # between neighbouring tangents, 16 degrees
_FARTHEST_FROM_GUESS = 0.5  # of the step
_LARGEST_CHANGE = 0.4  # of the trace, over 1 + its modulus, in one step: two special points do not go unseen
_COLLAPSE = 0.1  # of the gap between states half a period apart, in one step
_TOWARDS_HALF = 0.35  # of the gap, towards an orbit of half the period: a branch point, singular itself
_NEAR_HALF = 0.25  # of the largest step: a gap from which that orbit is found directly
_FEW, _MANY = 5, 8  # Newton steps, the check included, after which the next step grows or shrinks


class Limits(NamedTuple):
    """How far and how finely a branch is followed.

    first, last : range of the parameter
    largest_step, smallest_step : length along the branch, displacement and velocity over b0 and velocity unit, the
        parameter over its range
    most_nodes : of one walk
    """

    first: float
    last: float
    largest_step: float = 0.02
    smallest_step: float = 1e-7
    most_nodes: int = 4000


class Node(NamedTuple):
    """One orbit of a branch and, where it is a special point, its kind."""

    orbit: Orbit
    special: int


class _Stride(NamedTuple):
    """A step that holds: where it leads, slope and tangent there, the nodes on the way and, if it is one, the end."""

    point: Point
    slope: np.ndarray
    tangent: np.ndarray
    nodes: list[Node]
    end: End | None


def check_limits(limits: Limits) -> None:
    """ValueError for limits that contradict each other."""
    if not np.isfinite([limits.first, limits.last]).all() or limits.first >= limits.last:
        raise ValueError(f"range of the parameter: {limits.first} to {limits.last} must be finite and increase")
    if not 0.0 < limits.smallest_step <= limits.largest_step < np.inf:
        raise ValueError(
            f"steps: smallest {limits.smallest_step}, largest {limits.largest_step} (length along the branch); "
            "both must be above 0, the smallest not above the largest"
        )
    if int(limits.most_nodes) != limits.most_nodes or limits.most_nodes < 1:
        raise ValueError(f"most_nodes: {limits.most_nodes} must be a whole number, 1 or more")


def walk(curve: Curve, start: Point, forward: np.ndarray, limits: Limits, new: bool = False) -> tuple[list[Node], End]:
    """Follow a branch from one of its points until it ends.

    Parameters
    ----------
    start : where to begin; it is not among the nodes returned.
    forward : (3,) direction, roughly the tangent's.
    new : the start is where another branch is left for this one, along `forward` exactly.

    Returns
    -------
    nodes, end : the nodes in order, special points between them; and why there are no more
    """
    here, tangent = start, forward
    slope: np.ndarray | None = None
    nodes: list[Node] = []
    if not new:
        slope, trouble = curve.slope(here.place)
        if slope is None:
            return nodes, ends.stopped(here.orbit, trouble)
        tangent = curve.tangent(here, slope, forward)
    step = _FIRST_STEP * limits.largest_step
    while len(nodes) < limits.most_nodes:
        trial = curve.correct(here.place + step * tangent, tangent, slope, step)
        if trial.point is not None and not 0.0 <= trial.point.place[2] <= 1.0:
            trial = _at_bound(curve, here, trial.point, slope)
        reached, trouble = _taken(curve, start, here, trial, step, tangent, limits, new, first=not nodes)
        if reached is None:
            step /= 2
            if step < limits.smallest_step:
                return nodes, ends.stopped(here.orbit, trouble)
            if slope is not None:
                slope, tangent = _refined(curve, here, step, slope, tangent)
            continue
        nodes += reached.nodes
        if reached.end is not None:
            return nodes, reached.end
        if trial.steps <= _FEW:
            step = min(1.5 * step, limits.largest_step)
        elif trial.steps >= _MANY:
            step /= 1.5
        gap = ends.gap(reached.point.orbit)
        if gap < ends.gap(here.orbit):
            step = min(step, _TOWARDS_HALF * gap)
        here, slope, tangent = reached.point, reached.slope, reached.tangent
    return nodes, ends.at_limit(here.orbit, limits.most_nodes)


def _taken(
    curve: Curve,
    start: Point,
    here: Point,
    trial: Trial,
    step: float,
    tangent: np.ndarray,
    limits: Limits,
    new: bool,
    first: bool,
) -> tuple[_Stride | None, str]:
    """Return the step to the point of a trial or, if it does not hold, why."""
    point = trial.point
    if point is None:
        return None, trial.trouble
    slope, trouble = curve.slope(point.place, step)
    if slope is None:
        return None, trouble
    new_tangent = curve.tangent(point, slope, tangent)
    trouble = _objection(here, point, step, tangent, new_tangent, new=new and first)
    if trouble:
        return None, trouble
    end, points = _end(curve, start, here, point, limits, first)
    found = _specials(curve, here, point, points[-1], skip=new and first) if points else None
    if points is None or found is None:
        return None, "a special point cannot be located"
    return _Stride(point, slope, new_tangent, [*found, *(Node(one.orbit, NONE) for one in points)], end), ""


def _refined(curve: Curve, here: Point, step: float, slope: np.ndarray, tangent: np.ndarray) -> Any:
    """Return slope and tangent at a point for a short step from it."""
    finer, _ = curve.slope(here.place, step)
    return (slope, tangent) if finer is None else (finer, curve.tangent(here, finer, tangent))


def _at_bound(curve: Curve, here: Point, reached: Point, slope: np.ndarray | None) -> Any:
    """Return the trial at the bound of the range that the step to a point crosses."""
    bound = 0.0 if reached.place[2] < 0.0 else 1.0
    share = (bound - here.place[2]) / (reached.place[2] - here.place[2])
    guess = here.place + share * (reached.place - here.place)
    guess[2] = bound
    trial = curve.correct(guess, ALONG_PARAMETER, slope)
    if trial.point is not None:
        trial.point.place[2] = bound
    return trial


def _objection(
    here: Point, reached: Point, step: float, tangent: np.ndarray, new_tangent: np.ndarray, new: bool
) -> str:
    """Return why a step is too long, or nothing."""
    along = tangent @ (reached.place - here.place)
    if np.linalg.norm(reached.place - here.place - along * tangent) > _FARTHEST_FROM_GUESS * step or along > 2 * step:
        return "the branch is lost"
    if new:
        return "the new branch is lost" if ends.gap(reached.orbit) < 0.1 * step else ""
    if ends.gap(reached.orbit) < _COLLAPSE * ends.gap(here.orbit):
        return "the step leads to an orbit of half the period"
    if new_tangent @ tangent < _LEAST_COSINE:
        return "the branch has a kink"
    before, after = np.trace(here.orbit.matrix), np.trace(reached.orbit.matrix)
    if abs(after - before) > _LARGEST_CHANGE * (1 + min(abs(before), abs(after))):
        return "the multipliers jump"
    return ""


def _end(
    curve: Curve, start: Point, here: Point, reached: Point, limits: Limits, first: bool
) -> tuple[End | None, list[Point] | None]:
    """Return the end of the branch at a step, if it ends there, and the points that the step adds.

    There are None if the step passes an end that cannot be located.
    """
    if ends.passes_half_period(here, reached):
        half = locate_half_period(curve, here)
        return (None, None) if half is None else (ends.halved(half.orbit), [half])
    if ends.gap(here.orbit) > ends.gap(reached.orbit) < _NEAR_HALF * limits.largest_step:
        half = locate_half_period(curve, reached)
        if half is not None and np.linalg.norm(half.place - reached.place) <= ends.gap(reached.orbit):
            return ends.halved(half.orbit), [reached, half]
    if not first and ends.passes_through(here, reached, start):
        return ends.closed(start.orbit), [start]
    if reached.place[2] in (0.0, 1.0):
        return ends.at_bound(reached.orbit), [reached]
    return None, [reached]


def _margin(kind: int, orbit: Orbit) -> float:
    return margins(orbit.matrix)[kind - 1]


def _specials(curve: Curve, here: Point, reached: Point, last: Point, skip: bool) -> list[Node] | None:
    """Return the special points of a step, in order and before the last point; None if one cannot be located."""
    found = []
    for kind in [] if skip else crossings(here.orbit.matrix, reached.orbit.matrix):
        point = locate(curve, here, reached, partial(_margin, kind))
        if point is None:
            return None
        found.append((np.linalg.norm(point.place - here.place), Node(point.orbit, kind)))
    whole = np.linalg.norm(last.place - here.place)
    return [node for way, node in sorted(found, key=lambda one: one[0]) if way <= whole]
