"""The oscillator against closed forms and the sets of Kahraman and Singh (1990, 1991).

The set of 1991 is J. Sound Vib. 146, 135-156 (parameters as in the code published with doi:10.1017/dce.2022.34);
the other one has a single harmonic of large stiffness fluctuation and shows the whole route to chaos.
"""

import math

import numpy as np
import pytest
from scipy.optimize import brentq

from gearwear.attractors.basins import basins, cell_centres
from gearwear.attractors.chain import carried
from gearwear.attractors.hysteresis import differing
from gearwear.attractors.settling import Settling, settle
from gearwear.dynamics.motion import monodromy, strobe
from gearwear.dynamics.oscillator import Oscillator
from gearwear.dynamics.periodic import Harmonics

SETTLING = Settling(400, 6400, 240, 16, 1e-7, 3e-3)


def set_of_1991(frequency):
    stiffness = Harmonics(1.0, (-0.2, -0.1, -0.05), (0.0, 0.0, 0.0))
    return Oscillator(frequency, 0.05, 0.1, stiffness, Harmonics(0.0, (0.01, 0.004, 0.002), (0.0, 0.0, 0.0)))


def large_fluctuation(frequency):
    return Oscillator(frequency, 0.1, 0.1, Harmonics(1.0, (-0.4,), (0.0,)), Harmonics(0.0, (0.1,), (0.0,)))


def periodic_orbit(oscillator, state, period):
    """State and monodromy matrix of the orbit of some period near a state, stable or not, by Newton's method."""
    state = np.array(state)
    for _ in range(12):
        after, matrix = monodromy(oscillator, state, period, tolerance=1e-12)
        correction = np.linalg.solve(np.eye(2) - matrix, after - state)
        state = state + correction
        if np.abs(correction).max() < 1e-12:
            break
    return state, matrix


@pytest.mark.parametrize("edge, lost_side", [(0.8206311, 1), (1.4070885, -1)])
def test_contact_is_lost_between_the_frequencies_of_the_closed_form(edge, lost_side):
    """Constant stiffness: contact stays while F_e W^2 / sqrt((1 - W^2)^2 + (2 zeta W)^2) < F."""
    for side in (-1, 1):
        w = edge + side * 1e-6
        steady = 0.05 * w**2 / (1 - w**2 + 0.1j * w)
        oscillator = Oscillator(w, 0.05, 0.1, Harmonics(1.0), Harmonics(0.0, (0.05,), (0.0,)))
        motion = strobe(oscillator, (1.1 + steady.real, (1j * w * steady).real), 3, tolerance=1e-12)
        assert np.all(motion.lost > 0) == (side == lost_side)
        assert np.all(motion.impacts == (1 if side == lost_side else 0))


@pytest.mark.parametrize("factor, grows", [(3.95, False), (4.05, True)])
def test_parametric_onset(factor, grows):
    """k = 1 + k1 cos 2t without contact loss: the principal instability begins at k1 = 4 zeta."""
    for zeta in (0.005, 0.02):
        oscillator = Oscillator(2.0, zeta, 1.0, Harmonics(1.0, (factor * zeta,), (0.0,)))
        motion = strobe(oscillator, (2.0, 0.0), 1)
        assert motion.lost[0] == 0
        assert (max(abs(np.linalg.eigvals(motion.tangent_maps[0]))) > 1) == grows


def test_set_of_1991_at_half_the_natural_frequency():
    point = settle(set_of_1991(0.5), (0.0, 0.0), SETTLING)
    assert point.motion_class == 1
    assert point.displacement[-1] == pytest.approx(1.03825291165, abs=1e-9)
    assert point.velocity[-1] == pytest.approx(0.08857427185, abs=1e-9)
    assert point.multiplier_real == pytest.approx(0.076461, abs=1e-6)
    assert abs(point.multiplier_imag) == pytest.approx(0.527980, abs=1e-6)
    assert point.displacement_min == pytest.approx(0.951038, abs=1e-6)
    assert point.displacement_max == pytest.approx(1.242393, abs=1e-6)
    assert point.contact_loss_share == pytest.approx(0.20273, abs=1e-5)


def test_slow_period_one_near_minus_one_is_not_called_period_two():
    point = settle(set_of_1991(1.97), (0.0, 0.0), SETTLING)
    assert point.motion_class == 1
    assert -1 < point.multiplier_real < -0.99
    assert point.transient_periods > SETTLING.transient_periods


@pytest.mark.parametrize(
    "oscillator_at, fold, first, branch",
    [
        (large_fluctuation, 0.620486, 0.560, 1.19294),
        (large_fluctuation, 0.577217, 0.640, 0.74097),
        (set_of_1991, 0.455324, 0.430, 1.17309),
        (set_of_1991, 0.437007, 0.470, 1.05504),
        (set_of_1991, 0.835838, 0.800, 1.16062),
        (set_of_1991, 0.598153, 0.840, 1.01210),
    ],
)
def test_folds_of_period_one(oscillator_at, fold, first, branch):
    """A multiplier reaches +1 as the square root of the distance to the fold."""
    state = strobe(oscillator_at(first), (0.0, 0.0), 600).states[-1]
    assert state[0] == pytest.approx(branch, abs=1e-5)
    for distance in (fold - first) * np.geomspace(1.0, 1e-3, 120):
        state, _ = periodic_orbit(oscillator_at(fold - distance), state, 1)
    forward = math.copysign(1.0, fold - first)
    squares = []
    for distance in (4e-6, 2e-6):
        state, matrix = periodic_orbit(oscillator_at(fold - forward * distance), state, 1)
        squares.append((1 - max(np.linalg.eigvals(matrix).real)) ** 2)
    assert squares[0] > squares[1] > 0
    reached = fold - forward * (4e-6 - 2e-6 * squares[0] / (squares[0] - squares[1]))
    assert reached == pytest.approx(fold, abs=1e-6)
    beyond = strobe(oscillator_at(fold + forward * 1e-4), state, 1500).states[-1]
    assert abs(beyond[0] - state[0]) > 0.005


def test_sweeps_up_and_down_differ_between_the_folds():
    """The primary resonance of the large fluctuation at half the frequency: folds at 0.577217 and 0.620486."""
    frequencies = np.linspace(0.5622, 0.6322, 15)
    both = []
    for order in (frequencies, frequencies[::-1]):
        both.append(carried(map(large_fluctuation, order), lambda _: (0.0, 0.0), SETTLING))
    both[1].reverse()
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
        ends.append(carried(way, lambda _: (0.0, 0.0), SETTLING)[-1])
    from_basins = sorted((motion.displacement[-1], motion.velocity[-1]) for motion in found.attractors)
    from_sweeps = sorted((motion.displacement[-1], motion.velocity[-1]) for motion in ends)
    np.testing.assert_allclose(np.resize(from_basins, (2, 2)), from_sweeps, atol=1e-6)


@pytest.mark.parametrize(
    "w, section",
    [
        (0.4, [(1.21160, 0.01859)]),
        (0.9, [(0.72997, 0.10476)]),
        (1.1, [(1.01007, None), (0.17803, None)]),
        (1.21, [(1.10793, None), (0.22993, None), (0.80199, None), (0.46717, None)]),
    ],
)
def test_sections_of_the_large_fluctuation(w, section):
    point = settle(large_fluctuation(w), (0.0, 0.0), SETTLING)
    assert point.motion_class == len(section)
    found = sorted(zip(point.displacement[-len(section) :], point.velocity[-len(section) :], strict=True))
    for (x, v), (expected_x, expected_v) in zip(found, sorted(section, key=lambda s: s[0]), strict=True):
        assert x == pytest.approx(expected_x, abs=6e-6)
        if expected_v is not None:
            assert v == pytest.approx(expected_v, abs=6e-6)


@pytest.mark.parametrize(
    "period, start, low, high, doubling",
    [
        (1, 1.000, 1.0318, 1.0322, 1.032048),
        (2, 1.170, 1.1831, 1.1836, 1.183331),
        (4, 1.255, 1.2631, 1.2635, 1.263317),
    ],
)
def test_period_doublings_of_the_large_fluctuation(period, start, low, high, doubling):
    settled = settle(large_fluctuation(start), (0.0, 0.0), SETTLING)
    assert settled.motion_class == period
    state = np.array([settled.displacement[-1], settled.velocity[-1]])
    for w in np.linspace(start, low, 30):
        state, _ = periodic_orbit(large_fluctuation(w), state, period)

    def distance(w):
        _, matrix = periodic_orbit(large_fluctuation(w), state, period)
        return min(np.linalg.eigvals(matrix).real) + 1

    assert distance(low) > 0 > distance(high)
    assert brentq(distance, low, high, xtol=1e-8) == pytest.approx(doubling, abs=1e-6)


def test_determinant_of_long_orbits():
    _, matrix = monodromy(set_of_1991(0.5), (1.03825291165, 0.08857427185), 1)
    assert np.linalg.det(matrix) == pytest.approx(math.exp(-0.1 * set_of_1991(0.5).period), rel=1e-7)
