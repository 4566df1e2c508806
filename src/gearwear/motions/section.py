"""Properties of a Poincare section: its period, whether it is a closed curve, and averages with their errors."""

from typing import Any, NamedTuple

import numpy as np

from gearwear.integrate.compiled import njit

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
    return _recurrences(np.ascontiguousarray(states), largest_period, float(tolerance))


def shrinking_periods(states: np.ndarray, largest_period: int, near: float) -> list[int]:
    """Periods n, ascending, over which a section changes less and less, and by no more than `near` in its second half.

    Parameters are those of recurrence.
    """
    first, second = _all_changes(np.ascontiguousarray(states), largest_period)
    return [n for n in range(1, largest_period + 1) if second[n] < first[n] and second[n] <= near]


@njit
def _largest_change(states: np.ndarray, n: int, begin: int, end: int) -> Any:
    """Largest change over n periods from the states begin to end - 1, NaN if one of them is NaN."""
    largest = 0.0
    for i in range(begin, end):
        for k in range(states.shape[1]):
            change = abs(states[i + n, k] - states[i, k])
            if not change <= largest:
                largest = change
                if change != change:
                    return change
    return largest


@njit
def _changes(states: np.ndarray, n: int) -> Any:
    """Largest change over n periods in the first and in the second half of a section."""
    count = states.shape[0] - n
    return _largest_change(states, n, 0, count // 2), _largest_change(states, n, count // 2, count)


@njit
def _all_changes(states: np.ndarray, largest_period: int) -> Any:
    """The same for every n, two arrays; the place n = 0 is not used."""
    first, second = np.zeros(largest_period + 1), np.zeros(largest_period + 1)
    for n in range(1, largest_period + 1):
        first[n], second[n] = _changes(states, n)
    return first, second


@njit
def _recurrences(states: np.ndarray, largest_period: int, tolerance: float) -> Any:
    """Arguments and results as of recurrences."""
    periods, distances = np.zeros(states.shape[0], np.int64), np.empty(states.shape[0])
    first, second = np.zeros(largest_period + 1), np.zeros(largest_period + 1)
    for section in range(states.shape[0]):
        least = np.inf
        for n in range(1, largest_period + 1):
            first[n], second[n] = _changes(states[section], n)
            if least == least and not second[n] >= least:
                least = second[n]
            recurs = second[n] <= tolerance
            for m in range(1, n):
                if recurs and n % m == 0:
                    recurs = abs(second[m] - first[m]) <= STEADY_CHANGE * first[m]
            if recurs:
                periods[section], least = n, second[n]
                break
        distances[section] = least
    return periods, distances


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
    count, longer = divmod(values.shape[1], BATCHES)
    sizes = [count + 1] * longer + [count] * (BATCHES - longer)
    ends = np.cumsum(sizes)
    means = np.array([values[:, end - size : end].sum(axis=1) / size for end, size in zip(ends, sizes, strict=True)])
    return values.mean(axis=1), means.std(axis=0, ddof=1) / np.sqrt(BATCHES)
