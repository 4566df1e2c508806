"""Half backlash: what opens it, what closes it, by how much."""

import math

import numpy as np
import pytest

from gearwear.mesh.backlash import half_backlash

INITIAL, ALPHA = 65e-6, math.radians(20)
NONE, FLANKS = np.zeros(4), np.zeros((2, 4))
SOME = 1e-6 * np.array([[1.0, 2.0, 3.0, 4.0], [0.5, 0.25, 2.0, 1.0]])


@pytest.mark.parametrize("projection", ["shi", "exact"])
def test_without_change_the_initial_backlash_stays(projection):
    np.testing.assert_array_equal(half_backlash(INITIAL, NONE, FLANKS, FLANKS, ALPHA, projection), INITIAL)


@pytest.mark.parametrize("projection", ["shi", "exact"])
def test_deflection_and_wear_open_and_growth_closes(projection):
    assert (half_backlash(INITIAL, SOME[0], FLANKS, FLANKS, ALPHA, projection) > INITIAL).all()
    assert (half_backlash(INITIAL, NONE, SOME, FLANKS, ALPHA, projection) > INITIAL).all()
    assert (half_backlash(INITIAL, NONE, FLANKS, SOME, ALPHA, projection) < INITIAL).all()


def test_total_gap_of_fixed_shafts_counts_two_worn_and_four_grown_flanks():
    """Both action lines touch the base circles: what closes on one side by turning opens on the other in full."""
    gap = 2 * half_backlash(INITIAL, SOME[0], 2 * SOME, SOME, ALPHA, "exact")
    np.testing.assert_allclose(gap, 2 * INITIAL + SOME[0] + 2 * SOME.sum(axis=0) - 2 * SOME.sum(axis=0), rtol=1e-12)


def test_projection_is_the_angle_between_the_normals_of_both_flanks():
    drive, back = np.array([math.cos(ALPHA), math.sin(ALPHA)]), np.array([-math.cos(ALPHA), math.sin(ALPHA)])
    exact = half_backlash(INITIAL, SOME[0], SOME, NONE * SOME, ALPHA, "exact") - INITIAL
    projected = half_backlash(INITIAL, SOME[0], SOME, NONE * SOME, ALPHA, "shi") - INITIAL
    np.testing.assert_allclose(projected, -(drive @ back) * exact, rtol=1e-9)


def test_jammed_teeth_are_refused_with_gap_growth_and_remedy():
    with pytest.raises(ValueError, match="jam") as refusal:
        half_backlash(5e-6, NONE, FLANKS, 10 * SOME, ALPHA, "exact")
    for part in ("-45.000 um", "0 um", "100.000 um", "half_backlash (5 um)", "bulk temperature"):
        assert part in str(refusal.value)


def test_backlash_of_exactly_nothing_is_a_jam():
    with pytest.raises(ValueError, match="0.000 um"):
        half_backlash(1e-6, NONE, FLANKS, np.full((2, 4), 0.5e-6), ALPHA, "exact")
