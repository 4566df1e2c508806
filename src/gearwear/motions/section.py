"""What a Poincare section tells: its period, whether it is a closed curve, and averages with their errors."""

from functools import reduce
from typing import NamedTuple

import numpy as np

STEADY_CHANGE = 1e-3
LONGEST_POLYGON_RATIO = 1.1
BATCHES = 12


class Recurrence(NamedTuple):
    """Period of a section in forcing periods (0: none found) and the distance to the state one period before.

    Without a period the distance is the least one over all the periods looked for.
    """

    period: int
    distance: float


def recurrence(states: np.ndarray, largest_period: int, tolerance: float) -> Recurrence:
    """Least period n at which a section recurs.

    The largest distance between states n periods apart must be within the tolerance over the second half of the
    section, and for every proper divisor m of n the distance must be steady: the same over both halves to one in a
    thousand. A slowly converging motion of period m with a multiplier near -1 fails that, as its distance shrinks.

    Parameters
    ----------
    states : (samples, size) states at mesh phase 0
    largest_period : longest period looked for, at most half the samples
    tolerance : allowed distance (dimensionless)
    """
    period, distance = recurrences(states[None], largest_period, tolerance)
    return Recurrence(int(period[0]), float(distance[0]))


def recurrences(states: np.ndarray, largest_period: int, tolerance: float) -> tuple[np.ndarray, np.ndarray]:
    """Periods and distances, (sections,) each, of many sections, (sections, samples, size), each as by `recurrence`.

    A section with NaN has period 0 and distance NaN.
    """
    first, second = _changes(states, largest_period)
    period, distance = np.zeros(len(states), dtype=int), np.min(list(second.values()), axis=0)
    for n in range(1, largest_period + 1):
        recurs = (period == 0) & (second[n] <= tolerance)
        if not recurs.any():
            continue
        for m in range(1, n):
            if n % m == 0:
                recurs &= np.abs(second[m] - first[m]) <= STEADY_CHANGE * first[m]
        period[recurs], distance[recurs] = n, second[n][recurs]
    return period, distance


def shrinking_periods(states: np.ndarray, largest_period: int, near: float) -> list[int]:
    """Periods n, ascending, over which a section changes less and less, and by no more than `near` in its second half.

    Parameters are those of recurrence.
    """
    first, second = _changes(states, largest_period)
    return [n for n in first if second[n] < first[n] and second[n] <= near]


def _changes(states: np.ndarray, largest_period: int) -> tuple[dict, dict]:
    """Largest change over n periods, for every n, in the first and second half of sections (..., samples, size)."""
    first, second = {}, {}
    columns = np.moveaxis(states, -1, 0).copy()  # a maximum over the short axis would take ten times as long
    for n in range(1, largest_period + 1):
        steps = reduce(np.maximum, (np.abs(column[..., n:] - column[..., :-n]) for column in columns))
        half = steps.shape[-1] // 2
        first[n], second[n] = steps[..., :half].max(axis=-1), steps[..., half:].max(axis=-1)
    return first, second


def is_closed_curve(states: np.ndarray, turns: np.ndarray) -> bool:
    """Whether the section is a closed curve over the phase of a second frequency.

    The samples in the order of that phase form a polygon. On a curve, however bent, it is hardly longer than the
    polygon through every other sample; on a cloud of points it is about twice as long.

    Parameters
    ----------
    states : (samples, size) states at mesh phase 0
    turns : (samples,) phase of the second frequency at those instants, in turns
    """
    ordered = states[np.argsort(turns % 1.0, kind="stable")]
    return bool(_perimeter(ordered) <= LONGEST_POLYGON_RATIO * _perimeter(ordered[::2]))


def _perimeter(polygon: np.ndarray) -> float:
    return float(np.hypot.reduce(np.roll(polygon, -1, axis=0) - polygon, axis=1).sum())


def mean_and_error(values: np.ndarray) -> tuple[float, float]:
    """Mean of a correlated series, and its standard error from the means of twelve batches."""
    mean, error = means_and_errors(values[None])
    return float(mean[0]), float(error[0])


def means_and_errors(values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Means and standard errors, (series,) each, of many series, (series, samples), as by `mean_and_error`."""
    means = np.array([batch.mean(axis=1) for batch in np.array_split(values, BATCHES, axis=1)])
    return values.mean(axis=1), means.std(axis=0, ddof=1) / np.sqrt(BATCHES)
