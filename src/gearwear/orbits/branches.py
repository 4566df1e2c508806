"""Branches of periodic orbits from seeds, with those that period doublings give rise to."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from gearwear.codes.branch_codes import CLOSED, HALVED, NONE, PERIOD_DOUBLING
from gearwear.orbits import ends
from gearwear.orbits.continuation import Limits, Node, check_limits, walk
from gearwear.orbits.curve import ALONG_PARAMETER, Curve
from gearwear.orbits.ends import End
from gearwear.orbits.newton import Orbit, minimal_period, periodic_orbit, twice
from gearwear.orbits.return_map import Family

NO_PARENT = -1
_NEAR = 0.1  # farther from a chord than this no orbit is looked for
_SAME_VALUE, _SAME_STATE = 1e-6, 1e-5


class Seed(NamedTuple):
    """Where to look for an orbit: value of the parameter, state at mesh phase 0 and period in mesh periods."""

    value: float
    state: tuple[float, float]
    period: int


class Branch(NamedTuple):
    """Orbits of one period along a branch, from one end to the other.

    parent : index of the branch it was found on, NO_PARENT if from a seed
    """

    period: int
    nodes: tuple[Node, ...]
    start: End
    end: End
    parent: int


def follow(family: Family, orbit: Orbit, limits: Limits) -> Branch:
    """Return the branch through an orbit, followed both ways.

    Raises
    ------
    ValueError
        For limits that contradict each other, or an orbit outside the range.
    """
    check_limits(limits)
    if not limits.first <= orbit.value <= limits.last:
        raise ValueError(f"orbit: its parameter {orbit.value} is outside the range {limits.first} to {limits.last}")
    curve = Curve(family, orbit.period, limits.first, limits.last)
    seed = curve.point(orbit)
    sides: list[tuple[list[Node], End]] = []
    for side, bound in ((1.0, limits.last), (-1.0, limits.first)):
        if orbit.value == bound:
            sides.append(([], ends.at_bound(orbit)))
            continue
        sides.append(walk(curve, seed, side * ALONG_PARAMETER, limits))
        if sides[0][1].reason == CLOSED:
            nodes = (Node(orbit, NONE), *sides[0][0])
            return Branch(orbit.period, nodes, sides[0][1], sides[0][1], NO_PARENT)
    (after, end), (before, start) = sides
    return Branch(orbit.period, (*before[::-1], Node(orbit, NONE), *after), start, end, NO_PARENT)


def follow_doubled(family: Family, doubling: Orbit, limits: Limits, side: float = 1.0) -> Branch:
    """Return the branch of twice the period that leaves a period doubling.

    It starts along the eigenvector of the multiplier -1. Both directions of that, `side` 1 and -1, give the same
    orbits, seen `doubling.period` mesh periods apart.
    """
    check_limits(limits)
    values, vectors = np.linalg.eig(doubling.matrix)
    along = vectors[:, np.argmin(np.abs(values + 1))].real
    origin = twice(doubling)
    curve = Curve(family, origin.period, limits.first, limits.last)
    direction = np.append(side * along / np.linalg.norm(along), 0.0)
    nodes, end = walk(curve, curve.point(origin), direction, limits, new=True)
    return Branch(origin.period, (Node(origin, NONE), *nodes), ends.halved(origin), end, NO_PARENT)


def explore(family: Family, seeds: Iterable[Seed], limits: Limits, largest_period: int) -> list[Branch]:
    """Return all branches that seeds lead to, up to a largest period, each once.

    A seed from which Newton's method finds no orbit is passed over. The doublings of a branch are followed after it;
    where a branch ends in an orbit of half its period, that orbit is a seed in its turn.
    """
    check_limits(limits)
    forest = _Forest(family, limits, largest_period)
    for seed in seeds:
        forest.plant(seed)
    return forest.branches


def holds(family: Family, branch: Branch, orbit: Orbit) -> bool:
    """Whether an orbit, in any of its mesh periods, is on a branch."""
    if branch.period != orbit.period:
        return False
    for one, other in pairwise(node.orbit for node in branch.nodes):
        if (one.value - orbit.value) * (other.value - orbit.value) > 0:
            continue
        share = (orbit.value - one.value) / (other.value - one.value) if other.value != one.value else 0.0
        state = (1 - share) * one.section[0] + share * other.section[0]
        if np.abs(orbit.section - state).max(axis=1).min() > _NEAR:
            continue
        there = periodic_orbit(family, orbit.value, state, orbit.period).orbit
        if there is not None and np.abs(orbit.section - there.section[0]).max(axis=1).min() <= _SAME_STATE:
            return True
    return False


class _Forest:
    """Branches found so far."""

    def __init__(self, family: Family, limits: Limits, largest_period: int) -> None:
        self.family, self.limits, self.largest_period = family, limits, largest_period
        self.branches: list[Branch] = []

    def plant(self, seed: Seed, parent: int = NO_PARENT) -> None:
        """Add the branch a seed leads to, unless it is known or there is none."""
        orbit = periodic_orbit(self.family, seed.value, seed.state, seed.period).orbit
        if orbit is None:
            return
        shortest = minimal_period(orbit)
        if shortest < orbit.period:
            orbit = periodic_orbit(self.family, seed.value, orbit.section[0], shortest).orbit
        if orbit is None or orbit.period > self.largest_period:
            return
        if not any(holds(self.family, branch, orbit) for branch in self.branches):
            self.add(follow(self.family, orbit, self.limits), parent)

    def add(self, branch: Branch, parent: int) -> None:
        """Add a branch, then those that its doublings give rise to, then that of half its period."""
        index = len(self.branches)
        self.branches.append(branch._replace(parent=parent))
        for node in branch.nodes:
            doubles = node.special == PERIOD_DOUBLING and 2 * branch.period <= self.largest_period
            if doubles and not any(_ends_at(other, node.orbit) for other in self.branches):
                child = follow_doubled(self.family, node.orbit, self.limits)
                if len(child.nodes) > 1:
                    self.add(child, index)
        for end in (branch.start, branch.end):
            if end.reason == HALVED:
                self.plant(Seed(end.orbit.value, tuple(end.orbit.section[0]), branch.period // 2), index)


def _ends_at(branch: Branch, doubling: Orbit) -> bool:
    """Whether a branch of twice the period ends at a period doubling."""
    if branch.period != 2 * doubling.period:
        return False
    for end in (branch.start, branch.end):
        if end.reason == HALVED and abs(end.orbit.value - doubling.value) <= _SAME_VALUE:
            apart = np.abs(doubling.section - end.orbit.section[0]).max(axis=1).min()
            if apart <= 100 * _SAME_STATE:
                return True
    return False
