"""Pair and mesh stiffness: composition, scaling, profile changes, coupled pairs and the Weber contact."""

import math
from functools import partial

import numpy as np
import pytest

from gearwear.geometry.kinematics import curvature
from gearwear.mesh.cantilever import load_angle, tooth_compliance
from gearwear.mesh.stiffness import Flanks, mesh_stiffness, pair_stiffness
from gearwear.oscillator.harmonics import harmonics

PLAIN = {
    "cantilever": "base",
    "fillet_angle": "rack",
    "hertz": "linear",
    "profile_changes": "paper",
    "pairs": "plain",
    "foundation_coupling": 0.3,
}
STEEL = np.full(2, 206e9), np.full(2, 0.3)


def uniform(geometry, wear=0.0, growth=0.0):
    ones = np.ones((2, geometry.sizes["path"]))
    return Flanks(wear * ones, growth * ones)


def of(geometry, modulus=206e9, force=0.0, wear=0.0, growth=0.0, **settings):
    modulus = np.broadcast_to(modulus, 2)
    flanks = uniform(geometry, wear, growth)
    return pair_stiffness(geometry, modulus, np.full(2, 0.3), flanks, PLAIN | settings, force)


def mesh_of(geometry, **changes):
    return mesh_stiffness(of(geometry, **changes), geometry["entering"].values, geometry["leaving"].values)


def test_pair_is_the_series_of_its_parts(benchmark_pair):
    found = of(benchmark_pair)
    compliance = found.hertz + sum(
        part.sum(axis=0) for part in (found.bending, found.shear, found.axial, found.foundation)
    )
    np.testing.assert_allclose(found.pair_stiffness * compliance, 1, rtol=1e-12)
    np.testing.assert_allclose(found.hertz, 4 * (1 - 0.3**2) / (math.pi * 206e9 * 16e-3), rtol=1e-12)
    np.testing.assert_array_equal(found.coupling, 0)


@pytest.mark.parametrize("settings", [{}, {"cantilever": "root"}, {"pairs": "coupled"}])
def test_stiffness_does_not_depend_on_the_module(make_geometry, settings):
    small = make_geometry((19, 48), 2e-3, bore=(8e-3, 16e-3), mesh_cells=40)
    large = make_geometry((19, 48), 5e-3, bore=(20e-3, 40e-3), mesh_cells=40)
    np.testing.assert_allclose(of(small, **settings).pair_stiffness, of(large, **settings).pair_stiffness, rtol=1e-10)


@pytest.mark.parametrize("settings", [{}, {"cantilever": "root"}, {"pairs": "coupled"}])
def test_stiffness_is_proportional_to_modulus_and_face_width(make_geometry, settings):
    narrow = make_geometry((19, 48), face_width=10e-3, mesh_cells=40)
    wide = make_geometry((19, 48), face_width=30e-3, mesh_cells=40)
    reference = mesh_of(narrow, **settings)
    np.testing.assert_allclose(mesh_of(wide, **settings), 3 * reference, rtol=1e-12)
    np.testing.assert_allclose(mesh_of(narrow, modulus=103e9, **settings), reference / 2, rtol=1e-12)


def test_a_softer_gear_softens_only_its_own_tooth_and_the_contact(benchmark_pair):
    even, uneven = of(benchmark_pair), of(benchmark_pair, modulus=(206e9, 103e9))
    for name in ("bending", "shear", "axial", "foundation"):
        np.testing.assert_array_equal(getattr(uneven, name)[0], getattr(even, name)[0])
        np.testing.assert_allclose(getattr(uneven, name)[1], 2 * getattr(even, name)[1], rtol=1e-12)
    np.testing.assert_allclose(uneven.hertz, 1.5 * even.hertz, rtol=1e-12)


def test_exchanged_gears_turn_the_path_round(make_geometry):
    one = make_geometry((19, 48), bore=(10e-3, 25e-3), mesh_cells=40)
    other = make_geometry((48, 19), bore=(25e-3, 10e-3), mesh_cells=40)
    s = float(one["line_of_action"]) - one["path"].values
    expected = np.interp(s, other["path"], of(other).pair_stiffness)
    np.testing.assert_allclose(of(one).pair_stiffness, expected, rtol=1e-4)


def test_equal_gears_are_symmetric_inside_each_zone(make_geometry):
    geometry = make_geometry((50, 50))
    k = mesh_of(geometry)
    double = geometry["leaving"].values >= 0
    for zone in (k[double], k[~double]):
        np.testing.assert_allclose(zone, zone[::-1], rtol=1e-10)
    _, phase = harmonics(k, geometry["mesh_phase"].values, geometry["mesh_phase_width"].values, 1)
    assert phase[0] == pytest.approx(-math.pi * (float(geometry["contact_ratio"]) - 1), abs=1e-9)
    assert phase[0] == pytest.approx(-2.3709, abs=5e-5)


def test_wear_softens_growth_stiffens_and_a_lower_modulus_softens(benchmark_pair):
    new = mesh_of(benchmark_pair)
    assert (mesh_of(benchmark_pair, wear=50e-6) < new).all()
    assert (mesh_of(benchmark_pair, growth=10e-6) > new).all()
    assert (mesh_of(benchmark_pair, modulus=200e9) < new).all()


def test_size_of_the_changes_by_wear_and_heat(make_geometry):
    """25/30, module 3 mm, width 20 mm, bore 15 mm; per cent in single and double contact.

    The wear is 50 um across the tooth axis on the whole active flank, here and only here down to the base circle.
    """
    geometry = make_geometry((25, 30), bore=(15e-3, 15e-3))
    entering, leaving = geometry["entering"].values, geometry["leaving"].values
    new = of(geometry)

    def change(pairs):
        ratio = 100 * (mesh_stiffness(pairs, entering, leaving) / mesh_stiffness(new, entering, leaving) - 1)
        return ratio[leaving < 0].mean(), ratio[leaving >= 0].mean()

    def worn(mode):
        compliance, removed = 1 / new.pair_stiffness, -50e-6
        for i in range(2):
            base, half = float(geometry["base_radius"][i]), float(geometry["base_half_angle"][i])
            a1 = load_angle(curvature(geometry)[0][i], base, half)
            arm = removed * np.sin(a1) / base * (1 if mode == "paper" else -1 / 2)
            section = partial(uniformly_thinner, removed / (2 * base), mode)
            thin, full = tooth_compliance(a1, half, 0.3, arm, section), tooth_compliance(a1, half, 0.3)
            compliance = compliance + (sum(thin) - sum(full)) / (206e9 * 20e-3)
        return new._replace(pair_stiffness=1 / compliance)

    np.testing.assert_allclose(change(worn("paper")), (-0.31, -0.55), atol=0.0051)
    np.testing.assert_allclose(change(worn("exact")), (-0.25, -0.38), atol=0.0051)
    np.testing.assert_allclose(change(of(geometry, growth=10e-6)), (0.12, 0.21), atol=0.0051)
    np.testing.assert_allclose(change(of(geometry, modulus=200e9)), (100 * (200 / 206 - 1),) * 2, rtol=1e-9)
    np.testing.assert_array_less(change(worn("paper")), change(of(geometry, wear=50e-6)))


def uniformly_thinner(amount, mode, section):
    """H of a uniform removal; the printed form has a cosine more."""
    return amount * (np.cos(section) if mode == "paper" else np.ones_like(section))


def test_changes_of_the_profile_may_be_switched_off(benchmark_pair):
    new = of(benchmark_pair)
    same = of(benchmark_pair, wear=50e-6, growth=10e-6, profile_changes="off")
    np.testing.assert_allclose(same.pair_stiffness, new.pair_stiffness, rtol=1e-14)
    for mode in ("paper", "exact"):
        np.testing.assert_array_equal(of(benchmark_pair, profile_changes=mode).pair_stiffness, new.pair_stiffness)


@pytest.mark.parametrize("mode", ["paper", "exact"])
@pytest.mark.parametrize("gear", [0, 1])
def test_local_wear_and_growth_enter_moment_arm_and_section(benchmark_pair, mode, gear):
    """Bending by a fine midpoint sum with D and H written out; h_wd = -h cos."""
    geometry = benchmark_pair
    s = np.linspace(0, 1, geometry.sizes["path"])
    wear, growth = 80e-6 * s * (1 - s) * np.ones((2, 1)), np.stack([5e-6 - 3e-6 * s, 2e-6 + 3e-6 * s])
    found = pair_stiffness(geometry, *STEEL, Flanks(wear, growth), PLAIN | {"profile_changes": mode})
    radii, _ = curvature(geometry)
    base, half = float(geometry["base_radius"][gear]), float(geometry["base_half_angle"][gear])
    order = np.argsort(radii[gear], kind="stable")
    known = radii[gear][order] / base

    def bending(node):
        a1 = float(load_angle(radii[gear][node], base, half))
        removed, grown = -wear[gear][node] * math.cos(a1), growth[gear][node]
        if mode == "paper":
            arm = (removed + 2 * grown * math.cos(a1)) * math.sin(a1) / base
        else:
            arm = -removed * math.sin(a1) / (2 * base)

        edges = np.linspace(-a1, half, 200001)
        a = (edges[1:] + edges[:-1]) / 2
        h = np.interp(half - a, known, wear[gear][order], left=0.0)
        change = -h * np.cos(a) + 2 * np.interp(half - a, known, growth[gear][order]) * np.cos(a)
        section = change / (2 * base) * (np.cos(a) if mode == "paper" else 1.0)
        thickness = np.sin(a) + (half - a) * np.cos(a) + section
        lever = 1 - arm - math.cos(a1) * (np.cos(a) - (half - a) * np.sin(a))
        return np.mean(1.5 * lever**2 * (half - a) * np.cos(a) / thickness**3) * (half + a1)

    for node in (5, geometry.sizes["path"] // 2, -6):
        assert found.bending[gear][node] * 206e9 * 16e-3 == pytest.approx(bending(node), rel=1e-5)


def test_wear_does_not_thin_the_tooth_below_the_start_of_contact(benchmark_pair):
    """A tooth loaded at the start of contact is worn nowhere below the load: only its moment arm changes."""
    flanks = uniform(benchmark_pair, wear=50e-6)
    found = pair_stiffness(benchmark_pair, *STEEL, flanks, PLAIN)
    new = of(benchmark_pair)
    np.testing.assert_array_equal(found.shear[0][0], new.shear[0][0])
    assert found.shear[0][-1] > new.shear[0][-1]
    np.testing.assert_array_equal(found.shear[1][-1], new.shear[1][-1])


def test_wear_of_one_flank_leaves_the_other_gear_alone(benchmark_pair):
    flanks = uniform(benchmark_pair, wear=50e-6)
    flanks.wear[1] = 0
    found, new = pair_stiffness(benchmark_pair, *STEEL, flanks, PLAIN), of(benchmark_pair)
    np.testing.assert_array_equal(found.bending[1], new.bending[1])
    assert (found.shear[0][1:] > new.shear[0][1:]).all()


def test_mesh_is_the_sum_of_pairs_and_jumps_where_their_number_changes(benchmark_pair):
    found = of(benchmark_pair)
    entering, leaving = benchmark_pair["entering"].values, benchmark_pair["leaving"].values
    k = mesh_stiffness(found, entering, leaving)
    double = leaving >= 0
    np.testing.assert_array_equal(k[~double], 1 / (1 / found.pair_stiffness[entering[~double]]))
    summed = found.pair_stiffness[entering[double]] + found.pair_stiffness[leaving[double]]
    np.testing.assert_allclose(k[double], summed, rtol=1e-12)
    assert k[double].min() > 1.3 * k[~double].max()


def test_without_coupling_the_matrix_form_is_the_plain_sum(benchmark_pair):
    uncoupled = mesh_of(benchmark_pair, pairs="coupled", foundation_coupling=0.0)
    np.testing.assert_allclose(uncoupled, mesh_of(benchmark_pair), rtol=1e-12)


def test_coupled_pairs_are_the_inverse_of_the_compliance_matrix(benchmark_pair):
    found = of(benchmark_pair, pairs="coupled", foundation_coupling=0.6)
    entering, leaving = benchmark_pair["entering"].values, benchmark_pair["leaving"].values
    k = mesh_stiffness(found, entering, leaving)
    body = found.foundation.sum(axis=0)
    for phase in np.flatnonzero(leaving >= 0)[::20]:
        pairs = [entering[phase], leaving[phase]]
        common = 0.6 * math.sqrt(body[pairs].prod())
        matrix = np.diag(1 / found.pair_stiffness[pairs]) + common * (1 - np.eye(2))
        assert k[phase] == pytest.approx(np.linalg.inv(matrix).sum(), rel=1e-10)
        np.testing.assert_allclose(found.coupling[pairs], common, rtol=1e-12)
    single = benchmark_pair["partner"].values < 0
    np.testing.assert_array_equal(found.coupling[single], 0)


def test_a_foundation_shared_completely_is_in_series_with_the_parallel_teeth(make_geometry):
    """Equal gears at the middle of the double zone: both foundations are alike, K = 1/(t/2 + q)."""
    geometry = make_geometry((50, 50), mesh_cells=240)
    found = of(geometry, pairs="coupled", foundation_coupling=1.0)
    entering, leaving = geometry["entering"].values, geometry["leaving"].values
    middle = np.argmin(abs(geometry["mesh_phase"].values - (float(geometry["contact_ratio"]) - 1) / 2))
    body = found.foundation.sum(axis=0)
    k = mesh_stiffness(found, entering, leaving)[middle]
    tooth = 1 / found.pair_stiffness - body
    one, two = tooth[entering[middle]], tooth[leaving[middle]]
    shared = body[entering[middle]]
    assert body[leaving[middle]] == pytest.approx(shared, rel=1e-9, abs=0)
    assert k == pytest.approx(1 / (one * two / (one + two) + shared), rel=1e-9)


def test_coupling_softens_double_contact_only(benchmark_pair):
    plain, coupled = mesh_of(benchmark_pair), mesh_of(benchmark_pair, pairs="coupled")
    double = benchmark_pair["leaving"].values >= 0
    assert (coupled[double] < plain[double]).all()
    np.testing.assert_array_equal(coupled[~double], plain[~double])
    full = mesh_of(benchmark_pair, pairs="coupled", foundation_coupling=1.0)
    assert 0.5 < (full / plain)[double].min() < 0.75


@pytest.mark.parametrize("angle", ["rack", "straight", "generated"])
def test_fillet_angle_sets_the_foundation_only(benchmark_pair, angle):
    found, rack = of(benchmark_pair, fillet_angle=angle), of(benchmark_pair)
    np.testing.assert_array_equal(found.bending, rack.bending)
    assert (found.foundation == rack.foundation).all() == (angle == "rack")


def test_clamp_at_the_root_softens_small_gears_and_stiffens_large_ones(benchmark_pair):
    base, root = of(benchmark_pair), of(benchmark_pair, cantilever="root")
    assert (root.bending[0] > base.bending[0]).all()
    assert (root.bending[1] < base.bending[1]).all()


def weber_compliance(geometry, node, load):
    """Approach over load of the Weber line contact; depths measured in drawn coordinates."""
    radii, reduced = curvature(geometry)
    depths = []
    for i in range(2):
        base, half = float(geometry["base_radius"][i]), float(geometry["base_half_angle"][i])
        roll = radii[i][node] / base
        radius, angle = base * math.hypot(1, roll), half - (roll - math.atan(roll))
        contact = radius * np.array([math.sin(angle), math.cos(angle)])
        a1 = roll - half
        depths.append(contact[0] / math.cos(a1))
    soft = (1 - 0.3**2) / 206e9
    width = float(geometry["face_width"])
    half_width = math.sqrt(8 * load * reduced[node] * soft / (math.pi * width))
    logarithm = math.log(2 * math.sqrt(depths[0] * depths[1]) / half_width) - 0.3 / (2 * 0.7)
    return 4 * soft / (math.pi * width) * logarithm


def test_weber_contact_in_single_contact_carries_the_whole_force(benchmark_pair):
    found = of(benchmark_pair, hertz="weber", force=4600.0)
    for node in np.flatnonzero(benchmark_pair["partner"].values < 0)[::30]:
        assert found.hertz[node] == pytest.approx(weber_compliance(benchmark_pair, node, 4600.0), rel=1e-10, abs=0)


def test_weber_contact_is_three_to_four_times_as_soft_as_the_linear_one(benchmark_pair):
    """The bracket of the formula, 4.2 at 50 N/mm, falls by ln sqrt(10) with ten times the load."""
    single = benchmark_pair["partner"].values < 0
    light, heavy = (of(benchmark_pair, hertz="weber", force=load * 16e-3).hertz[single] for load in (50e3, 500e3))
    linear = of(benchmark_pair).hertz[single]
    np.testing.assert_allclose(light / linear, 4.2, atol=0.1)
    np.testing.assert_allclose((light - heavy) / linear, math.log(10) / 2, rtol=1e-9)


def test_weber_contact_stiffens_with_load(benchmark_pair):
    light, heavy = (of(benchmark_pair, hertz="weber", force=force).pair_stiffness for force in (1e3, 1e4))
    assert (heavy > light).all()
