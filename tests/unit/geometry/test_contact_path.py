"""Marks of the path of contact against other forms of them, and the two grids against each other."""

import math

import numpy as np
import pytest

from gearwear.geometry.contact_path import contact_path

PAIRS = {
    "benchmark": {"teeth": (19, 48), "module": 3.175e-3},
    "equal": {"teeth": (50, 50)},
    "reducing": {"teeth": (40, 25)},
    "fzg": {"teeth": (16, 24), "module": 4.5e-3, "shift": (0.1817, 0.1715), "centre_distance": 91.5e-3},
    "pitch point in the double zone": {"teeth": (25, 60), "shift": (0.4, -0.4)},
    "pitch point off the path": {"teeth": (40, 80), "shift": (0.9, -0.9), "addendum": (0.85, 0.85)},
    "nearly one pair": {"teeth": (25, 30), "addendum": (0.58, 0.58)},
    "nearly two pairs": {"teeth": (60, 80), "addendum": (1.1, 1.1)},
}


@pytest.fixture(params=PAIRS, scope="module")
def meshing(request, make_pair):
    """Return a gear pair and its path of contact."""
    pair = make_pair(**PAIRS[request.param])
    return pair, contact_path(pair, 120)


@pytest.mark.parametrize(("pinion", "gear"), [(19, 48), (25, 30), (50, 50), (62, 62), (40, 25)])
def test_contact_ratio_is_that_of_the_long_form_with_arc_cosines(make_pair, pinion, gear):
    """Roll angles of the pinion at both ends from the triangle of tip circle and centre distance."""
    alpha = math.radians(20)
    tip_gear = math.acos(gear * math.cos(alpha) / (gear + 2))
    square = (gear + 2) ** 2 + (pinion + gear) ** 2 - 2 * (gear + 2) * (pinion + gear) * math.cos(tip_gear - alpha)
    first = math.tan(math.acos(pinion * math.cos(alpha) / math.sqrt(square)))
    last = math.tan(math.acos(pinion * math.cos(alpha) / (pinion + 2)))
    mesh = contact_path(make_pair((pinion, gear)), 40)
    assert mesh.contact_ratio == pytest.approx((last - first) * pinion / (2 * math.pi), rel=1e-12)


def test_contact_ratio_is_that_of_the_sum_of_the_tip_reaches(meshing):
    pair, mesh = meshing
    working = math.tan(pair.working_pressure_angle)
    tip = np.tan(np.arccos(pair.base_radius / pair.tip_radius))
    assert mesh.contact_ratio == pytest.approx(float(pair.teeth @ (tip - working)) / (2 * math.pi), rel=1e-12)


def test_marks_stand_in_order_and_one_base_pitch_apart(meshing):
    pair, mesh = meshing
    assert 0 < mesh.start_of_contact < mesh.lowest_single_contact < mesh.highest_single_contact < mesh.end_of_contact
    assert mesh.end_of_contact < mesh.line_of_action
    assert mesh.end_of_contact - mesh.lowest_single_contact == pytest.approx(pair.base_pitch, rel=1e-12)
    assert mesh.highest_single_contact - mesh.start_of_contact == pytest.approx(pair.base_pitch, rel=1e-12)
    assert mesh.end_of_contact - mesh.start_of_contact == pytest.approx(mesh.contact_ratio * pair.base_pitch, rel=1e-12)
    assert mesh.pitch_point / mesh.line_of_action == pytest.approx(pair.teeth[0] / pair.teeth.sum(), rel=1e-12)


def test_ends_of_the_path_lie_on_the_tip_circles(meshing):
    pair, mesh = meshing
    assert math.hypot(mesh.end_of_contact, pair.base_radius[0]) == pytest.approx(pair.tip_radius[0], rel=1e-12)
    from_gear = mesh.line_of_action - mesh.start_of_contact
    assert math.hypot(from_gear, pair.base_radius[1]) == pytest.approx(pair.tip_radius[1], rel=1e-12)


def test_path_rises_and_is_doubled_only_where_the_number_of_pairs_changes(meshing):
    _, mesh = meshing
    steps = np.diff(mesh.path)
    assert (steps >= 0).all()
    assert mesh.path[0] == pytest.approx(mesh.start_of_contact, rel=1e-12)
    assert mesh.path[-1] == mesh.end_of_contact
    twice = mesh.path[:-1][steps == 0]
    np.testing.assert_allclose(twice, [mesh.lowest_single_contact, mesh.highest_single_contact], rtol=1e-12)
    left = np.flatnonzero(steps == 0)
    assert (mesh.partner[left] >= 0).tolist() == [True, False]
    assert (mesh.partner[left + 1] >= 0).tolist() == [False, True]


def test_pitch_point_is_a_node_exactly_if_it_is_on_the_path(meshing):
    _, mesh = meshing
    on_path = mesh.start_of_contact < mesh.pitch_point < mesh.end_of_contact
    assert (mesh.pitch_point in mesh.path) == on_path


def test_partners_are_one_base_pitch_apart_at_the_same_instant(meshing):
    pair, mesh = meshing
    both = np.flatnonzero(mesh.partner >= 0)
    mate = mesh.partner[both]
    np.testing.assert_array_equal(mesh.partner[mate], both)
    np.testing.assert_allclose(np.abs(mesh.path[mate] - mesh.path[both]), pair.base_pitch, rtol=1e-9)
    np.testing.assert_array_equal(mesh.path_phase[mate], mesh.path_phase[both])
    inside = (mesh.path > mesh.lowest_single_contact) & (mesh.path < mesh.highest_single_contact)
    assert (mesh.partner[inside] == -1).all()


def test_phase_tells_the_place_of_both_pairs(meshing):
    pair, mesh = meshing
    place = mesh.start_of_contact + mesh.mesh_phase * pair.base_pitch
    np.testing.assert_allclose(mesh.path[mesh.entering], place, rtol=1e-9)
    double = mesh.mesh_phase < mesh.contact_ratio - 1
    np.testing.assert_array_equal(mesh.leaving >= 0, double)
    np.testing.assert_allclose(mesh.path[mesh.leaving[double]], (place + pair.base_pitch)[double], rtol=1e-9)
    np.testing.assert_array_equal(mesh.partner[mesh.entering[double]], mesh.leaving[double])
    np.testing.assert_array_equal(mesh.path_phase[mesh.entering], mesh.mesh_phase)


def test_cells_fill_the_period_with_the_change_of_zone_on_an_edge(meshing):
    _, mesh = meshing
    edges = np.concatenate([[0.0], np.cumsum(mesh.mesh_phase_width)])
    assert edges[-1] == pytest.approx(1.0, abs=1e-13)
    assert np.abs(edges - (mesh.contact_ratio - 1)).min() < 1e-13
    np.testing.assert_allclose((edges[:-1] + edges[1:]) / 2, mesh.mesh_phase, atol=1e-13)
    assert abs(len(mesh.mesh_phase) - 120) <= 4
    assert ((mesh.mesh_phase > 0) & (mesh.mesh_phase < 1)).all()


def test_number_of_cells_follows_the_setting(make_pair):
    pair = make_pair((19, 48))
    counts = [len(contact_path(pair, cells).mesh_phase) for cells in (16, 80, 240)]
    np.testing.assert_allclose(counts, [16, 80, 240], atol=2)


@pytest.mark.parametrize(
    ("settings", "quantity", "value", "limit"),
    [
        ({"addendum": (0.5, 0.5)}, "contact ratio", "0.8878", "between 1 and 2"),
        ({"teeth": (60, 80), "addendum": (1.3, 1.3)}, "contact ratio", "2.2939", "between 1 and 2"),
        ({"teeth": (12, 80)}, "tip of the gear", "1.2856 mm", "beyond the base tangent point"),
        ({"teeth": (80, 12)}, "tip of the pinion", "1.2856 mm", "beyond the base tangent point"),
    ],
)
def test_a_path_without_regular_contact_is_refused(make_pair, settings, quantity, value, limit):
    pair = make_pair(**({"teeth": (19, 48), "module": 2e-3, "bore": (5e-3, 5e-3)} | settings))
    with pytest.raises(ValueError, match=r"^gear_pair") as refusal:
        contact_path(pair, 40)
    for part in (quantity, value, limit):
        assert part in str(refusal.value)


def test_marks_of_the_fzg_pair(make_pair):
    mesh = contact_path(make_pair(**PAIRS["fzg"]), 40)
    assert mesh.contact_ratio == pytest.approx(1.46, abs=0.005)
