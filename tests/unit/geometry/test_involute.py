"""Dimensions of the gear pair against closed forms, a generated root and the limits of manufacture."""

import math

import numpy as np
import pytest

from gearwear.geometry.involute import equivalent_mass, half_angle, involute

ALPHA = math.radians(20)


def test_dimensions_of_an_unshifted_pair_are_those_of_the_standard_rack(make_pair):
    pair = make_pair((19, 48), 3.175e-3)
    teeth = np.array([19, 48])
    np.testing.assert_allclose(pair.reference_radius, 3.175e-3 * teeth / 2)
    np.testing.assert_allclose(pair.base_radius, pair.reference_radius * math.cos(ALPHA))
    np.testing.assert_allclose(pair.tip_radius - pair.reference_radius, 3.175e-3)
    np.testing.assert_allclose(pair.reference_radius - pair.root_radius, 1.25 * 3.175e-3)
    np.testing.assert_allclose(pair.base_pitch, 2 * math.pi * pair.base_radius / teeth)
    np.testing.assert_allclose(pair.tooth_thickness, math.pi * 3.175e-3 / 2)
    assert pair.working_pressure_angle == pytest.approx(ALPHA, rel=1e-12)
    assert pair.centre_distance == pytest.approx(pair.reference_radius.sum(), rel=1e-12)


def test_a_profile_shift_moves_tip_and_root_and_thickens_the_tooth(make_pair):
    plain, shifted = make_pair((25, 30)), make_pair((25, 30), shift=(0.3, -0.3))
    module = 3e-3
    for name in ("tip_radius", "root_radius"):
        np.testing.assert_allclose(getattr(shifted, name) - getattr(plain, name), [0.3 * module, -0.3 * module])
    change = shifted.tooth_thickness - plain.tooth_thickness
    np.testing.assert_allclose(change, np.array([0.6, -0.6]) * module * math.tan(ALPHA))
    assert shifted.centre_distance == pytest.approx(plain.centre_distance, rel=1e-12)


@pytest.mark.parametrize("shift", [(0.1817, 0.1715), (0.5, 0.2), (-0.1, 0.3), (0.0, 0.0)])
def test_without_a_given_centre_distance_the_teeth_fill_the_pitch(make_pair, shift):
    pair = make_pair((24, 35), shift=shift)
    working = pair.base_radius / math.cos(pair.working_pressure_angle)
    thickness = 2 * working * half_angle(pair, working)
    assert thickness.sum() == pytest.approx(2 * math.pi * working[0] / 24, rel=1e-12)
    assert working.sum() == pytest.approx(pair.centre_distance, rel=1e-12)


def test_a_given_centre_distance_fixes_the_working_pressure_angle(make_pair):
    pair = make_pair((24, 35), centre_distance=90e-3)
    assert math.cos(pair.working_pressure_angle) == pytest.approx(pair.base_radius.sum() / 90e-3, rel=1e-12)
    assert pair.working_pressure_angle > ALPHA


def test_half_angle_runs_from_the_base_circle_value_down_to_the_tip(make_pair):
    pair = make_pair((25, 30))
    np.testing.assert_allclose(half_angle(pair, pair.base_radius), pair.base_half_angle)
    np.testing.assert_allclose(half_angle(pair, pair.reference_radius), math.pi / 2 / pair.teeth)
    radii = np.linspace(pair.base_radius, pair.tip_radius, 7, axis=1)
    assert (np.diff(half_angle(pair, radii), axis=1) < 0).all()


@pytest.mark.parametrize(("teeth", "shift"), [(19, 0.0), (48, 0.0), (25, 0.4), (30, -0.3)])
def test_half_angle_is_the_polar_angle_of_an_unwound_string(make_pair, teeth, shift):
    pair = make_pair((teeth, 40), shift=(shift, 0.3))
    base, alone = pair.base_radius[0], pair.base_half_angle[0]
    roll = 0.5
    contact = math.pi / 2 - alone + roll  # direction of the tangent point, tooth axis upwards
    point = base * np.array(
        [math.cos(contact) + roll * math.sin(contact), math.sin(contact) - roll * math.cos(contact)]
    )
    radius = np.full((2, 1), np.hypot(*point))
    assert math.atan2(*point) == pytest.approx(float(half_angle(pair, radius)[0, 0]), rel=1e-12)


def test_straight_root_keeps_the_thickness_of_the_tooth_at_the_base_circle(make_pair):
    pair = make_pair((25, 30))
    chord = pair.base_radius * np.sin(pair.base_half_angle)
    np.testing.assert_allclose(pair.root_radius * np.sin(pair.straight_root_angle), chord)


def cut_root_angle(teeth, shift, addendum=1.0, clearance=0.25):
    """Half angle of the tooth at the root circle, cut by rolling a rack through a blank; module 1.

    The rack tooth is drawn with u from its centre line and v towards the gear's centre from its pitch line: tip land,
    tip rounding tangent to tip line and flank, flank. What it sweeps at the root circle is the space.
    """
    depth = addendum + clearance - shift
    rounding = clearance / (1 - math.sin(ALPHA))
    on_flank = np.array([math.pi / 4 - shift * math.tan(ALPHA), 0.0])
    along = np.array([-math.sin(ALPHA), math.cos(ALPHA)])
    inwards = np.array([-math.cos(ALPHA), -math.sin(ALPHA)])
    step = (depth - rounding - (on_flank + rounding * inwards)[1]) / along[1]
    centre = on_flank + rounding * inwards + step * along
    assert centre[0] > 0
    turn = np.concatenate([np.geomspace(1e-7, math.pi / 2 - ALPHA, 400)])
    u = np.concatenate([np.linspace(0, centre[0], 200), centre[0] + rounding * np.sin(turn)])
    v = np.concatenate([np.full(200, depth), centre[1] + rounding * np.cos(turn)])
    radius = teeth / 2
    roll = np.linspace(-1.5 * centre[0] / radius - 0.01, 0, 30001)[:, None]
    x, y = u + radius * roll, radius - v
    distance = np.hypot(x, y)
    reached = distance < (radius - depth) * (1 + 1e-8)
    swept = (np.arctan2(x, y) - roll)[reached]
    assert distance.min() == pytest.approx(radius - depth, rel=1e-7)
    return math.pi / teeth - swept.max()


@pytest.mark.parametrize(
    ("teeth", "shift", "addendum", "clearance"),
    [(19, 0.0, 1.0, 0.25), (48, 0.0, 1.0, 0.25), (25, 0.4, 1.0, 0.25), (30, -0.2, 1.0, 0.2), (25, 0.2, 0.8, 0.3)],
)
def test_generated_root_angle_is_that_of_a_tooth_cut_by_the_rack(make_pair, teeth, shift, addendum, clearance):
    pair = make_pair((teeth, 40), shift=(shift, 0.3), addendum=(addendum, 1.0), clearance=clearance)
    assert pair.generated_root_angle[0] == pytest.approx(cut_root_angle(teeth, shift, addendum, clearance), rel=1e-3)


def test_rack_root_angle_of_the_peers_lacks_the_clearance(make_pair):
    pair = make_pair((25, 30))
    lacking = 2 * 0.25 * math.tan(ALPHA) / pair.teeth
    np.testing.assert_allclose(pair.generated_root_angle - pair.rack_root_angle, lacking)


def test_generated_root_leaves_room_for_the_tool_at_any_shift(make_pair):
    for shift in (0.0, 0.4, 0.8):
        pair = make_pair((19, 48), shift=(shift, shift))
        assert (pair.generated_root_angle < math.pi / pair.teeth).all()


def test_moment_of_inertia_is_that_of_a_disc_less_its_bore_unless_given(make_pair):
    pair = make_pair((19, 48), 3.175e-3, 16e-3, bore=(10e-3, 25e-3))
    density = {"pinion": 7850.0, "gear": 7800.0}
    moments, _ = equivalent_mass(pair, density, {"pinion": None, "gear": 3e-3})
    r, bore = pair.reference_radius[0], 10e-3
    mass_disc, mass_bore = 7850 * 16e-3 * math.pi * r**2, 7850 * 16e-3 * math.pi * bore**2
    assert moments[0] == pytest.approx(mass_disc * r**2 / 2 - mass_bore * bore**2 / 2, rel=1e-12)
    assert moments[1] == 3e-3


def test_equivalent_mass_gives_the_kinetic_energy_of_the_relative_motion(make_pair):
    pair = make_pair((19, 48), 3.175e-3)
    _, mass = equivalent_mass(pair, {"pinion": 1.0, "gear": 1.0}, {"pinion": 2e-4, "gear": 9e-3})
    masses = np.array([2e-4, 9e-3]) / pair.base_radius**2
    assert mass == pytest.approx(1 / (1 / masses).sum(), rel=1e-12)


@pytest.mark.parametrize(
    ("pair", "quantity", "value", "limit"),
    [
        ({"shift": (1.2, -1.2)}, "thickness at the tip of the pinion", "-0.0362 mm", "positive"),
        ({"bore": (16.5e-3, 5e-3)}, "bore_radius.pinion", "16.5 mm", "16.5 mm"),
        ({"bore": (5e-3, 46e-3)}, "bore_radius.gear", "46 mm", "45.5 mm"),
        ({"centre_distance": 66.5e-3}, "thickness at the pitch circle", "6.5871 mm", "6.2363 mm"),
        ({"addendum": (1.4, 1.0)}, "tip of the pinion runs into the root of its mate", "0.3000 mm", "clearance"),
        ({"addendum": (1.0, 1.3)}, "tip of the gear runs into the root of its mate", "0.1000 mm", "clearance"),
        ({"shift": (-1.4, -1.4)}, "profile_shift", "-2.8", "less negative"),
        ({"centre_distance": 60e-3}, "centre_distance", "0.06 m", "0.0629594 m"),
    ],
)
def test_what_cannot_be_made_is_refused_with_quantity_value_and_limit(make_pair, pair, quantity, value, limit):
    with pytest.raises(ValueError, match=r"^gear_pair") as refusal:
        make_pair((19, 48), 2e-3, **({"bore": (5e-3, 5e-3)} | pair))
    for part in (quantity, value, limit):
        assert part in str(refusal.value)


def test_a_shift_rounded_to_four_digits_does_not_jam(make_pair):
    """FZG type C: tabulated shifts and centre distance agree to 0.1 um of tooth thickness only."""
    pair = make_pair((16, 24), 4.5e-3, 14e-3, shift=(0.1817, 0.1715), centre_distance=91.5e-3)
    assert math.degrees(pair.working_pressure_angle) == pytest.approx(22.44, abs=0.01)


def test_involute_of_twenty_degrees():
    assert involute(ALPHA) == pytest.approx(0.014904384, abs=1e-9)
