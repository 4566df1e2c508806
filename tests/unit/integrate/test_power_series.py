"""Where a power series first falls below zero, against the roots of the polynomial."""

import numpy as np
import pytest
from numpy.polynomial import Polynomial

from gearwear.integrate.taylor.power_series import NONE, TERMS, extreme, first_fall, shift, value, waves


def padded(coefficients):
    series = np.zeros(TERMS)
    series[: len(coefficients)] = coefficients
    return series


@pytest.mark.parametrize("seed", range(40))
def test_first_fall_is_the_first_root_with_a_change_of_sign(seed):
    random = np.random.default_rng(seed)
    roots = np.sort(random.uniform(-1.5, 2.5, random.integers(1, 7)))
    polynomial = Polynomial.fromroots(roots)
    if polynomial(0.0) < 0:
        polynomial = -polynomial
    inside = roots[(roots > 0) & (roots <= 1)]
    found = first_fall(padded(polynomial.coef), np.empty(TERMS))
    assert found == pytest.approx(inside[0] if inside.size else NONE, abs=1e-12)


@pytest.mark.parametrize("depth", [1e-3, 1e-6, 1e-9])
def test_a_graze_falls_only_if_it_passes_zero(depth):
    for place in np.linspace(0.1, 0.9, 17):
        touch = Polynomial([place**2, -2 * place, 1.0])
        below = first_fall(padded((touch - depth).coef), np.empty(TERMS))
        assert below == pytest.approx(place - np.sqrt(depth), abs=1e-7)
        assert first_fall(padded((touch + depth).coef), np.empty(TERMS)) == NONE


def test_a_series_that_begins_on_zero_and_rises_falls_at_its_next_root():
    assert first_fall(padded([0.0, 1.0]), np.empty(TERMS)) == NONE
    assert first_fall(padded([0.0, 1.0, -2.0]), np.empty(TERMS)) == pytest.approx(0.5, abs=1e-14)
    assert first_fall(padded([0.0, 0.0, 1.0]), np.empty(TERMS)) == NONE


def test_shifted_series_and_extremes():
    series, out = padded([0.3, 1.0, -1.5, 0.2, 0.1]), np.empty(TERMS)
    shift(series, 0.4, 0.35, out)
    for w in (0.0, 0.5, 1.0):
        assert value(out, w) == pytest.approx(value(series, 0.4 + 0.35 * w), rel=1e-14)
    dense = np.polyval(series[4::-1], np.linspace(0, 0.8, 4001))
    assert extreme(series, 1.0, 0.8) == pytest.approx(dense.max(), abs=1e-7)
    assert extreme(series, -1.0, 0.8) == pytest.approx(dense.min(), abs=1e-7)


def test_waves_are_the_series_of_the_exponential():
    for j, series in enumerate(waves(0.7, 3), start=1):
        np.testing.assert_allclose(np.polyval(series[::-1], 1.0), np.exp(0.7j * j), rtol=1e-12)
