"""Periodic orbits by Newton's method with the exact monodromy matrix."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from gearwear.orbits.return_map import LOST, Family, Passage

FOUND, NOT_CONVERGED, MOTION_LOST, SINGULAR = range(4)
REASON_WORDS = {
    FOUND: "found",
    NOT_CONVERGED: "Newton's method does not converge",
    MOTION_LOST: LOST,
    SINGULAR: "a multiplier is 1: the orbit is not isolated or at a fold",
}
ACCURACY = 1e-10
_ROUGHNESS = 1e-8  # corrections below it that shrink no more are errors of the integrator
_MOST_STEPS = 40
_MOST_HALVINGS = 12
_SAME_POINT = 1e-6


class Orbit(NamedTuple):
    """Periodic orbit at one value of the parameter.

    value : of the parameter
    period : mesh periods after which it repeats
    section : (period, size) states at mesh phase 0, displacement and velocity first
    matrix : (size, size) monodromy matrix over the period, from the first point of the section
    """

    value: float
    period: int
    section: np.ndarray
    matrix: np.ndarray

    @property
    def multipliers(self) -> np.ndarray:
        """(size,) Floquet multipliers, the one of largest modulus first."""
        return multipliers(self.matrix)

    @property
    def stable(self) -> bool:
        """Whether all multipliers lie inside the unit circle."""
        return bool(abs(self.multipliers[0]) < 1.0)


class Attempt(NamedTuple):
    """What Newton's method came to.

    orbit : the orbit, None unless the reason is FOUND
    reason : a key of REASON_WORDS
    corrections : size of every correction
    """

    orbit: Orbit | None
    reason: int
    corrections: tuple[float, ...]


def multipliers(matrix: np.ndarray) -> np.ndarray:
    """Return the eigenvalues of a monodromy matrix, complex, that of largest modulus (then imaginary part) first."""
    values = np.linalg.eigvals(matrix).astype(complex)
    return np.array(sorted(values, key=lambda one: (-abs(one), -one.imag)))


def periodic_orbit(family: Family, value: float, state: Any, period: int, accuracy: float = ACCURACY) -> Attempt:
    """Return the orbit of a period to which damped Newton steps from a state lead.

    A step is halved until the residual shrinks. The orbit may have a shorter period: see `minimal_period`.

    Parameters
    ----------
    value : of the parameter of the family.
    state : (size,) at mesh phase 0.
    period : mesh periods.
    accuracy : size of the last correction; the error after it is the square of it, or that of the integrator.

    Raises
    ------
    ValueError
        For a state that is no list of finite numbers, an accuracy that is not positive, or a value or period that the
        family refuses.
    """
    state = np.array(state, dtype=float)
    if state.ndim != 1 or state.size < 2 or not np.isfinite(state).all():
        raise ValueError(f"state: {state} must be finite numbers, displacement and velocity first (dimensionless)")
    if not accuracy > 0.0:
        raise ValueError(f"accuracy: {accuracy} (dimensionless) must be above 0")
    return_map = family(value, period)
    corrections: list[float] = []
    passage = return_map(state)
    state = passage.section[0]
    for _ in range(_MOST_STEPS):
        if not np.isfinite(passage.matrix).all():
            return Attempt(None, MOTION_LOST, tuple(corrections))
        residual = passage.section[-1] - state
        try:
            full = np.linalg.solve(np.eye(state.size) - passage.matrix, residual)
        except np.linalg.LinAlgError:
            return Attempt(None, SINGULAR, tuple(corrections))
        done = has_settled(np.abs(full).max(), corrections[-1] if corrections else np.inf, accuracy)
        share = 1.0
        for _ in range(_MOST_HALVINGS):
            tried = return_map(state + share * full)
            left = tried.section[-1] - tried.section[0]
            if done or np.hypot.reduce(left) < (1 - 0.1 * share) * np.hypot.reduce(residual):
                break
            share /= 2
        else:
            return Attempt(None, NOT_CONVERGED, tuple(corrections))
        state, passage = tried.section[0], tried
        corrections.append(float(share * np.abs(full).max()))
        if done:
            return Attempt(orbit_of(value, passage), FOUND, tuple(corrections))
    return Attempt(None, NOT_CONVERGED, tuple(corrections))


def has_settled(size: float, last: float, accuracy: float = ACCURACY) -> bool:
    """Whether a correction of some size ends the iteration, given the one before it."""
    return bool(size <= accuracy or (size <= _ROUGHNESS and size > 0.5 * last))


def orbit_of(value: float, passage: Passage) -> Orbit:
    """Return the orbit of a passage that ends where it began."""
    return Orbit(float(value), len(passage.section) - 1, passage.section[:-1], passage.matrix)


def twice(orbit: Orbit) -> Orbit:
    """Return an orbit as one of twice its period."""
    section = np.concatenate([orbit.section, orbit.section])
    return Orbit(orbit.value, 2 * orbit.period, section, orbit.matrix @ orbit.matrix)


def minimal_period(orbit: Orbit, distance: float = _SAME_POINT) -> int:
    """Return the least number of mesh periods after which the orbit repeats; `distance` counts as the same point."""
    for n in range(1, orbit.period):
        if orbit.period % n == 0 and np.abs(np.roll(orbit.section, -n, axis=0) - orbit.section).max() <= distance:
            return n
    return orbit.period
