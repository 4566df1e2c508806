"""Fourier coefficients over cells of unequal width."""

import math

import numpy as np
import pytest

from gearwear.oscillator.harmonics import harmonics, mean_over_mesh


def cells(jump, count=2000):
    """Return midpoints and widths of cells with an edge at `jump`."""
    first = round(count * jump)
    edges = np.concatenate([np.linspace(0, jump, first + 1), np.linspace(jump, 1, count - first + 1)[1:]])
    return (edges[1:] + edges[:-1]) / 2, np.diff(edges)


@pytest.mark.parametrize("ratio", [1.2, 1.645626, 1.9])
def test_rectangular_wave_has_its_closed_form(ratio):
    """k_m = (e-1) kd + (2-e) ks, k_a = (2/pi)(kd - ks) sin(pi (e-1)), phase -pi (e-1)."""
    phase, width = cells(ratio - 1)
    wave = np.where(phase < ratio - 1, 3.9, 2.1)
    assert mean_over_mesh(wave, width) == pytest.approx((ratio - 1) * 3.9 + (2 - ratio) * 2.1, rel=1e-12)
    amplitude, angle = harmonics(wave, phase, width, 1)
    assert amplitude[0] == pytest.approx(2 / math.pi * 1.8 * math.sin(math.pi * (ratio - 1)), rel=1e-6)
    assert angle[0] == pytest.approx(-math.pi * (ratio - 1), abs=1e-9)


def test_higher_harmonics_of_the_rectangular_wave():
    phase, width = cells(0.3)
    amplitude, _ = harmonics(np.where(phase < 0.3, 1.0, 0.0), phase, width, 4)
    orders = np.arange(1, 5)
    np.testing.assert_allclose(amplitude, 2 / (np.pi * orders) * np.abs(np.sin(0.3 * np.pi * orders)), rtol=1e-4)


def test_harmonics_rebuild_a_sum_of_cosines():
    phase, width = cells(0.41)
    wave = 5 + 2 * np.cos(2 * np.pi * phase - 2.0) + 0.5 * np.cos(6 * np.pi * phase + 1.0)
    amplitude, angle = harmonics(wave, phase, width, 4)
    assert mean_over_mesh(wave, width) == pytest.approx(5, rel=1e-6)
    np.testing.assert_allclose(amplitude, [2, 0, 0.5, 0], atol=1e-5)
    np.testing.assert_allclose(angle[[0, 2]], [-2.0, 1.0], atol=1e-5)


def test_error_falls_with_the_square_of_the_cell():
    def amplitude(count):
        phase, width = cells(0.645626, count)
        return harmonics(np.where(phase < 0.645626, 1.0, 0.0), phase, width, 1)[0][0]

    exact = 2 / math.pi * math.sin(0.645626 * math.pi)
    assert abs(amplitude(160) - exact) == pytest.approx(abs(amplitude(80) - exact) / 4, rel=0.05)


def test_no_harmonics_asked_none_given():
    amplitude, angle = harmonics(np.ones(4), np.arange(4) / 4 + 0.125, np.full(4, 0.25), 0)
    assert amplitude.shape == angle.shape == (0,)
