"""What a Poincare section tells: its period, whether it is a closed curve, and averages with their errors."""

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
    states : (samples, 2) states at mesh phase 0
    largest_period : longest period looked for, at most half the samples
    tolerance : allowed distance (dimensionless)
    """
    first, second = _changes(states, largest_period)
    for n in range(1, largest_period + 1):
        if second[n] > tolerance:
            continue
        divisors = [m for m in range(1, n) if n % m == 0]
        if all(abs(second[m] - first[m]) <= STEADY_CHANGE * first[m] for m in divisors):
            return Recurrence(n, float(second[n]))
    return Recurrence(0, float(min(second.values())))


def shrinking_periods(states: np.ndarray, largest_period: int, near: float) -> list[int]:
    """Periods n, ascending, over which a section changes less and less, and by no more than `near` in its second half.

    Parameters are those of recurrence.
    """
    first, second = _changes(states, largest_period)
    return [n for n in first if second[n] < first[n] and second[n] <= near]


def _changes(states: np.ndarray, largest_period: int) -> tuple[dict[int, float], dict[int, float]]:
    """Largest change over n periods, for every n, in the first and in the second half of a section."""
    first, second = {}, {}
    for n in range(1, largest_period + 1):
        steps = np.abs(states[n:] - states[:-n]).max(axis=1)
        half = len(steps) // 2
        first[n], second[n] = steps[:half].max(), steps[half:].max()
    return first, second


def is_closed_curve(states: np.ndarray, turns: np.ndarray) -> bool:
    """Whether the section is a closed curve over the phase of a second frequency.

    The samples in the order of that phase form a polygon. On a curve, however bent, it is hardly longer than the
    polygon through every other sample; on a cloud of points it is about twice as long.

    Parameters
    ----------
    states : (samples, 2) states at mesh phase 0
    turns : (samples,) phase of the second frequency at those instants, in turns
    """
    ordered = states[np.argsort(turns % 1.0, kind="stable")]
    return bool(_perimeter(ordered) <= LONGEST_POLYGON_RATIO * _perimeter(ordered[::2]))


def _perimeter(polygon: np.ndarray) -> float:
    return float(np.hypot(*(np.roll(polygon, -1, axis=0) - polygon).T).sum())


def mean_and_error(values: np.ndarray) -> tuple[float, float]:
    """Mean of a correlated series, and its standard error from the means of twelve batches."""
    means = np.array([batch.mean() for batch in np.array_split(values, BATCHES)])
    return float(values.mean()), float(means.std(ddof=1) / np.sqrt(BATCHES))
