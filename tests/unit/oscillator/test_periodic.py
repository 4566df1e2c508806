"""Harmonics and tables of the mesh phase."""

import numpy as np
import pytest

from gearwear.oscillator.periodic import Harmonics, PeriodicTable, sum_of_harmonics


def test_harmonics_sum():
    wave = Harmonics(1.0, (0.3, 0.1), (0.2, -0.5))
    phase = np.array([0.0, 0.37])
    expected = 1 + 0.3 * np.cos(2 * np.pi * phase + 0.2) + 0.1 * np.cos(4 * np.pi * phase - 0.5)
    np.testing.assert_allclose(wave.at(phase), expected, rtol=1e-15)


def test_minimum_of_one_harmonic_is_exact():
    assert Harmonics(1.0, (0.3,), (0.2345,)).minimum == pytest.approx(0.7, abs=1e-14)


def test_minimum_of_many_harmonics_is_that_of_a_fine_grid():
    wave = Harmonics(0.0, (0.3, -0.2, 0.15, 0.1), (0.1, 1.2, 2.3, 0.7))
    grid = wave.at(np.linspace(0, 1, 400_001)).min()
    assert grid - 1e-9 < wave.minimum <= grid


def test_table_has_one_sided_values_and_slopes():
    table = PeriodicTable((0.0, 0.25, 1.0), (1.0, 3.0), (2.0, 0.0))
    np.testing.assert_allclose(table.at([0.0, 0.125, 0.25, 0.625]), [1.0, 1.5, 3.0, 1.5])
    np.testing.assert_allclose(table.slopes(), [4.0, -4.0])
    assert table.minimum == 0.0
    assert table.scaled(-2.0).start == (-2.0, -6.0)


@pytest.mark.parametrize(
    "arguments, message",
    [
        ((1.0, (0.1,), ()), "1 amplitudes but 0 phases"),
        ((np.nan, (), ()), "not finite"),
        ((1.0, (np.inf,), (0.0,)), "not finite"),
    ],
)
def test_bad_harmonics_are_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        Harmonics(*arguments)


@pytest.mark.parametrize(
    "arguments, message",
    [
        (((0.0, 0.9), (1.0,), (1.0,)), "from 0 to 1"),
        (((0.1, 1.0), (1.0,), (1.0,)), "from 0 to 1"),
        (((0.0, 0.5, 0.5, 1.0), (1.0,) * 3, (1.0,) * 3), "increase strictly"),
        (((0.0, 0.5, 1.0), (1.0,), (1.0, 1.0)), "1 values for 2 cells"),
        (((0.0, 1.0), (np.nan,), (1.0,)), "not finite"),
    ],
)
def test_bad_tables_are_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        PeriodicTable(*arguments)


def test_a_table_is_no_sum_of_harmonics():
    wave = Harmonics(1.0, (0.2,), (0.3,))
    assert sum_of_harmonics(wave) is wave
    with pytest.raises(ValueError, match="a table, which has no amplitudes; give a number for dynamics.harmonics"):
        sum_of_harmonics(PeriodicTable((0.0, 1.0), (1.0,), (2.0,)))
