"""The motion an oscillator settles to, its class and the evidence for it."""

from typing import NamedTuple

import numpy as np

from gearwear.attractors.section import BATCHES, is_closed_curve, mean_and_error, recurrence
from gearwear.dynamics import motion_class
from gearwear.dynamics.motion import BLOW_UP, COMPLETED, GROWTH, Strobe, monodromy, strobe
from gearwear.dynamics.oscillator import Oscillator


class Settling(NamedTuple):
    """How long to wait and what to accept; the fields are those of the section ``settling`` of the configuration.

    Periods are forcing periods; ``recurrence_tolerance`` is a length over b0, ``chaos_threshold`` an exponent per
    unit of dimensionless time.
    """

    transient_periods: int
    longest_transient: int
    sampled_periods: int
    largest_period: int
    recurrence_tolerance: float
    chaos_threshold: float


class Attractor(NamedTuple):
    """One settled point of a sweep.

    motion_class : code of motion_class.FLAG_VALUES
    reason : code of motion_class.REASON_VALUES; why a point has not converged
    period : in forcing periods, 0 if not periodic
    recurrence_distance : largest change over one period, or the least change over all periods looked for
    exponent, exponent_error : largest Lyapunov exponent and its standard error; the other is -2 zeta - exponent
    multiplier_real, multiplier_imag : Floquet multiplier of largest modulus over ``period``, NaN if not periodic
    determinant_error : largest relative departure of a sampled period's determinant from exp(-2 zeta T)
    transient_periods : forcing periods before the sample
    contact_loss_share, impacts_per_period : means over the sample
    displacement_min, displacement_max, force_max : extremes over the sample
    displacement, velocity : (sampled_periods,) the section at mesh phase 0
    """

    motion_class: int
    reason: int
    period: int
    recurrence_distance: float
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


class Verdict(NamedTuple):
    """Class of a sample and its evidence."""

    motion_class: int
    reason: int
    period: int
    distance: float
    exponent: float
    exponent_error: float
    multiplier: complex


def settle(oscillator: Oscillator, state, settling: Settling, tolerance: float = 1e-10) -> Attractor:
    """Run until the motion is clearly periodic, quasi-periodic or chaotic, or the longest transient is over.

    Between two looks the transient doubles; the exponent is the mean over all the periods since the last look, so
    that a weak one grows clear. A motion that blows up or needs too many steps has not converged, for
    that reason; its evidence is NaN.

    Parameters
    ----------
    state : (2,) displacement and velocity at mesh phase 0
    tolerance : of the integrator

    Raises
    ------
    ValueError
        For a state or settings outside their range.
    """
    check_settling(settling)
    transient, reached, tangent = settling.transient_periods, 0, (1.0, 0.0)
    while True:
        run = strobe(oscillator, state, transient - reached, reached, tolerance, tangent, detail=GROWTH)
        sample = run
        if run.status == COMPLETED:
            sample = strobe(oscillator, run.states[-1], settling.sampled_periods, transient, tolerance, run.tangent)
        if sample.status != COMPLETED:
            return _failed(sample.status, transient, settling.sampled_periods)
        growth = np.concatenate([run.growth, sample.growth]) if reached else sample.growth
        verdict = look(oscillator, sample, growth, transient, settling, tolerance)
        if verdict.motion_class != motion_class.NOT_CONVERGED or transient >= settling.longest_transient:
            return _attractor(oscillator, sample, verdict, transient)
        reached, state, tangent = transient + settling.sampled_periods, sample.states[-1], sample.tangent
        transient = max(min(2 * transient, settling.longest_transient), reached)


def check_settling(settling: Settling) -> None:
    """ValueError for settings that contradict each other."""
    if not 0 <= settling.transient_periods <= settling.longest_transient:
        raise ValueError(
            f"transient_periods: {settling.transient_periods} (forcing periods) must be within 0 and "
            f"longest_transient, {settling.longest_transient}"
        )
    if not 1 <= settling.largest_period <= motion_class.LARGEST_PERIOD:
        raise ValueError(
            f"largest_period: {settling.largest_period} (forcing periods) must be within 1 and "
            f"{motion_class.LARGEST_PERIOD}"
        )
    least = max(2 * BATCHES, 4 * settling.largest_period)
    if settling.sampled_periods < least:
        raise ValueError(
            f"sampled_periods: {settling.sampled_periods} (forcing periods) must be at least {least}, that is "
            f"{2 * BATCHES} and four times largest_period; sample longer or lower largest_period"
        )
    for name in ("recurrence_tolerance", "chaos_threshold"):
        if not getattr(settling, name) > 0.0:
            raise ValueError(f"{name}: {getattr(settling, name)} (dimensionless) must be above 0")


def look(
    oscillator: Oscillator,
    sample: Strobe,
    growth: np.ndarray,
    first_period: int,
    settling: Settling,
    tolerance: float,
) -> Verdict:
    """Classify a sample of the motion that begins at a period; growth is that of the periods up to its end.

    Period n: the section recurs and the multipliers over n periods are inside the unit circle. Chaos: no recurrence
    and an exponent above the threshold and three times its error. Quasi-periodic: the section is a closed curve over
    the phase of the external torque and the exponent is not positive; a torque that fluctuates with a harmonic of
    the mesh, or none, leaves one frequency, whose map contracts areas by exp(-2 zeta T): no invariant closed curve
    exists, and none is reported.
    """
    exponent, error = mean_and_error(growth / oscillator.period)
    found = recurrence(sample.states, settling.largest_period, settling.recurrence_tolerance)
    multiplier, code, period = complex(np.nan, np.nan), motion_class.NOT_CONVERGED, 0
    chaotic = exponent > max(settling.chaos_threshold, 3 * error)
    if found.period:
        end = first_period + settling.sampled_periods
        _, matrix = monodromy(oscillator, sample.states[-1], found.period, end, tolerance)
        multiplier = max(np.linalg.eigvals(matrix).astype(complex), key=lambda value: (abs(value), value.imag))
        if abs(multiplier) < 1.0:
            code = period = found.period
    elif chaotic:
        code = motion_class.CHAOTIC
    elif oscillator.has_second_frequency and exponent <= 3 * error:
        turns = oscillator.torque.frequency_ratio * (first_period + np.arange(len(sample.states)))
        if is_closed_curve(sample.states, turns):
            code = motion_class.QUASI_PERIODIC
    reason = motion_class.SETTLED
    if code == motion_class.NOT_CONVERGED:
        slow = exponent <= 0.0 or found.period
        reason = motion_class.SLOW_CONVERGENCE if slow else motion_class.EXPONENT_UNCLEAR
    return Verdict(code, reason, period, found.distance, exponent, error, multiplier)


def _attractor(oscillator: Oscillator, sample: Strobe, verdict: Verdict, transient: int) -> Attractor:
    maps = sample.tangent_maps
    determinants = maps[:, 0, 0] * maps[:, 1, 1] - maps[:, 0, 1] * maps[:, 1, 0]
    contraction = np.exp(-2 * oscillator.damping_ratio * oscillator.period)
    return Attractor(
        motion_class=verdict.motion_class,
        reason=verdict.reason,
        period=verdict.period,
        recurrence_distance=verdict.distance,
        exponent=verdict.exponent,
        exponent_error=verdict.exponent_error,
        multiplier_real=verdict.multiplier.real if verdict.period else np.nan,
        multiplier_imag=verdict.multiplier.imag if verdict.period else np.nan,
        determinant_error=float(np.abs(determinants / contraction - 1).max()),
        transient_periods=transient,
        contact_loss_share=float(sample.lost.mean()),
        impacts_per_period=float(sample.impacts.mean()),
        displacement_min=float(sample.displacement_min.min()),
        displacement_max=float(sample.displacement_max.max()),
        force_max=float(sample.force_max.max()),
        displacement=sample.states[1:, 0],
        velocity=sample.states[1:, 1],
    )


def _failed(status: int, transient: int, samples: int) -> Attractor:
    unknown = dict.fromkeys(Attractor._fields, np.nan)
    unknown.update(
        motion_class=motion_class.NOT_CONVERGED,
        reason=motion_class.BLOWN_UP if status == BLOW_UP else motion_class.STEPS_EXHAUSTED,
        period=0,
        transient_periods=transient,
        displacement=np.full(samples, np.nan),
        velocity=np.full(samples, np.nan),
    )
    return Attractor(**unknown)
