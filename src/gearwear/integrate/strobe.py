"""Motion of an oscillator over whole forcing periods: the one interface between analyses and integrators.

An oscillator that repeats after some mesh periods is carried by the tabulated affine map (affine_flow), to round-off.
With a torque that does not it is integrated by Dormand-Prince (period_flow), to the tolerance. A translational
oscillator is carried by power series (series_flow), to round-off, whatever the backend.

Mesh phase 0 begins a period; the state there is the one after the jump a tabulated transmission error may have.
A motion that cannot be carried on is reported by a status, never by an exception, and the rest of it is NaN.
"""

from collections.abc import Callable
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from gearwear.integrate.affine import affine_flow, affine_table
from gearwear.integrate.status import FORCE, GROWTH, HIGHEST, IMPACTS, LOST, LOWEST, MAPS, RECORDS, STATES
from gearwear.oscillator.oscillator import Oscillator
from gearwear.oscillator.translational import TranslationalOscillator

AUTOMATIC, GENERAL = "automatic", "general"


# None unless the detail asks for it: who asked need not look.
Asked = np.ndarray | Any


class Strobe(NamedTuple):
    """Motion seen once per forcing period, at mesh phase 0; lengths in units of b0, times dimensionless.

    What the detail does not ask for is None: growth and tangent need GROWTH, tangent_maps MAPS, what happens within
    a period RECORDS.

    states : (periods + 1, size) displacement and velocity of the mesh, then the rest of the state; the start first
    growth : (periods,) logarithm of the growth of the tangent vector
    lost : (periods,) share of the period out of contact, |x| < b
    impacts : (periods,) number of entries into contact
    displacement_min, displacement_max : (periods,) extremes of x
    force_max : (periods,) largest magnitude of the mesh force k f
    tangent_maps : (periods, size, size) derivative of the one-period map; its determinant is Oscillator.contraction
    tangent : (size,) tangent vector at the end, of length 1
    status : COMPLETED, BLOW_UP or TOO_MANY_STEPS
    """

    states: np.ndarray
    growth: Asked
    lost: Asked
    impacts: Asked
    displacement_min: Asked
    displacement_max: Asked
    force_max: Asked
    tangent_maps: Asked
    tangent: Asked
    status: int


def strobe(
    oscillator: Oscillator,
    state,
    periods: int,
    first_period: int = 0,
    tolerance: float = 1e-10,
    tangent=(1.0, 0.0),
    detail: int = RECORDS,
    backend: str = AUTOMATIC,
    detect_cycles: bool = False,
) -> Strobe:
    """Run whole forcing periods from a state at mesh phase 0.

    Parameters
    ----------
    state : (size,) displacement and velocity, then the rest of the state; (2,), the rest of it is zero
    periods : number of forcing periods
    first_period : index of the first one; it sets the phase of the external torque
    tolerance : relative (and for values below 1 absolute) tolerance of Dormand-Prince, 1e-13 to 1e-3; the affine
        map needs none
    tangent : as the state, tangent vector whose growth is measured, any length but 0
    detail : STATES, GROWTH, MAPS or RECORDS; each holds the ones before it and takes longer, the states are the same
    backend : AUTOMATIC, or GENERAL for Dormand-Prince in any case
    detect_cycles : stop as soon as the state recurs to the last bit and fill in the rest: the same in less time, but
        for the round-off of growth and tangent with GROWTH. Not with a torque at another frequency

    Raises
    ------
    ValueError
        For a state or tangent that is not as many finite numbers, or a number outside its range.
    """
    state, tangent = vector(state, "state", oscillator.size), vector(tangent, "tangent", oscillator.size)
    check_request(tangent, periods, first_period, tolerance, detail, backend)
    run = _recent_integrator(oscillator, tolerance, backend)
    states, maps, growth, records, _, direction, status = run(
        state, tangent, int(first_period), int(periods), detail, detect_cycles
    )
    return collected(oscillator.period, states, maps, growth, records, direction, status, detail)


def trace(
    oscillator: Oscillator,
    state,
    phases,
    periods: int,
    first_period: int = 0,
    tolerance: float = 1e-10,
    backend: str = AUTOMATIC,
) -> tuple[np.ndarray, np.ndarray]:
    """Displacement and velocity, (periods, len(phases)), at mesh phases of each period, as `visited` has them."""
    states = visited(oscillator, state, phases, periods, first_period, tolerance, backend)
    return states[:, :, 0], states[:, :, 1]


def visited(
    oscillator: Oscillator,
    state,
    phases,
    periods: int,
    first_period: int = 0,
    tolerance: float = 1e-10,
    backend: str = AUTOMATIC,
) -> np.ndarray:
    """States, (periods, len(phases), size), at mesh phases of each period, reached by stepping.

    The phases increase within [0, 1]; phase 1 is phase 0 of the next period. The errors raised are those of strobe.
    """
    phases = np.array(phases, dtype=float)
    if phases.ndim != 1 or not np.all((phases >= 0.0) & (phases <= 1.0)) or np.any(np.diff(phases) <= 0.0):
        raise ValueError("phases: must be one strictly increasing list within [0, 1] (mesh phase)")
    state, tangent = vector(state, "state", oscillator.size), np.eye(oscillator.size)[0]
    check_request(tangent, periods, first_period, tolerance, STATES, backend)
    run = _recent_integrator(oscillator, tolerance, backend, tuple(phases.tolist()))
    return run(state, tangent, int(first_period), int(periods), STATES, False)[4]


def monodromy(
    oscillator: Oscillator,
    state,
    periods: int,
    first_period: int = 0,
    tolerance: float = 1e-10,
    backend: str = AUTOMATIC,
) -> tuple[np.ndarray, np.ndarray]:
    """State after some periods and its (size, size) derivative by the state before them; errors as strobe."""
    motion = strobe(oscillator, state, periods, first_period, tolerance, detail=MAPS, backend=backend)
    matrix = np.eye(oscillator.size)
    for tangent_map in motion.tangent_maps:
        matrix = tangent_map @ matrix
    return motion.states[-1], matrix


def vector(values, name: str, size: int = 2, points: tuple[int, ...] = ()) -> np.ndarray:
    """The values as finite numbers, (*points, size); two of them, displacement and velocity, are filled up with zeros.

    ValueError if they are anything else. Without the leading axis they are those of every point.
    """
    numbers = np.array(values, dtype=float)
    if numbers.shape == (*points, size) and np.isfinite(numbers).all():
        return numbers
    allowed = [(*lead, length) for lead in {(), points} for length in {2, size}]
    if numbers.shape not in allowed or not np.all(np.isfinite(numbers)):
        count = "two finite numbers" if size == 2 else f"two or {size} finite numbers"
        each = f", or ({points[0]}, ...) of them, one row a point" if points else ""
        raise ValueError(f"{name}: must be {count}{each}, displacement and velocity first (dimensionless)")
    filled = np.zeros((*points, size))
    filled[..., : numbers.shape[-1]] = numbers
    return filled


def check_request(tangent, periods, first_period, tolerance, detail, backend) -> None:
    """ValueError for a number outside its range or a tangent without direction."""
    if not np.any(tangent):
        raise ValueError("tangent: the zero vector has no direction; give a vector of any other length")
    for name, count in (("periods", periods), ("first_period", first_period)):
        if int(count) != count or count < 0:
            raise ValueError(f"{name}: {count} (forcing periods) must be a whole number, 0 or more")
    if not 1e-13 <= tolerance <= 1e-3:
        raise ValueError(f"tolerance: {tolerance} (relative) must be within 1e-13 and 1e-3")
    if detail not in (STATES, GROWTH, MAPS, RECORDS):
        raise ValueError(f"detail: {detail} must be one of STATES, GROWTH, MAPS and RECORDS, 0 to 3")
    if backend not in (AUTOMATIC, GENERAL):
        raise ValueError(f"backend: {backend!r} must be {AUTOMATIC!r} or {GENERAL!r}")


def stored(detail: int, detect_cycles: bool) -> int:
    """Detail to run with: an early end carries the tangent vector on through the maps."""
    return MAPS if detect_cycles and detail == GROWTH else detail


def integrator(
    oscillator: Oscillator, tolerance: float = 1e-10, backend: str = AUTOMATIC, phases: tuple[float, ...] = ()
) -> Callable[..., tuple]:
    """Return the function that runs one oscillator, with all that does not depend on the state made ready.

    Its arguments, which it does not check, are state, tangent, first_period, periods, detail and detect_cycles, as of
    strobe. It returns the arrays states, maps, growth, records and visits of a kernel, the tangent at the end, and the
    status.

    Parameters
    ----------
    tolerance, backend : as of strobe
    phases : of mesh periods at which the states of `visits` are noted, as of visited
    """
    if isinstance(oscillator, TranslationalOscillator):
        return _series(oscillator, phases)
    table = None if backend == GENERAL else affine_table.affine_table(oscillator, phases)
    return _general(oscillator, tolerance, phases) if table is None else _affine(table, phases)


_recent_integrator = lru_cache(maxsize=8)(integrator)


def _affine(table: affine_table.AffineTable, phases: tuple[float, ...]) -> Callable[..., tuple]:
    rows, slack = table
    stops = np.searchsorted(rows[0, :, affine_table.COMMON, affine_table.START], phases).astype(np.int64)

    def run(state, tangent, first_period, periods, detail, detect_cycles):
        direction = tangent / np.hypot(*tangent)
        detects, with_detail = detect_cycles and len(rows) == 1, stored(detail, detect_cycles)
        *arrays, status = affine_flow.run(
            rows, slack, state, direction, first_period, periods, with_detail, stops, detects
        )
        return *arrays, direction, status

    return run


def _general(oscillator: Oscillator, tolerance: float, phases: tuple[float, ...]) -> Callable[..., tuple]:
    from gearwear.integrate.dormand_prince import period_flow  # most runs need one integrator only

    stops = np.array(phases, dtype=float)

    def run(state, tangent, first_period, periods, detail, detect_cycles):
        direction = tangent.copy()
        *arrays, status = period_flow.run(
            *oscillator.coefficients, state, direction, first_period, periods, float(tolerance), stops
        )
        return *arrays, direction, int(status)

    return run


def _series(oscillator: TranslationalOscillator, phases: tuple[float, ...]) -> Callable[..., tuple]:
    from gearwear.integrate.taylor import series_flow
    from gearwear.integrate.taylor.series_table import series_table

    starts, *table = series_table(oscillator, phases)
    stops = np.searchsorted(starts, phases).astype(np.int64)
    linear, ratio = tuple(oscillator.linear_part), oscillator.torque.frequency_ratio

    def run(state, tangent, first_period, periods, detail, detect_cycles):
        direction = tangent / np.linalg.norm(tangent)
        *arrays, status = series_flow.run(
            linear, tuple(table), ratio, state, direction, first_period, periods, detail, stops
        )
        return *arrays, direction, status

    return run


def collected(period, states, maps, growth, records, tangent, status, detail) -> Strobe:
    """The arrays of a kernel as a Strobe with no more than the detail asks for; a leading axis of points may be there.

    records : (..., periods, columns), the columns those of status; period : () or (points, 1)
    """
    if detail < RECORDS:
        lost = impacts = lowest = highest = force = None
    else:
        lost = np.clip(records[..., LOST] / period, 0.0, 1.0)
        impacts, force = records[..., IMPACTS], records[..., FORCE]
        lowest, highest = records[..., LOWEST], records[..., HIGHEST]
    return Strobe(
        states=states,
        growth=growth if detail >= GROWTH else None,
        lost=lost,
        impacts=impacts,
        displacement_min=lowest,
        displacement_max=highest,
        force_max=force,
        tangent_maps=maps if detail >= MAPS else None,
        tangent=tangent if detail >= GROWTH else None,
        status=status,
    )
