"""What becomes of many initial states of one oscillator."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from gearwear.codes.motion_class import CHAOTIC, NOT_CONVERGED, QUASI_PERIODIC
from gearwear.integrate.status import COMPLETED, GROWTH, STATES
from gearwear.integrate.strobe import vector
from gearwear.integrate.strobe_many import strobe_many
from gearwear.motions.section import BATCHES, is_closed_curve, means_and_errors, recurrences
from gearwear.motions.settling import Settling, check_settling
from gearwear.oscillator.oscillator import Oscillator

_TOGETHER = 1024  # states run at a time, for the memory they take


class Destinations(NamedTuple):
    """Where initial states lead.

    motion_class : (states,) codes; NOT_CONVERGED where the longest transient decides nothing
    sections : (states, largest_period, size) the last states at mesh phase 0
    low, high : (states, size) corners of the box around the last sampled section
    """

    motion_class: np.ndarray
    sections: np.ndarray
    low: np.ndarray
    high: np.ndarray


def destinations(
    oscillator: Oscillator, states: np.ndarray, settling: Settling, tolerance: float = 1e-10, together: int = _TOGETHER
) -> Destinations:
    """Return where every state leads; none depends on the others.

    The criteria are those of settling.settle, but for the search for orbits: a section that recurs is periodic. One
    that does not is chaotic or quasi-periodic by its exponent over as many periods after it, the first twelfth left
    out, in which the tangent vector turns. What is not decided runs on, twice as long.

    Parameters
    ----------
    states : (states, size) at mesh phase 0, or (states, 2): displacement and velocity, the rest of the state zero
    together : states run at a time

    Raises
    ------
    ValueError
        For states or settings outside their range.
    """
    check_settling(settling)
    parts = [
        _destinations_of(oscillator, states[begin : begin + together], settling, tolerance)
        for begin in range(0, len(states), together)
    ]
    return Destinations(*(np.concatenate(part) for part in zip(*parts, strict=True)))


def share_escaping(oscillator: Oscillator, states: np.ndarray, settling: Settling, tolerance: float = 1e-10) -> float:
    """Return the share of motions that have become periodic by the longest transient: 0 unless chaos is a passage."""
    periods = max(settling.longest_transient, settling.sampled_periods)
    run = strobe_many([oscillator] * len(states), states, periods, 0, tolerance, detail=STATES, detect_cycles=True)
    section = run.states[:, -settling.sampled_periods - 1 :]
    return float((recurrences(section, settling.largest_period, settling.recurrence_tolerance)[0] > 0).mean())


def _destinations_of(oscillator: Any, states: np.ndarray, settling: Any, tolerance: float) -> Destinations:
    count, samples, longest = len(states), settling.sampled_periods, settling.largest_period
    now = vector(states, "state", oscillator.size, (count,))
    bounds = np.full((2, *now.shape), np.nan)
    found = Destinations(np.full(count, NOT_CONVERGED), np.full((count, longest, oscillator.size), np.nan), *bounds)
    waiting, reached, transient = np.arange(count), 0, settling.transient_periods
    while waiting.size:
        run = strobe_many(
            [oscillator] * waiting.size,
            now[waiting],
            transient + samples - reached,
            reached,
            tolerance,
            detail=STATES,
            detect_cycles=True,
        )
        section = run.states[:, -samples - 1 :]
        period = recurrences(section, longest, settling.recurrence_tolerance)[0]
        period[run.status != COMPLETED] = NOT_CONVERGED
        _note(found, waiting, period, section)
        left = np.flatnonzero((run.status == COMPLETED) & (period == 0))
        now[waiting] = run.states[:, -1]
        waiting = waiting[left]
        if not waiting.size:
            break
        reached = transient + samples
        run = strobe_many([oscillator] * waiting.size, now[waiting], samples, reached, tolerance, detail=GROWTH)
        alive = run.status == COMPLETED
        codes = np.where(alive, _endless(oscillator, run, reached, settling), NOT_CONVERGED)
        _note(found, waiting, codes, run.states)
        now[waiting] = run.states[:, -1]
        if transient >= settling.longest_transient:
            break
        waiting, reached = waiting[alive & (codes == NOT_CONVERGED)], reached + samples
        transient = max(min(2 * transient, settling.longest_transient), reached)
    return found


def _note(found: Destinations, places: Any, codes: Any, section: Any) -> None:
    found.motion_class[places] = codes
    found.sections[places] = section[:, -found.sections.shape[1] :]
    found.low[places], found.high[places] = section[:, 1:].min(axis=1), section[:, 1:].max(axis=1)


def _endless(oscillator: Any, run: Any, first_period: int, settling: Any) -> np.ndarray:
    """Return CHAOTIC, QUASI_PERIODIC or NOT_CONVERGED for motions whose section has not recurred so far."""
    exponent, error = means_and_errors(run.growth[:, run.growth.shape[1] // BATCHES :] / oscillator.period)
    end = run.states[:, -2 * settling.largest_period - 1 :]
    recurs = recurrences(end, settling.largest_period, settling.recurrence_tolerance)[0] > 0
    chaotic = (exponent > np.maximum(settling.chaos_threshold, 3 * error)) & ~recurs
    codes = np.where(chaotic, CHAOTIC, NOT_CONVERGED)
    if oscillator.has_second_frequency:
        turns = oscillator.torque.frequency_ratio * (first_period + np.arange(run.states.shape[1]))
        for place in np.flatnonzero((exponent <= 3 * error) & ~recurs):
            if is_closed_curve(run.states[place], turns):
                codes[place] = QUASI_PERIODIC
    return codes
