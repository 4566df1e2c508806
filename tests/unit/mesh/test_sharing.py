"""Load sharing against a bisection of the force balance, closed forms and invariances."""

import numpy as np
import pytest
import xarray as xr

from gearwear.geometry.contact_path import contact_path
from gearwear.geometry.deviations import spacing, tip_relief
from gearwear.mesh.sharing import Springs, removed_by_heat, share, transmission
from gearwear.mesh.stiffness import Flanks, mesh_stiffness, pair_stiffness
from gearwear.oscillator.harmonics import mean_over_mesh

SETTINGS = {
    "cantilever": "base",
    "fillet_angle": "rack",
    "hertz": "linear",
    "profile_changes": "paper",
    "pairs": "plain",
    "foundation_coupling": 0.3,
}
FORCE = 4000.0


def two(k1, k2, coupling=0.0):
    """Return two pairs in contact with each other."""
    return Springs(np.array([k1, k2]), np.full(2, coupling), np.array([1, 0]))


def loads(springs, removed, force):
    found = share(springs, np.array(removed, dtype=float), force)
    return found, found.load_share * force


def test_balance_of_forces_is_that_of_a_bisection():
    rng = np.random.default_rng(2)
    for _ in range(200):
        stiffness, removed, force = rng.uniform(1e8, 3e8, 2), rng.uniform(0, 30e-6, 2), rng.uniform(100, 6000)
        low, high = 0.0, 1e-3
        for _ in range(80):
            middle = (low + high) / 2
            carried = stiffness @ np.maximum(0, middle - removed)
            low, high = (middle, high) if carried < force else (low, middle)
        found, load = loads(two(*stiffness), removed, force)
        np.testing.assert_allclose(found.approach, low, rtol=1e-9)
        np.testing.assert_allclose(load, stiffness * np.maximum(0, low - removed), atol=1e-6 * force)
        np.testing.assert_allclose(found.deflection, np.maximum(0, low - removed), atol=1e-12)


def test_shares_of_a_coupled_pair_solve_the_compliance_matrix():
    own, common = np.array([5e-9, 7e-9]), 1.5e-9
    removed = np.array([2e-6, 5e-6])
    found, load = loads(two(*(1 / own), common), removed, FORCE)
    matrix = np.array([[own[0], common], [common, own[1]]])
    np.testing.assert_allclose(matrix @ load, found.approach - removed, rtol=1e-12)
    np.testing.assert_allclose(found.approach[0], found.approach[1], rtol=1e-12)
    assert load.sum() == pytest.approx(FORCE, rel=1e-12)


@pytest.mark.parametrize("coupling", [0.0, 1.5e-9])
def test_second_pair_opens_at_the_threshold_without_a_step(coupling):
    """Pair 2 is free as soon as E2 - E1 exceeds F (C11 - C12): F/k1 without coupling."""
    threshold = FORCE * (1 / 2e8 - coupling)
    gap = 1e-12
    for sign, carried in ((-1, True), (1, False)):
        found, load = loads(two(2e8, 1.8e8, coupling), [0.0, threshold + sign * gap], FORCE)
        assert (load[1] > 0) == carried
        np.testing.assert_allclose(found.approach, FORCE / 2e8, rtol=1e-6)
        np.testing.assert_allclose(load, [FORCE, 0], atol=1e-2)
        assert (found.deflection[1] > 0) == carried


def test_a_common_shift_of_the_removed_material_only_shifts_the_approach():
    removed, shift = np.array([1e-6, 6e-6]), 3e-6
    before, load_before = loads(two(2e8, 1.8e8, 1e-9), removed, FORCE)
    after, load_after = loads(two(2e8, 1.8e8, 1e-9), removed + shift, FORCE)
    np.testing.assert_allclose(after.approach - before.approach, shift, rtol=1e-9)
    np.testing.assert_allclose(load_after, load_before, rtol=1e-9)
    np.testing.assert_allclose(after.deflection, before.deflection, rtol=1e-9)


def test_numbering_of_the_pairs_does_not_matter():
    found, load = loads(two(2e8, 1.8e8, 1e-9), [1e-6, 6e-6], FORCE)
    turned, load_turned = loads(two(1.8e8, 2e8, 1e-9), [6e-6, 1e-6], FORCE)
    np.testing.assert_allclose(load_turned, load[::-1], rtol=1e-12)
    np.testing.assert_allclose(turned.approach, found.approach, rtol=1e-12)


def test_single_pair_carries_all():
    found, load = loads(Springs(np.array([2e8]), np.zeros(1), np.array([-1])), [4e-6], FORCE)
    assert found.load_share == 1
    assert found.approach == pytest.approx(FORCE / 2e8 + 4e-6)
    assert found.deflection == pytest.approx(FORCE / 2e8)


@pytest.mark.parametrize("force", [0.0, -500.0])
def test_open_mesh_carries_nothing_and_stands_at_the_least_worn_pair(force):
    found = share(two(2e8, 1.8e8), np.array([3e-6, 1e-6]), force)
    np.testing.assert_array_equal(found.load_share, 0)
    np.testing.assert_array_equal(found.deflection, 0)
    np.testing.assert_allclose(found.approach, 1e-6)


def test_force_may_differ_from_node_to_node():
    springs = Springs(np.full(4, 2e8), np.zeros(4), np.array([1, 0, -1, -1]))
    force = np.array([FORCE, FORCE, 2 * FORCE, -1.0])
    found = share(springs, np.zeros(4), force)
    np.testing.assert_allclose(found.load_share, [0.5, 0.5, 1, 0])
    np.testing.assert_allclose(found.approach, [FORCE / 4e8, FORCE / 4e8, FORCE / 1e8, 0])


def test_heat_removes_nothing_from_flanks_that_grow_alike():
    even = np.full((2, 5), 3e-6)
    np.testing.assert_allclose(removed_by_heat(even, "relative"), 0, atol=1e-20)
    np.testing.assert_array_equal(removed_by_heat(even, "none"), np.zeros(5))
    np.testing.assert_allclose(removed_by_heat(even, "full_removed"), -6e-6)
    np.testing.assert_allclose(removed_by_heat(even, "full_added"), 12e-6)


def test_relative_heat_is_the_physical_one_but_for_its_least_value():
    growth = 1e-6 * np.array([[5.0, 4.0, 2.0], [2.0, 4.0, 5.0]])
    relative, physical = removed_by_heat(growth, "relative"), removed_by_heat(growth, "full_removed")
    np.testing.assert_allclose(relative, physical - physical.min(), atol=1e-18)
    assert relative.min() == 0


@pytest.fixture(scope="module")
def mesh(benchmark_pair):
    """Geometry and stiffness dataset of the cold benchmark pair."""
    n = benchmark_pair.sizes["path"]
    steel = np.full(2, 206e9), np.full(2, 0.3)
    pairs = pair_stiffness(benchmark_pair, *steel, Flanks(*np.zeros((2, 2, n))), SETTINGS)
    both = benchmark_pair["entering"].values, benchmark_pair["leaving"].values
    values = {
        "pair_stiffness": ("path", pairs.pair_stiffness),
        "pair_coupling": ("path", pairs.coupling),
        "mesh_stiffness": ("mesh_phase", mesh_stiffness(pairs, *both)),
    }
    return benchmark_pair, xr.Dataset(values)


def state(mesh, wear, growth, mode="loaded", heat="relative", in_sharing=False, made=0.0, force=FORCE):
    return transmission(*mesh, wear, growth, force, mode, heat, in_sharing, made)


@pytest.fixture(scope="module")
def new(mesh, make_pair):
    """Return a function that gives the state of the new pair with relief of both gears and errors of spacing (m)."""
    pair = make_pair((19, 48), 3.175e-3, 16e-3, bore=(10e-3, 25e-3))
    contact, none = contact_path(pair, 240), np.zeros((2, mesh[0].sizes["path"]))

    def of(relief=0.0, error=0.0, difference=0.0, length=1.0, **settings):
        both = {gear: {"amount": relief, "length": length, "exponent": 1.0} for gear in ("pinion", "gear")}
        made = tip_relief(contact, both).sum(axis=0) + spacing(contact, pair.base_pitch, error, difference)
        return state(mesh, none, none, made=made, **settings)

    return of


@pytest.fixture
def flanks(mesh):
    """Wear largest at the ends of the path, growth falling for the pinion and rising for the gear."""
    s = np.linspace(-1, 1, mesh[0].sizes["path"])
    return 3e-6 * np.stack([s**2 + 0.1, s**2 / 2 + 0.1]), 1e-6 * np.stack([4 - s, 4 + s / 2])


def test_ideal_mesh_deflects_by_force_over_mesh_stiffness(mesh):
    geometry, stiffness = mesh
    none = np.zeros((2, geometry.sizes["path"]))
    found = state(mesh, none, none)
    k = stiffness["mesh_stiffness"].values
    np.testing.assert_allclose(k * found.transmission_error, FORCE, rtol=1e-12)
    np.testing.assert_allclose(found.effective_stiffness, k, rtol=1e-12)
    np.testing.assert_array_equal(state(mesh, none, none, mode="no_load").transmission_error, 0)


def test_shares_of_both_pairs_make_the_whole(mesh, flanks):
    found = state(mesh, *flanks)
    np.testing.assert_allclose(found.load_sharing_factor.sum(axis=1), 1, rtol=1e-12)
    single = mesh[0]["leaving"].values < 0
    np.testing.assert_array_equal(found.load_sharing_factor[single], np.tile([1.0, 0.0], (single.sum(), 1)))
    assert ((found.load_sharing_factor >= 0) & (found.load_sharing_factor <= 1)).all()


def test_entering_pair_of_an_unworn_mesh_begins_with_about_a_third(mesh):
    none = np.zeros((2, mesh[0].sizes["path"]))
    assert 0.33 < state(mesh, none, none).load_sharing_factor[0, 0] < 0.43


def test_effective_stiffness_is_that_of_the_better_pair(mesh, flanks):
    """K = (k1 + k2)/(1 + k2 E21/F), index 1 the less worn pair, while both carry."""
    geometry, stiffness = mesh
    found = state(mesh, *flanks, heat="none")
    entering, leaving = geometry["entering"].values, geometry["leaving"].values
    both = (leaving >= 0) & (found.load_sharing_factor > 0).all(axis=1)
    assert both.sum() > 20
    k = stiffness["pair_stiffness"].values
    removed = flanks[0].sum(axis=0)
    pairs = np.stack([entering[both], leaving[both]])
    pairs = np.take_along_axis(pairs, np.argsort(removed[pairs], axis=0), axis=0)
    (k1, k2), (e1, e2) = k[pairs], removed[pairs]
    np.testing.assert_allclose(found.effective_stiffness[both], (k1 + k2) / (1 + k2 * (e2 - e1) / FORCE), rtol=1e-9)


def test_wear_raises_the_error_and_lowers_the_effective_stiffness_in_double_contact(mesh, flanks):
    none = np.zeros_like(flanks[0])
    new, worn = state(mesh, none, none), state(mesh, flanks[0], none)
    assert (worn.transmission_error > new.transmission_error).all()
    double = mesh[0]["leaving"].values >= 0
    assert (worn.effective_stiffness[double] < new.effective_stiffness[double] * (1 + 1e-12)).all()
    np.testing.assert_allclose(worn.effective_stiffness[~double], new.effective_stiffness[~double], rtol=1e-12)


def test_wear_unloads_the_pair_that_has_more_of_it(mesh):
    """One worn node: the pair there hands load to its partner, both on the drive flanks alone."""
    geometry, none = mesh[0], np.zeros((2, mesh[0].sizes["path"]))
    node = int(geometry["entering"].values[0])
    partner = int(geometry["partner"].values[node])
    new = state(mesh, none, none)
    for gear in (0, 1):
        wear = none.copy()
        wear[gear, node] = 2e-6
        worn = state(mesh, wear, none)
        assert worn.sharing_error[node] == 2e-6
        assert worn.load_share_path[node] < new.load_share_path[node] - 0.01
        assert worn.load_share_path[partner] > new.load_share_path[partner] + 0.01


def test_sign_of_heat_in_the_error_follows_the_setting(mesh, flanks):
    none, growth = np.zeros_like(flanks[0]), flanks[1]
    width = mesh[0]["mesh_phase_width"].values

    def mean(heat):
        return mean_over_mesh(state(mesh, none, growth, heat=heat).transmission_error, width)

    assert mean("full_removed") < mean("none") < mean("relative") < mean("full_added")


def test_heat_enters_load_sharing_only_if_asked(mesh, flanks):
    wear, growth = flanks
    cold = state(mesh, wear, np.zeros_like(growth))
    without, included = state(mesh, wear, growth), state(mesh, wear, growth, in_sharing=True)
    for name in ("load_sharing_factor", "load_share_path", "elastic_deflection", "sharing_error"):
        np.testing.assert_array_equal(getattr(without, name), getattr(cold, name))
    assert (included.load_share_path != without.load_share_path).any()
    np.testing.assert_array_equal(included.sharing_error, included.profile_error)
    np.testing.assert_array_equal(included.transmission_error, without.transmission_error)


def test_error_without_load_is_the_limit_of_a_vanishing_force(mesh, flanks):
    light = transmission(*mesh, *flanks, 1e-6, "loaded", "relative", False).transmission_error
    np.testing.assert_allclose(state(mesh, *flanks, mode="no_load").transmission_error, light, atol=1e-13)


def test_paths_and_phases_tell_one_story(mesh, flanks):
    found, entering = state(mesh, *flanks), mesh[0]["entering"].values
    np.testing.assert_array_equal(found.load_sharing_factor[:, 0], found.load_share_path[entering])
    springs = mesh[1]["pair_stiffness"].values
    np.testing.assert_allclose(found.elastic_deflection * springs, found.load_share_path * FORCE, atol=1e-9 * FORCE)


def test_a_pair_without_deviations_is_that_without_the_argument_to_the_last_bit(new, mesh):
    none = np.zeros((2, mesh[0].sizes["path"]))
    for one, other in zip(new(), state(mesh, none, none), strict=True):
        np.testing.assert_array_equal(one, other)


def test_long_relief_of_the_deflection_of_one_pair_smooths_the_error_most(new, mesh):
    """The rule of design relief: its amount is about the deflection of the single pair under the design load."""
    deflection = new().transmission_error[mesh[0]["leaving"].values < 0].mean()
    amounts = np.linspace(0, 2, 41)
    swings = [np.ptp(new(amount * deflection).transmission_error) for amount in amounts]
    best = int(np.argmin(swings))
    assert 0.9 < amounts[best] < 1.1
    assert swings[best] < 0.25 * swings[0] and swings[best] < 0.25 * swings[-1]
    assert (np.diff(swings[: best + 1]) < 0).all() and (np.diff(swings[best:]) > 0).all()


def test_short_relief_leaves_the_error_without_load_at_nothing(new):
    np.testing.assert_allclose(new(20e-6, length=0.5, mode="no_load").transmission_error, 0, atol=1e-20)
    assert new(20e-6, mode="no_load").transmission_error.max() > 5e-6


def test_relief_that_the_load_cannot_close_shortens_the_contact(new, mesh):
    """A pair takes part only where it lacks less than the other pair alone approaches."""
    geometry, stiffness = mesh
    found, both = new(60e-6), geometry["leaving"].values >= 0
    lacks, k = found.sharing_error, stiffness["pair_stiffness"].values
    entering, leaving = geometry["entering"].values[both], geometry["leaving"].values[both]
    for own, other, column in ((entering, leaving, 0), (leaving, entering, 1)):
        touches = lacks[own] < FORCE / k[other] + lacks[other]
        assert 0 < touches.sum() < both.sum()
        np.testing.assert_array_equal(found.load_sharing_factor[both, column] > 0, touches)
        np.testing.assert_array_equal(found.elastic_deflection[own[~touches]], 0)
    np.testing.assert_allclose(found.load_sharing_factor.sum(axis=1), 1, rtol=1e-12)


@pytest.mark.parametrize("error", [4e-6, -4e-6])
def test_spacing_shifts_load_as_the_balance_of_two_springs_says(new, mesh, error):
    geometry, stiffness = mesh
    found, both = new(error=error), geometry["leaving"].values >= 0
    k1, k2 = (stiffness["pair_stiffness"].values[geometry[name].values[both]] for name in ("entering", "leaving"))
    np.testing.assert_allclose(found.load_sharing_factor[both, 0], k1 * (1 + k2 * error / FORCE) / (k1 + k2))
    np.testing.assert_allclose(found.transmission_error[both], (FORCE + k2 * error) / (k1 + k2))
    np.testing.assert_array_equal(found.transmission_error[~both], new().transmission_error[~both])
    better = min(error, 0.0)
    np.testing.assert_allclose(new(error=error, mode="no_load").transmission_error[both], better, atol=1e-20)


def test_spacing_and_unlike_base_pitches_share_the_load_alike_and_differ_in_the_error(new, mesh):
    step, ramp = new(error=4e-6), new(difference=4e-6)
    np.testing.assert_allclose(ramp.load_sharing_factor, step.load_sharing_factor, atol=1e-12)
    np.testing.assert_allclose(ramp.effective_stiffness, step.effective_stiffness, rtol=1e-12)
    shift = ramp.transmission_error - step.transmission_error
    np.testing.assert_allclose(np.diff(shift), 4e-6 * np.diff(mesh[0]["mesh_phase"].values), atol=1e-18)


def test_spacing_beyond_the_deflection_leaves_one_pair_alone(new, mesh):
    both = mesh[0]["leaving"].values >= 0
    np.testing.assert_array_equal(new(error=100e-6).load_sharing_factor[both], np.tile([1.0, 0.0], (both.sum(), 1)))
    np.testing.assert_array_equal(new(error=-100e-6).load_sharing_factor[both], np.tile([0.0, 1.0], (both.sum(), 1)))
