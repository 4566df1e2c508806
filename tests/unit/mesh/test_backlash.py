"""Half backlash: what opens it, what closes it, by how much."""

import math

import numpy as np
import pytest

from gearwear.geometry.involute import half_angle
from gearwear.geometry.kinematics import curvature
from gearwear.heat.growth import flank_growth
from gearwear.mesh.backlash import centre_distance_change, half_backlash, opened

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


@pytest.mark.parametrize("change", [150e-6, 20e-6, -40e-6])
@pytest.mark.parametrize("teeth, shift", [((19, 48), (0.0, 0.0)), ((16, 24), (0.18, 0.17))])
def test_gap_of_moved_shafts_is_what_the_teeth_leave_of_the_pitch(make_pair, teeth, shift, change):
    """Second method: pitch less tooth thicknesses on the working pitch circles of either centre distance."""
    near = make_pair(teeth, shift=shift)
    start = near.centre_distance + 50e-6

    def gap(distance):
        pair = make_pair(teeth, shift=shift, centre_distance=distance)
        working = pair.base_radius / math.cos(pair.working_pressure_angle)
        thickness = (2 * working * half_angle(pair, working)).sum()
        pitch = 2 * math.pi * working[0] / pair.teeth[0]
        return (pitch - thickness) * math.cos(pair.working_pressure_angle)

    expected = (gap(start + change) - gap(start)) / 2
    assert opened(change, start, near.base_radius) == pytest.approx(expected, rel=1e-8)


def test_gap_opens_by_the_sine_of_the_pressure_angle_to_first_order(make_pair):
    pair = make_pair((19, 48))
    for change in (1e-6, -1e-6):
        first = change * math.sin(pair.working_pressure_angle)
        assert opened(change, pair.centre_distance, pair.base_radius) == pytest.approx(first, rel=1e-4)
    assert opened(0.0, pair.centre_distance, pair.base_radius) == 0


def test_opening_adds_to_the_half_gap_whatever_the_projection():
    for projection in ("shi", "exact"):
        closed = half_backlash(INITIAL, SOME[0], SOME, SOME, ALPHA, projection)
        moved = half_backlash(INITIAL, SOME[0], SOME, SOME, ALPHA, projection, 7e-6)
        np.testing.assert_allclose(moved - closed, 7e-6, rtol=1e-9)


def test_housing_moves_the_shafts_by_its_own_expansion_and_mounting_adds_to_it():
    housing = {"thermal_expansion": 2.3e-5, "temperature_rise": 0.5}
    assert centre_distance_change(0.1, 80.0, 20e-6, housing) == pytest.approx(20e-6 + 2.3e-5 * 40 * 0.1)
    assert centre_distance_change(0.1, 80.0, 0.0, housing | {"temperature_rise": 0.0}) == 0


def test_housing_as_hot_as_the_gears_keeps_the_gap_of_eulerian_growth(make_geometry):
    """Gears and housing of one material and temperature grow alike: every length, the gap too, by l dT alone."""
    geometry = make_geometry((25, 50), bore=(5e-3, 5e-3))
    distance, expansion, rise = float(geometry["centre_distance"]), 1.1e-5, 80.0
    radii, _ = curvature(geometry)
    grown = []
    for i in range(2):
        base, half = float(geometry["base_radius"][i]), float(geometry["base_half_angle"][i])
        body = expansion * rise * base
        grown.append(flank_growth(radii[i], base, half, rise, body, expansion, "eulerian").growth)
    change = centre_distance_change(distance, rise, 0.0, {"thermal_expansion": expansion, "temperature_rise": 1.0})
    opening = opened(change, distance, geometry["base_radius"].values)
    none = np.zeros(geometry.sizes["path"])
    alpha = float(geometry["working_pressure_angle"])
    fixed, moved = (
        half_backlash(INITIAL, none, 0 * radii, np.stack(grown), alpha, "exact", one) for one in (0, opening)
    )
    assert (INITIAL - fixed).min() > 30e-6
    np.testing.assert_allclose(moved, INITIAL, atol=0.012 * (INITIAL - fixed).max())


def test_jam_by_shafts_too_near_names_their_key():
    with pytest.raises(ValueError, match=r"raise backlash\.centre_distance_change, which takes 12\.000 um"):
        half_backlash(5e-6, NONE, FLANKS, FLANKS, ALPHA, "exact", -6e-6)
    with pytest.raises(ValueError, match=r"backlash\.centre_distance_change: with -900 um .* give more than -628 um"):
        opened(-900e-6, 10e-3, np.array([4.6862, 4.6862]) * 1e-3)
