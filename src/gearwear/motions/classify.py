"""The class of a settled motion, from a converged periodic orbit, the recurrence of the section and the exponent."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from gearwear.codes import motion_class
from gearwear.integrate.strobe import AUTOMATIC
from gearwear.motions.section import is_closed_curve, mean_and_error, recurrence, shrinking_periods
from gearwear.orbits.newton import Orbit, minimal_period, periodic_orbit
from gearwear.orbits.return_map import COARSEST, return_maps
from gearwear.oscillator.oscillator import Oscillator

if TYPE_CHECKING:
    from gearwear.motions.settling import Settling

_NEAR = 1e-3  # over b0: a section that comes closer still to a stable orbit is on its way there


class Classification(NamedTuple):
    """Class of a motion and the evidence for it.

    motion_class : code of motion_class.FLAG_VALUES
    reason : code of motion_class.REASON_VALUES; why a point has not converged
    conflict : code of motion_class.CONFLICT_VALUES; what speaks against the class
    period : in forcing periods, 0 if not periodic
    recurrence_period : that of the section alone, 0 if it does not recur
    recurrence_distance : largest change over one such period, or the least change over all periods looked for
    stable_orbit_period : that of the stable orbit that Newton's method finds from the section, 0 if there is none
    stable_orbit_distance : of the last of the section from that orbit, NaN without one
    multiplier : Floquet multiplier of largest modulus of that orbit, NaN without one
    exponent, exponent_error : largest Lyapunov exponent and its standard error
    """

    motion_class: int
    reason: int
    conflict: int
    period: int
    recurrence_period: int
    recurrence_distance: float
    stable_orbit_period: int
    stable_orbit_distance: float
    multiplier: complex
    exponent: float
    exponent_error: float


def classify(
    oscillator: Oscillator,
    states: np.ndarray,
    growth: np.ndarray,
    first_period: int,
    settling: Settling,
    tolerance: float,
    backend: str = AUTOMATIC,
) -> Classification:
    """Classify a motion by its section.

    Period n: Newton's method leads from the section to an orbit of that period whose multipliers are inside the unit
    circle, and the section recurs with it or comes closer to it still. Without such an orbit a section that recurs
    has the period of its recurrence, unless the orbit it is near is unstable: that motion is about to leave it.
    Chaos: no recurrence, also not at the end of the section, and an exponent above the threshold and three times its
    error. Quasi-periodic: the section is a closed curve over the phase of the external torque and the exponent is not
    positive; a torque that fluctuates with a harmonic of the mesh, or none, leaves one frequency, and then none is
    reported: the map of the torsional oscillator contracts areas by exp(-2 zeta T), so no invariant closed curve
    exists, and one of the translational oscillator would have no second phase to order its points by.

    Parameters
    ----------
    states : (samples + 1, size) at mesh phase 0
    growth : logarithms of the growth of a tangent vector over the last forcing periods
    first_period : index of the forcing period at which the section begins
    settling : of which largest_period, recurrence_tolerance and chaos_threshold are used
    tolerance, backend : of the integrator, as in strobe.strobe
    """
    largest_period, closeness = settling.largest_period, settling.recurrence_tolerance
    exponent, error = mean_and_error(growth / oscillator.period)
    found = recurrence(states, largest_period, closeness)
    candidates = [found.period] if found.period else shrinking_periods(states, largest_period, _NEAR)
    near, distance, stable = _orbit_near(oscillator, states, first_period, candidates, tolerance, backend)
    orbit = near if stable else None
    positive = exponent > max(settling.chaos_threshold, 3 * error)
    code, conflict = motion_class.NOT_CONVERGED, motion_class.AGREED
    if orbit is not None:
        code = orbit.period
        if found.period not in (0, code):
            conflict = motion_class.OTHER_PERIOD
    elif found.period:
        conflict = motion_class.NO_STABLE_ORBIT
        code = found.period if near is None else motion_class.NOT_CONVERGED
    elif positive and not recurrence(states[-2 * largest_period - 1 :], largest_period, closeness).period:
        code = motion_class.CHAOTIC
    elif oscillator.has_second_frequency and exponent <= 3 * error:
        turns = oscillator.torque.frequency_ratio * (first_period + np.arange(len(states)))
        if is_closed_curve(states, turns):
            code = motion_class.QUASI_PERIODIC
    period = code if 0 < code <= motion_class.LARGEST_PERIOD else 0
    if period and positive:
        conflict = motion_class.POSITIVE_EXPONENT
    reason = motion_class.SETTLED
    if code == motion_class.NOT_CONVERGED:
        slow = exponent <= 0.0 or found.period
        reason = motion_class.SLOW_CONVERGENCE if slow else motion_class.EXPONENT_UNCLEAR
    return Classification(
        motion_class=code,
        reason=reason,
        conflict=conflict,
        period=period,
        recurrence_period=found.period,
        recurrence_distance=found.distance,
        stable_orbit_period=0 if orbit is None else orbit.period,
        stable_orbit_distance=np.nan if orbit is None else distance,
        multiplier=complex(np.nan, np.nan) if orbit is None else complex(orbit.multipliers[0]),
        exponent=exponent,
        exponent_error=error,
    )


def _orbit_near(
    oscillator: Any, states: np.ndarray, first_period: int, candidates: Any, tolerance: float, backend: str
) -> tuple[Orbit | None, float, bool]:
    """Return an orbit the end of the section is near, its distance, and whether it is stable, if possible a stable one.

    Every candidate is a number of forcing periods; the seed is the last state at a whole number of them from period 0,
    where an external torque has its phase of period 0.
    """
    maps = return_maps(lambda _: oscillator, min(tolerance, COARSEST), backend)
    known: tuple[Orbit | None, float, bool] = None, np.nan, False
    for period in candidates:
        if not oscillator.torque.repeats_after(period):
            continue
        last = len(states) - 1 - (first_period + len(states) - 1) % period
        orbit = periodic_orbit(maps, oscillator.frequency, states[last], period).orbit
        if orbit is None:
            continue
        own = minimal_period(orbit)
        if own < period and oscillator.torque.repeats_after(own):
            orbit = periodic_orbit(maps, oscillator.frequency, orbit.section[0], own).orbit
        if orbit is None:
            continue
        distance = float(np.abs(orbit.section - states[last - orbit.period : last]).max())
        if distance <= _NEAR and orbit.stable:
            return orbit, distance, True
        if distance <= _NEAR and known[0] is None:
            known = orbit, distance, False
    return known
