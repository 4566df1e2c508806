"""Where a function of the orbit vanishes between two points of a branch."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.optimize import brentq, newton

from gearwear.orbits.codes import PERIOD_DOUBLING
from gearwear.orbits.curve import Curve, Point
from gearwear.orbits.newton import Orbit, periodic_orbit, twice
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
    length = np.linalg.norm(chord)
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
    a multiplier of -1: the secant method over the parameter finds that.
    """
    half = curve.period // 2
    section = near.orbit.section
    found = {"state": (section[0] + section[half]) / 2}

    def margin(share: float) -> float:
        orbit = periodic_orbit(curve.family, curve.value(share), found["state"], half).orbit
        if orbit is None:
            raise _Lost
        found["state"], found["orbit"] = orbit.section[0], orbit
        return margins(orbit.matrix)[PERIOD_DOUBLING - 1]

    try:
        share = newton(margin, near.place[2], tol=_PARAMETER_ACCURACY, maxiter=_MOST_STEPS)
        margin(share)
    except (_Lost, ValueError, RuntimeError):
        return None
    return curve.point(twice(found["orbit"]))
