"""Tip relief and spacing: marks, shapes and signs along the path of contact."""

import numpy as np
import pytest

from gearwear.geometry.contact_path import contact_path
from gearwear.geometry.deviations import spacing, tip_relief

AMOUNT, SPACING = 20e-6, 5e-6


@pytest.fixture(scope="module")
def pair(make_pair):
    return make_pair((19, 48), 3.175e-3, 16e-3, bore=(10e-3, 25e-3))


@pytest.fixture(scope="module")
def contact(pair):
    return contact_path(pair, 120)


def relieved(contact, length=1.0, exponent=1, amounts=(AMOUNT, AMOUNT)):
    both = zip(("pinion", "gear"), amounts, strict=True)
    return tip_relief(contact, {name: {"amount": one, "length": length, "exponent": exponent} for name, one in both})


@pytest.mark.parametrize("exponent", [1, 2])
def test_relief_is_whole_at_the_tips_and_of_its_own_gear(contact, exponent):
    pinion, gear = relieved(contact, exponent=exponent, amounts=(AMOUNT, AMOUNT / 2))
    assert (pinion[-1], gear[0]) == (AMOUNT, AMOUNT / 2)
    assert pinion[0] == gear[-1] == 0
    assert (np.diff(pinion) >= 0).all() and (np.diff(gear) <= 0).all()


@pytest.mark.parametrize("exponent", [1, 2])
def test_long_relief_leaves_the_single_contact_alone_and_begins_at_its_ends(contact, exponent):
    pinion, gear = relieved(contact, exponent=exponent)
    touched = contact.path[(pinion + gear) > 1e-12 * AMOUNT]
    between = (contact.lowest_single_contact, contact.highest_single_contact)
    assert not ((between[0] < touched) & (touched < between[1])).any()
    before, after = touched[touched <= between[0]], touched[touched >= between[1]]
    step = np.diff(contact.path).max()
    assert between[0] - before.max() <= step and after.min() - between[1] <= step


def test_short_relief_leaves_one_base_pitch_of_perfect_involutes(pair, contact):
    pinion, gear = relieved(contact, length=0.5)
    perfect = contact.path[(pinion == 0) & (gear == 0)]
    assert np.ptp(perfect) == pytest.approx(pair.base_pitch, abs=2 * np.diff(contact.path).max())


@pytest.mark.parametrize("exponent", [1, 2, 1.5])
def test_relief_rises_as_a_power_of_the_distance_from_its_start(contact, exponent):
    length = 0.8 * (contact.lowest_single_contact - contact.start_of_contact)
    expected = AMOUNT * np.clip((contact.path - contact.end_of_contact + length) / length, 0, None) ** exponent
    np.testing.assert_allclose(relieved(contact, 0.8, exponent)[0], expected, atol=1e-18)


def test_a_pair_lacks_the_spacing_only_while_it_leaves(pair, contact):
    error, both = spacing(contact, pair.base_pitch, SPACING, 0.0), contact.leaving >= 0
    assert (error[contact.leaving[both]] == SPACING).all()
    assert (error[contact.entering] == 0).all()


@pytest.mark.parametrize("errors", [(SPACING, 0.0), (-SPACING, 0.0), (0.0, SPACING), (3 * SPACING, -SPACING)])
def test_the_leaving_pair_lacks_both_against_the_other(pair, contact, errors):
    error, both = spacing(contact, pair.base_pitch, *errors), contact.leaving >= 0
    difference = error[contact.leaving[both]] - error[contact.entering[both]]
    np.testing.assert_allclose(difference, sum(errors), rtol=1e-12)


def test_unlike_base_pitches_part_by_their_difference_with_every_pitch(pair, contact):
    error = spacing(contact, pair.base_pitch, 0.0, SPACING)
    expected = (contact.path / pair.base_pitch - contact.pitch_point / pair.base_pitch) * SPACING
    np.testing.assert_allclose(error, expected, atol=1e-18)
    assert error[contact.path == contact.pitch_point] == 0


def test_none_is_exactly_none(pair, contact):
    assert not relieved(contact, amounts=(0.0, 0.0)).any()
    assert not spacing(contact, pair.base_pitch, 0.0, 0.0).any()
