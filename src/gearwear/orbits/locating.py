"""Where a function of the orbit vanishes between two points of a branch."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.optimize import brentq, newton

from gearwear.codes.branch_codes import PERIOD_DOUBLING
from gearwear.orbits.curve import Curve, Point
from gearwear.orbits.newton import Orbit, periodic_orbit, twice
from gearwear.orbits.return_map import Family
from gearwear.orbits.special_points import margins

_PARAMETER_ACCURACY = 1e-10
_MOST_STEPS = 60


class _Lost(Exception):
    """A point of the chord leads to no orbit."""


def locate(curve: Curve, before: Point, after: Point, function: Callable[[Orbit], float]) -> Point | None:
    """Return the point between two others where a function that changes its sign vanishes, None if it is lost.

    Brent's method along the chord; every point on the way is corrected in the plane across the chord. The parameter
    is found to 1e-10 as far as the integrator allows.
    """
    chord = after.place - before.place
    length = float(np.linalg.norm(chord))
    known = {0.0: before, 1.0: after}

    def at(share: float) -> float:
        if share not in known:
            trial = curve.correct(before.place + share * chord, chord / length, reach=length)
            if trial.point is None:
                raise _Lost
            known[share] = trial.point
        return function(known[share].orbit)

    accuracy = _PARAMETER_ACCURACY / max(abs(curve.last - curve.first), 1.0) / max(length, 1e-3)
    try:
        root = brentq(at, 0.0, 1.0, xtol=accuracy, maxiter=_MOST_STEPS, disp=False)
        at(root)
    except _Lost:
        return None
    return known[root]


def locate_half_period(curve: Curve, near: Point) -> Point | None:
    """Return the point close to another where the orbit has half the period, None if it is lost.

    It is a branch point, where the equations of the branch are singular, but a regular orbit of half the period with
    a multiplier of -1.
    """
    half = curve.period // 2
    section = near.orbit.section
    orbit = doubling_near(curve.family, near.orbit.value, (section[0] + section[half]) / 2, half)
    return None if orbit is None else curve.point(twice(orbit))


def doubling_near(family: Family, value: float, state: np.ndarray, period: int) -> Orbit | None:
    """Return the orbit with a multiplier of -1 next to an orbit of about this value and state, None if it is lost.

    The secant method over the parameter, to 1e-10; every orbit on the way starts Newton's method for the next.
    """
    last: Orbit | None = None

    def margin(at: float) -> float:
        nonlocal last
        orbit = periodic_orbit(family, at, state if last is None else last.section[0], period).orbit
        if orbit is None:
            raise _Lost
        last = orbit
        return margins(orbit.matrix)[PERIOD_DOUBLING - 1]

    try:
        margin(newton(margin, value, tol=_PARAMETER_ACCURACY, maxiter=_MOST_STEPS))
    except (_Lost, ValueError, RuntimeError):
        return None
    return last
