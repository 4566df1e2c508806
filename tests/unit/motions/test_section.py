"""Period, closed curves and averages of Poincare sections."""

import numpy as np
import pytest

from gearwear.motions.section import is_closed_curve, mean_and_error, means_and_errors, recurrence, recurrences

SAMPLES = np.arange(241)


def orbit(period, multiplier=0.0, size=0.0):
    """A section of some period with a transient of one real multiplier per forcing period."""
    angle = 2 * np.pi * (SAMPLES % period) / period
    points = np.column_stack([np.cos(angle), np.sin(angle) + 0.1 * (SAMPLES % period)])
    return points + size * np.column_stack([multiplier**SAMPLES, 0.5 * multiplier**SAMPLES])


@pytest.mark.parametrize("period", [1, 2, 3, 4, 6, 12, 16])
def test_period_of_a_periodic_section(period):
    assert recurrence(orbit(period), 16, 1e-7).period == period


def test_longer_period_than_looked_for_is_none():
    found = recurrence(orbit(18), 16, 1e-7)
    assert found.period == 0
    assert found.distance > 0.1


@pytest.mark.parametrize("closeness", [1e-2, 1e-3, 1e-4])
def test_slow_period_one_is_not_called_period_two(closeness):
    section = orbit(1, -(1 - closeness), 0.04e-7 / closeness)
    assert np.abs(section[2:] - section[:-2]).max() < 1e-7
    assert recurrence(section, 16, 1e-9 if closeness == 1e-2 else 1e-7).period in (0, 1)
    assert recurrence(section, 16, 1e-7).period != 2


def test_slow_period_two_is_not_called_period_four():
    slow = orbit(2)
    slow[::2] += 2e-5 * ((-(1 - 1e-3)) ** np.arange(121))[:, None]
    assert recurrence(slow, 16, 1e-7).period == 0


def test_many_sections_are_judged_as_each_alone():
    lost = np.full((241, 2), np.nan)
    sections = np.array([orbit(3), orbit(18), orbit(1, -0.999, 4e-6), orbit(4), lost])
    periods, distances = recurrences(sections, 16, 1e-7)
    alone = [recurrence(section, 16, 1e-7) for section in sections]
    assert periods.tolist() == [found.period for found in alone] == [3, 0, 0, 4, 0]
    np.testing.assert_array_equal(distances, [found.distance for found in alone])


def test_means_and_errors_of_many_series_are_those_of_each_alone():
    series = np.random.default_rng(4).normal(size=(3, 250))
    means, errors = means_and_errors(series)
    for i, values in enumerate(series):
        assert (means[i], errors[i]) == pytest.approx(mean_and_error(values), rel=1e-14)


def test_ellipse_is_a_closed_curve_and_a_cloud_is_not():
    turns = 0.618034 * np.arange(240) % 1.0
    angle = 2 * np.pi * turns
    curve = np.column_stack([np.cos(angle) + 0.3 * np.cos(2 * angle), 0.2 * np.sin(angle)])
    cloud = curve + 0.1 * np.random.default_rng(1).normal(size=curve.shape)
    assert is_closed_curve(curve, turns)
    assert not is_closed_curve(cloud, turns)


def test_error_of_the_mean_is_that_of_independent_numbers():
    values = np.random.default_rng(2).normal(3.0, 2.0, 12_000)
    mean, error = mean_and_error(values)
    assert mean == values.mean()
    assert error == pytest.approx(2.0 / np.sqrt(12_000), rel=0.5)
    assert abs(mean - 3.0) < 4 * error
