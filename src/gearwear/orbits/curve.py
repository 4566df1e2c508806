"""Points of a branch: orbits of one period whose state and parameter are both unknown.

A point is (displacement, velocity, share), share being the parameter's place in its range, 0 to 1; a length along
the branch is measured in these three. The two equations of the orbit and one plane make the point unique, also at a
fold, where the parameter alone does not (Keller, 1977).

The derivative of the map by the parameter is a central difference. It stands in the matrix of Newton's method and in
the tangent only, never in a residual or a test function: its error slows the convergence and moves no result. That
leaves the parameter free, anything that makes an oscillator, where a variational equation would need its own forcing
for each.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwear.orbits.newton import Orbit, has_settled, orbit_of
from gearwear.orbits.return_map import LOST, Family

_MOST_STEPS = 12
_SLOW = 0.1  # ratio of two corrections above which the derivative by the parameter is taken anew
_DIFFERENCE, _LEAST_DIFFERENCE = 1e-5, 1e-9  # of the range
_SHARE_OF_STEP = 0.1
_LARGEST_CHANGE = 1e-3  # of the state by a difference: unstable orbits of long period are very sensitive
_UNIT = np.eye(2)
ALONG_PARAMETER = np.array([0.0, 0.0, 1.0])


class Point(NamedTuple):
    """An orbit and its place: (displacement, velocity, share)."""

    place: np.ndarray
    orbit: Orbit


class Trial(NamedTuple):
    """Outcome of a correction: the point or, without one, why; and the number of Newton steps."""

    point: Point | None
    trouble: str
    steps: int


class Curve:
    """Orbits of one period over the range of a parameter.

    Parameters
    ----------
    family : maps by parameter and period.
    period : mesh periods.
    first, last : range of the parameter.
    """

    def __init__(self, family: Family, period: int, first: float, last: float) -> None:
        self.family, self.period, self.first, self.last = family, period, first, last

    def value(self, share: float) -> float:
        """Return the parameter at a share of its range, its ends exactly."""
        return self.last if share == 1.0 else self.first + share * (self.last - self.first)

    def point(self, orbit: Orbit) -> Point:
        """Return the place of an orbit."""
        share = (orbit.value - self.first) / (self.last - self.first)
        return Point(np.array([*orbit.section[0], share]), orbit)

    def slope(self, place: np.ndarray, reach: float = np.inf) -> tuple[np.ndarray | None, str]:
        """Return the derivative of the map, (2,), by the share of the parameter or, without one, why.

        The difference taken is small beside the `reach` of a step: no grazing contact that the step does not meet
        spoils it. No value outside the range is tried.
        """
        difference, change = max(min(_DIFFERENCE, _SHARE_OF_STEP * reach), _LEAST_DIFFERENCE), np.full(2, np.inf)
        while np.abs(change).max() > _LARGEST_CHANGE and difference >= _LEAST_DIFFERENCE:
            if np.isfinite(change).all():
                difference *= 0.5 * _LARGEST_CHANGE / np.abs(change).max()
            middle = min(max(place[2], difference), 1 - difference)
            try:
                low, high = (
                    self.family(self.value(share), self.period)(place[:2]).section[-1]
                    for share in (middle - difference, middle + difference)
                )
            except ValueError as error:
                return None, str(error)
            change = high - low
        slope = change / (2 * difference)
        return (slope, "") if np.isfinite(slope).all() else (None, LOST)

    def tangent(self, point: Point, slope: np.ndarray, forward: np.ndarray) -> np.ndarray:
        """Return the unit tangent (3,) of the branch on the side of the direction `forward`."""
        tangent = np.linalg.svd(np.column_stack([point.orbit.matrix - _UNIT, slope]))[2][2]
        return -tangent if tangent @ forward < 0 else tangent

    def correct(
        self, guess: np.ndarray, normal: np.ndarray, slope: np.ndarray | None = None, reach: float = np.inf
    ) -> Trial:
        """Return the point of the branch in the plane through a guess, by Newton's method.

        Parameters
        ----------
        guess : (3,) place.
        normal : (3,) of the plane.
        slope : derivative by the share near the guess; taken anew if None or where the convergence is slow.
        reach : length of the step that led to the guess.
        """
        place, last, settled = np.array(guess), np.inf, False
        for steps in range(1, _MOST_STEPS + 1):
            try:
                passage = self.family(self.value(place[2]), self.period)(place[:2])
            except ValueError as error:
                return Trial(None, str(error), steps)
            if not np.isfinite(passage.matrix).all():
                return Trial(None, LOST, steps)
            if settled:
                return Trial(Point(place, orbit_of(self.value(place[2]), passage)), "", steps)
            if slope is None:
                slope, trouble = self.slope(place, reach)
                if slope is None:
                    return Trial(None, trouble, steps)
            matrix, residual = np.empty((3, 3)), np.empty(3)
            matrix[:2, :2], matrix[:2, 2], matrix[2] = passage.matrix - _UNIT, slope, normal
            residual[:2], residual[2] = passage.section[-1] - place[:2], normal @ (place - guess)
            try:
                correction = -np.linalg.solve(matrix, residual)
            except np.linalg.LinAlgError:
                return Trial(None, "two branches meet", steps)
            size = np.abs(correction).max()
            settled = has_settled(size, last)
            if size > 2 * last and not settled:
                break
            slope = None if size > _SLOW * last else slope
            place, last = place + correction, size
        return Trial(None, "Newton's method does not converge", steps)
