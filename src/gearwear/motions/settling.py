"""The motions that oscillators settle to."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from gearwear.codes import motion_class
from gearwear.errors import Infeasible
from gearwear.integrate.status import BLOW_UP, COMPLETED, GROWTH, MAPS, RECORDS, TOO_MANY_STEPS
from gearwear.integrate.strobe import AUTOMATIC, Strobe, vector
from gearwear.integrate.strobe_many import strobe_many
from gearwear.motions.classify import Classification, classify
from gearwear.motions.section import BATCHES
from gearwear.oscillator.oscillator import Oscillator

_LEAST_CONTRACTION = 1e-6  # below, round-off of the largest multipliers outweighs the determinant of a large map


class Settling(NamedTuple):
    """How long to wait and what to accept; the fields are those of the section ``settling`` of the configuration.

    Periods are forcing periods; ``recurrence_tolerance`` is a length over b0, ``chaos_threshold`` an exponent per
    unit of dimensionless time; ``early_end`` is `detect_cycles` of strobe.strobe.
    """

    transient_periods: int
    longest_transient: int
    sampled_periods: int
    largest_period: int
    recurrence_tolerance: float
    chaos_threshold: float
    early_end: bool = False


class Attractor(NamedTuple):
    """One settled motion; NaN and 0 stand for what the detail asked for leaves out, or what was not reached.

    motion_class, ..., exponent_error : as in classify.Classification
    multiplier_real, multiplier_imag : Floquet multiplier of largest modulus over the orbit, NaN without an orbit
    determinant_error : largest relative departure of a sampled period's determinant from Oscillator.contraction; NaN
        where that is too small for it
    transient_periods : forcing periods before the sample
    contact_loss_share, impacts_per_period : means over the sample
    displacement_min, displacement_max, force_max : extremes over the sample
    displacement, velocity : (sampled_periods,) the section at mesh phase 0
    end : (size,) the state at the end of the sample, where the motion can be taken up again
    """

    motion_class: int
    reason: int
    conflict: int
    period: int
    recurrence_period: int
    recurrence_distance: float
    stable_orbit_period: int
    stable_orbit_distance: float
    exponent: float
    exponent_error: float
    multiplier_real: float
    multiplier_imag: float
    determinant_error: float
    transient_periods: int
    contact_loss_share: float
    impacts_per_period: float
    displacement_min: float
    displacement_max: float
    force_max: float
    displacement: np.ndarray
    velocity: np.ndarray
    end: np.ndarray


def settle(
    oscillator: Oscillator, state: Sequence[float] | np.ndarray, settling: Settling, tolerance: float = 1e-10
) -> Attractor:
    """Return the motion one oscillator settles to from a state, as settle_many with all its detail does."""
    return settle_many([oscillator], state, settling, tolerance)[0]


def settle_many(
    oscillators: list[Oscillator],
    states: Sequence[Any] | np.ndarray,
    settling: Settling,
    tolerance: float = 1e-10,
    detail: int = RECORDS,
    backend: str = AUTOMATIC,
) -> list[Attractor]:
    """Run every oscillator until its motion is clearly periodic, quasi-periodic or chaotic, or the time is over.

    Between two looks the transient doubles; the exponent is the mean over all the periods since the last look, so
    that a weak one grows clear. A motion that blows up or needs too many steps has not converged, for that reason;
    what is not known is NaN. No point depends on the others.

    Parameters
    ----------
    oscillators : one a point
    states : (points, size) or (size,) at mesh phase 0, as in strobe_many.strobe_many
    tolerance : of the integrator, where the affine map does not apply
    detail : GROWTH, MAPS or RECORDS, of strobe.strobe. The determinant needs MAPS, extremes, contact loss and impacts
        RECORDS, in several times the time of GROWTH.

    Raises
    ------
    Infeasible
        For states or settings outside their range.
    """
    check_settling(settling)
    points = len(oscillators)
    if not points:
        return []
    size = oscillators[0].size
    states = vector(states, "state", size, (points,))
    tangents = np.tile(np.eye(size)[0], (points, 1))
    attractors: dict[int, Attractor] = {}
    waiting, transient, reached = np.arange(points), settling.transient_periods, 0
    while waiting.size:
        own = [oscillators[p] for p in waiting]
        run = strobe_many(
            own,
            states[waiting],
            transient - reached,
            reached,
            tolerance,
            tangent=tangents[waiting],
            detail=GROWTH,
            backend=backend,
            detect_cycles=settling.early_end,
        )
        attractors |= _lost(waiting, run.status, transient, settling.sampled_periods, size)
        alive = np.flatnonzero(run.status == COMPLETED)
        if not alive.size:
            break
        waiting, own = waiting[alive], [own[i] for i in alive]
        begins, directions = run.states[alive, -1], run.tangent[alive]
        sample = strobe_many(
            own,
            begins,
            settling.sampled_periods,
            transient,
            tolerance,
            tangent=directions,
            detail=detail,
            backend=backend,
            detect_cycles=settling.early_end or detail >= MAPS,  # which changes no bit then
        )
        attractors |= _lost(waiting, sample.status, transient, settling.sampled_periods, size)
        undecided = []
        for place in np.flatnonzero(sample.status == COMPLETED):
            p, growth = waiting[place], sample.growth[place]
            if reached:
                growth = np.concatenate([run.growth[alive[place]], growth])
            found = classify(own[place], sample.states[place], growth, transient, settling, tolerance, backend)
            if found.motion_class == motion_class.NOT_CONVERGED and transient < settling.longest_transient:
                undecided.append(p)
                states[p], tangents[p] = sample.states[place, -1], sample.tangent[place]
            else:
                attractors[p] = _attractor(own[place], _point(sample, int(place)), found, transient)
        reached = transient + settling.sampled_periods
        transient = max(min(2 * transient, settling.longest_transient), reached)
        waiting = np.array(undecided, dtype=int)
    return [attractors[p] for p in range(points)]


def check_settling(settling: Settling) -> None:
    """ValueError for settings that contradict each other."""
    if not 0 <= settling.transient_periods <= settling.longest_transient:
        raise Infeasible(
            f"transient_periods: {settling.transient_periods} (forcing periods) must be within 0 and "
            f"longest_transient, {settling.longest_transient}"
        )
    if not 1 <= settling.largest_period <= motion_class.LARGEST_PERIOD:
        raise Infeasible(
            f"largest_period: {settling.largest_period} (forcing periods) must be within 1 and "
            f"{motion_class.LARGEST_PERIOD}"
        )
    least = max(2 * BATCHES, 4 * settling.largest_period)
    if settling.sampled_periods < least:
        raise Infeasible(
            f"sampled_periods: {settling.sampled_periods} (forcing periods) must be at least {least}, that is "
            f"{2 * BATCHES} and four times largest_period; sample longer or lower largest_period"
        )
    for name in ("recurrence_tolerance", "chaos_threshold"):
        if not getattr(settling, name) > 0.0:
            raise Infeasible(f"{name}: {getattr(settling, name)} (dimensionless) must be above 0")


def _point(many: Strobe, place: int) -> Strobe:
    """Return the run of one of many oscillators."""
    return Strobe._make(None if values is None else np.asarray(values)[place] for values in many)


def _attractor(oscillator: Oscillator, sample: Strobe, found: Classification, transient: int) -> Attractor:
    determinant_error = lost = impacts = lowest = highest = force = np.nan
    if sample.tangent_maps is not None:
        determinant_error = _determinant_error(oscillator, sample.tangent_maps)
    if sample.force_max is not None:
        lost, impacts = float(sample.lost.mean()), float(sample.impacts.mean())
        lowest, highest = float(sample.displacement_min.min()), float(sample.displacement_max.max())
        force = float(sample.force_max.max())
    evidence = found._asdict()
    multiplier = evidence.pop("multiplier")
    return Attractor(
        **evidence,
        multiplier_real=multiplier.real,
        multiplier_imag=multiplier.imag,
        determinant_error=determinant_error,
        transient_periods=transient,
        contact_loss_share=lost,
        impacts_per_period=impacts,
        displacement_min=lowest,
        displacement_max=highest,
        force_max=force,
        displacement=sample.states[1:, 0],
        velocity=sample.states[1:, 1],
        end=sample.states[-1],
    )


def _determinant_error(oscillator: Oscillator, maps: np.ndarray) -> float:
    if oscillator.size == 2:
        (a, b), (c, d) = maps.transpose(1, 2, 0)
        determinants = a * d - b * c
    elif oscillator.contraction < _LEAST_CONTRACTION:
        return np.nan
    else:
        determinants = np.linalg.det(maps)
    return float(np.abs(determinants / oscillator.contraction - 1).max())


def _lost(points: Any, status: Any, transient: int, samples: int, size: int) -> dict[int, Attractor]:
    """Return the points whose motion was not completed, and what is known of them."""
    unknown: dict[str, Any] = dict.fromkeys(Attractor._fields, np.nan)
    unknown.update(dict.fromkeys(("conflict", "period", "recurrence_period", "stable_orbit_period"), 0))
    unknown.update(
        motion_class=motion_class.NOT_CONVERGED,
        transient_periods=transient,
        displacement=np.full(samples, np.nan),
        velocity=np.full(samples, np.nan),
        end=np.full(size, np.nan),
    )
    reasons = {BLOW_UP: motion_class.BLOWN_UP, TOO_MANY_STEPS: motion_class.STEPS_EXHAUSTED}
    return {
        p: Attractor(**(unknown | {"reason": reasons[code]}))
        for p, code in zip(points, status, strict=True)
        if code != COMPLETED
    }
