"""Motion of an oscillator over whole forcing periods: the one interface between analyses and integrators.

Mesh phase 0 begins a period; the state there is the one after the jump a tabulated transmission error may have.
A motion that cannot be carried on is reported by a status, never by an exception, and the rest of it is NaN.
"""

from typing import NamedTuple

import numpy as np

from gearwear.dynamics import period_flow
from gearwear.dynamics.oscillator import Oscillator

COMPLETED, BLOW_UP, TOO_MANY_STEPS = period_flow.COMPLETED, period_flow.BLOW_UP, period_flow.TOO_MANY_STEPS


class Strobe(NamedTuple):
    """Motion seen once per forcing period, at mesh phase 0; lengths in units of b0, times dimensionless.

    states : (periods + 1, 2) displacement and velocity, the start first
    growth : (periods,) logarithm of the growth of the tangent vector
    lost : (periods,) share of the period out of contact, |x| < b
    impacts : (periods,) number of entries into contact
    displacement_min, displacement_max : (periods,) extremes of x
    force_max : (periods,) largest magnitude of the mesh force k f
    tangent_maps : (periods, 2, 2) derivative of the one-period map; determinant exp(-2 zeta T)
    tangent : (2,) tangent vector at the end, of length 1
    status : COMPLETED, BLOW_UP or TOO_MANY_STEPS
    """

    states: np.ndarray
    growth: np.ndarray
    lost: np.ndarray
    impacts: np.ndarray
    displacement_min: np.ndarray
    displacement_max: np.ndarray
    force_max: np.ndarray
    tangent_maps: np.ndarray
    tangent: np.ndarray
    status: int


def strobe(
    oscillator: Oscillator, state, periods: int, first_period: int = 0, tolerance: float = 1e-10, tangent=(1.0, 0.0)
) -> Strobe:
    """Run whole forcing periods from a state at mesh phase 0.

    Parameters
    ----------
    state : (2,) displacement and velocity
    periods : number of forcing periods
    first_period : index of the first one; it sets the phase of the external torque
    tolerance : relative (and for values below 1 absolute) tolerance of the integrator, 1e-13 to 1e-3
    tangent : (2,) tangent vector whose growth is measured, any length but 0

    Raises
    ------
    ValueError
        For a state or tangent that is not two finite numbers, or a number outside its range.
    """
    return _strobe(oscillator, state, periods, first_period, tolerance, tangent, ())[0]


def trace(
    oscillator: Oscillator, state, phases, periods: int, first_period: int = 0, tolerance: float = 1e-10
) -> tuple[np.ndarray, np.ndarray]:
    """Displacement and velocity, (periods, len(phases)), at mesh phases of each period, reached by stepping.

    The phases increase within [0, 1]; phase 1 is phase 0 of the next period. The errors raised are those of strobe.
    """
    phases = np.array(phases, dtype=float)
    if phases.ndim != 1 or not np.all((phases >= 0.0) & (phases <= 1.0)) or np.any(np.diff(phases) <= 0.0):
        raise ValueError("phases: must be one strictly increasing list within [0, 1] (mesh phase)")
    visits = _strobe(oscillator, state, periods, first_period, tolerance, (1.0, 0.0), phases)[1]
    return visits[:, :, 0], visits[:, :, 1]


def monodromy(
    oscillator: Oscillator, state, periods: int, first_period: int = 0, tolerance: float = 1e-10
) -> tuple[np.ndarray, np.ndarray]:
    """State after some periods and its (2, 2) derivative by the state before them; errors as strobe."""
    motion = strobe(oscillator, state, periods, first_period, tolerance)
    matrix = np.eye(2)
    for tangent_map in motion.tangent_maps:
        matrix = tangent_map @ matrix
    return motion.states[-1], matrix


def _strobe(oscillator, state, periods, first_period, tolerance, tangent, phases):
    state, tangent = _pair(state, "state"), _pair(tangent, "tangent")
    if not np.any(tangent):
        raise ValueError("tangent: the zero vector has no direction; give a vector of any other length")
    for name, count in (("periods", periods), ("first_period", first_period)):
        if int(count) != count or count < 0:
            raise ValueError(f"{name}: {count} (forcing periods) must be a whole number, 0 or more")
    if not 1e-13 <= tolerance <= 1e-3:
        raise ValueError(f"tolerance: {tolerance} (relative) must be within 1e-13 and 1e-3")
    states, maps, growth, records, visits, status = period_flow.run(
        *oscillator.coefficients,
        state,
        tangent,
        int(first_period),
        int(periods),
        float(tolerance),
        np.array(phases, dtype=float),
    )
    motion = Strobe(
        states=states,
        growth=growth,
        lost=np.clip(records[:, period_flow.LOST] / oscillator.period, 0.0, 1.0),
        impacts=records[:, period_flow.IMPACTS],
        displacement_min=records[:, period_flow.LOWEST],
        displacement_max=records[:, period_flow.HIGHEST],
        force_max=records[:, period_flow.FORCE],
        tangent_maps=maps,
        tangent=tangent,
        status=int(status),
    )
    return motion, visits


def _pair(values, name: str) -> np.ndarray:
    pair = np.array(values, dtype=float)
    if pair.shape != (2,) or not np.all(np.isfinite(pair)):
        raise ValueError(f"{name}: {values} must be two finite numbers, displacement and velocity (dimensionless)")
    return pair
