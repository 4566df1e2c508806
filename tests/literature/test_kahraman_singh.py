"""What sweeps and basins show of the sets of Kahraman and Singh (1990, 1991); numbers are in config/validation.yaml.

The set of 1991 is J. Sound Vib. 146, 135-156 (parameters as in the code published with doi:10.1017/dce.2022.34);
the other one has a single harmonic of large stiffness fluctuation and shows the whole route to chaos.
"""

import numpy as np
import pytest

from gearwear.motions.basins import basins, cell_centres
from gearwear.motions.hysteresis import differing
from gearwear.motions.settling import Settling, settle
from gearwear.motions.sweep import DOWN, UP, settle_by_continuation
from gearwear.oscillator.oscillator import Oscillator
from gearwear.oscillator.periodic import Harmonics

SETTLING = Settling(400, 6400, 240, 16, 1e-7, 3e-3)


def set_of_1991(frequency):
    stiffness = Harmonics(1.0, (-0.2, -0.1, -0.05), (0.0, 0.0, 0.0))
    return Oscillator(frequency, 0.05, 0.1, stiffness, Harmonics(0.0, (0.01, 0.004, 0.002), (0.0, 0.0, 0.0)))


def large_fluctuation(frequency):
    return Oscillator(frequency, 0.1, 0.1, Harmonics(1.0, (-0.4,), (0.0,)), Harmonics(0.0, (0.1,), (0.0,)))


def test_slow_period_one_near_minus_one_is_not_called_period_two():
    point = settle(set_of_1991(1.97), (0.0, 0.0), SETTLING)
    assert point.motion_class == 1
    assert -1 < point.multiplier_real < -0.99
    assert point.recurrence_period == 0  # the section has not settled: Newton's method tells the period


def test_sweeps_up_and_down_differ_between_the_folds():
    """The primary resonance of the large fluctuation at half the frequency: folds at 0.577217 and 0.620486."""
    frequencies = np.linspace(0.5622, 0.6322, 15)
    oscillators = [large_fluctuation(frequency) for frequency in frequencies]
    both = [
        settle_by_continuation(oscillators, lambda _: (0.0, 0.0), SETTLING, direction=direction)
        for direction in (UP, DOWN)
    ]
    sections = [[np.stack([one.displacement, one.velocity], axis=-1) for one in motions] for motions in both]
    found = differing([[one.motion_class for one in motions] for motions in both], np.array(sections))
    np.testing.assert_array_equal(found, (frequencies > 0.577217) & (frequencies < 0.620486))


@pytest.mark.parametrize("frequency, expected", [(0.56, 1), (0.60, 2), (0.64, 1)])
def test_between_the_folds_sweeps_and_basins_show_the_same_two_motions(frequency, expected):
    centres = cell_centres(-2.0, 2.0, 6)
    states = np.stack(np.meshgrid(centres, centres), axis=-1).reshape(-1, 2)
    found = basins(large_fluctuation(frequency), states, SETTLING)
    assert [motion.motion_class for motion in found.attractors] == [1] * expected
    assert found.shares.sum() == 1.0 and found.shares.min() > 0.05
    ends = []
    for begin in (0.55, 0.65):
        way = map(large_fluctuation, np.linspace(begin, frequency, 12))
        ends.append(settle_by_continuation(way, lambda _: (0.0, 0.0), SETTLING)[-1])
    from_basins = sorted((motion.displacement[-1], motion.velocity[-1]) for motion in found.attractors)
    from_sweeps = sorted((motion.displacement[-1], motion.velocity[-1]) for motion in ends)
    np.testing.assert_allclose(np.resize(from_basins, (2, 2)), from_sweeps, atol=1e-6)
