"""Basins with known attractors."""

import numpy as np
import pytest

from gearwear.codes.motion_class import CHAOTIC
from gearwear.motions.basins import UNDECIDED, basins, cell_centres
from gearwear.motions.settling import Settling
from gearwear.oscillator.oscillator import Oscillator
from gearwear.oscillator.periodic import Harmonics

SETTLING = Settling(200, 1600, 160, 16, 1e-7, 3e-3)


def slice_of(low, high, count):
    centres = cell_centres(low, high, count)
    return np.stack(np.meshgrid(centres, centres, indexing="ij"), axis=-1).reshape(-1, 2)


def test_centres_of_cells():
    np.testing.assert_allclose(cell_centres(-1.0, 2.0, 3), [-0.5, 0.5, 1.5])


def test_a_motion_always_in_contact_has_one_basin():
    """The steady state of the linear oscillator, in closed form."""
    oscillator = Oscillator(0.8, 0.05, 5.0, Harmonics(1.0), Harmonics(0.0, (0.3,), (0.7,)))
    found = basins(oscillator, slice_of(-8.0, 8.0, 6), SETTLING)
    assert found.shares.tolist() == [1.0] and found.escaped.tolist() == [0.0]
    steady = 0.3 * 0.8**2 * np.exp(0.7j) / (1 - 0.8**2 + 0.08j)
    assert found.attractors[0].displacement[-1] == pytest.approx(6.0 + steady.real, abs=1e-7)
    assert found.attractors[0].velocity[-1] == pytest.approx((0.8j * steady).real, abs=1e-7)


def test_with_hardly_any_clearance_there_is_one_basin():
    oscillator = Oscillator(
        0.8, 0.05, 0.1, Harmonics(1.0, (-0.2,), (0.0,)), Harmonics(0.0, (0.3,), (0.0,)), Harmonics(1e-6)
    )
    found = basins(oscillator, slice_of(-2.0, 2.0, 6), SETTLING)
    assert found.shares.tolist() == [1.0]
    assert found.attractors[0].motion_class == 1


def mirrored_pair():
    """No mean force, so that a motion turned upside down half a period later is one too: here the two differ."""
    return Oscillator(0.4, 0.05, 0.0, Harmonics(1.0), Harmonics(0.0, (3.0,), (0.0,)))


def test_mirrored_states_half_a_period_later_lead_to_mirrored_attractors():
    states = slice_of(-3.0, 3.0, 8)
    one, other = basins(mirrored_pair(), states, SETTLING), basins(mirrored_pair().seen_from(0.5), -states, SETTLING)
    assert len(one.attractors) == len(other.attractors) == 2
    assert sorted(one.shares) == sorted(other.shares)
    for place, motion in enumerate(one.attractors):
        image = other.attractors[other.destination[one.destination == place][0]]
        np.testing.assert_array_equal(
            one.destination == place, other.destination == other.destination[one.destination == place][0]
        )
        assert image.displacement[-1] == pytest.approx(-motion.displacement[-1], abs=1e-7)
        assert image.velocity[-1] == pytest.approx(-motion.velocity[-1], abs=1e-7)
        assert image.contact_loss_share == pytest.approx(motion.contact_loss_share, abs=1e-7)


def test_attractors_do_not_depend_on_the_order_of_the_states():
    states = slice_of(-3.0, 3.0, 8)
    order = np.random.default_rng(1).permutation(len(states))
    one, other = basins(mirrored_pair(), states, SETTLING), basins(mirrored_pair(), states[order], SETTLING)
    np.testing.assert_array_equal(one.destination[order], other.destination)
    for first, second in zip(one.attractors, other.attractors, strict=True):
        assert first.displacement.max() == pytest.approx(second.displacement.max(), abs=1e-7)
    assert one.attractors[0].displacement.max() > one.attractors[1].displacement.max()


def test_chaotic_cells_are_one_attractor():
    oscillator = Oscillator(1.4, 0.1, 0.1, Harmonics(1.0, (-0.4,), (0.0,)), Harmonics(0.0, (0.1,), (0.0,)))
    found = basins(oscillator, slice_of(-2.0, 2.0, 5), SETTLING)
    assert [motion.motion_class for motion in found.attractors] == [CHAOTIC]
    assert found.shares.tolist() == [1.0] and found.escaped.tolist() == [0.0]


def test_undecided_cells_keep_a_code_of_their_own():
    stiffness, error = Harmonics(1.0, (-0.2, -0.1, -0.05), (0.0,) * 3), Harmonics(0.0, (0.01,), (0.0,))
    found = basins(
        Oscillator(1.97, 0.05, 0.1, stiffness, error), slice_of(-2, 2, 3), Settling(10, 20, 32, 4, 1e-10, 1e-3)
    )
    assert found.attractors == [] and found.shares.size == 0
    assert set(found.destination) == {UNDECIDED}
