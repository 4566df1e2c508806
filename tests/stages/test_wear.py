"""The stages of the wear and the response that drives it, on a coarse grid."""

import numpy as np
import pytest

PITCH = "pitch_point"


def path_mean(dataset, name, geometry):
    """Return the mean over the mesh of a quantity on the mesh phases."""
    return float(dataset[name].values @ geometry["mesh_phase_width"].values)


def test_unworn_flanks_have_no_wear(states):
    wear = states("with")["wear"]
    assert not wear["wear_depth"].values.any()
    assert float(wear["running_cycles"]) == 0.0


def test_first_block_of_wear(states, advance):
    state = states("with")
    geometry, wear = state["geometry"], advance(state)
    depth, path = wear["wear_depth"].values, geometry["path"].values
    assert float(wear["running_cycles"]) == 1e8
    assert depth.min() >= 0
    pitch = int(np.argmin(abs(path - float(geometry[PITCH]))))
    assert depth[:, pitch].max() < 1e-9 * depth.max()
    assert depth[0].argmax() == 0
    assert path[depth[1].argmax()] < float(geometry[PITCH])
    assert 1e-7 < depth.max() < 1e-5
    assert depth == pytest.approx(1e8 * wear["wear_per_revolution"].values, rel=1e-14, abs=0)
    for i in (int(np.flatnonzero(np.diff(path) == 0)[0]), int(np.flatnonzero(np.diff(path) == 0)[1])):
        assert abs(depth[0, i + 1] - depth[0, i]) > 0.1 * max(depth[0, i : i + 2])


def test_wear_adds_up(states, worn, advance):
    state = worn("with")
    before = state["wear"]
    after = advance(state)
    added = after["wear_depth"].values - before["wear_depth"].values
    assert added == pytest.approx(1e8 * after["wear_per_revolution"].values, abs=1e-18)
    assert float(after["running_cycles"]) == 2e8


def test_cycles_per_update_scale_the_block(states, advance):
    state = states("with")
    base, half = advance(state), advance(state, wear__cycles_per_update=5e7)
    assert half["wear_depth"].values == pytest.approx(base["wear_depth"].values / 2, rel=1e-12, abs=0)
    assert float(half["running_cycles"]) == 5e7


def test_constant_coefficient_is_a_straight_line_of_archard(states, advance):
    state = states("with")
    geometry = state["geometry"]
    wear = advance(state, wear__law="constant", wear__coefficient=3e-20)
    speed = state["temperature"]["surface_speed"].values
    per_width = state["transmission_error"]["load_share_path"].values * (
        130.0 / float(geometry["base_radius"][0]) / float(geometry["face_width"])
    )
    expected = 3e-20 * per_width * abs(1 - speed[::-1] / speed) * np.array([[1.0], [19 / 48]])
    assert wear["wear_per_revolution"].values == pytest.approx(expected, rel=1e-12, abs=1e-30)
    assert not np.array_equal(wear["wear_depth"].values, advance(state)["wear_depth"].values)


def test_coefficient_is_read_by_its_law_only(states, advance):
    state = states("with")
    assert np.array_equal(
        advance(state, wear__coefficient=9e-20)["wear_depth"].values, advance(state)["wear_depth"].values
    )


def test_peak_pressure_wears_four_over_pi_times_as_deep(states, advance):
    state = states("with")
    peak = advance(state, wear__pressure="peak")["wear_depth"].values
    assert peak == pytest.approx(4 / np.pi * advance(state)["wear_depth"].values, rel=1e-12, abs=0)


def test_gear_cycles_change_the_gear_alone(states, advance):
    state = states("with")
    ratio = advance(state, wear__gear_cycles="pinion")["wear_depth"].values
    base = advance(state)["wear_depth"].values
    assert np.array_equal(ratio[0], base[0])
    assert ratio[1] == pytest.approx(48 / 19 * base[1], rel=1e-12, abs=0)


def test_quasi_static_force_forgets_the_response(states, advance):
    state = states("with")
    n = state["geometry"].sizes["path"]
    static = advance(state)["wear_depth"].values
    rough = np.full(n, 9000.0)
    assert advance(state, force=rough, wear__force="quasi_static")["wear_depth"].values == pytest.approx(
        static, rel=1e-12, abs=0
    )
    dynamic = advance(state, force=rough)["wear_depth"].values
    assert dynamic.max() > 2 * static.max()


def test_separated_teeth_and_back_contact_do_not_wear(states, advance):
    state = states("with")
    n = state["geometry"].sizes["path"]
    assert not advance(state, force=np.zeros(n))["wear_depth"].values.any()
    assert not advance(state, force=np.full(n, -4000.0))["wear_depth"].values.any()


def test_wear_of_many_periods_is_the_mean_of_their_wear(states, advance):
    state = states("with")
    n = state["geometry"].sizes["path"]
    forces = [2000.0, 0.0, 7000.0]
    alone = [advance(state, force=np.full(n, force))["wear_depth"].values for force in forces]
    together = advance(state, force=np.outer(forces, np.ones(n)))["wear_depth"].values
    assert together == pytest.approx(np.mean(alone, axis=0), rel=1e-12, abs=1e-20)
    mean_force = advance(state, force=np.full(n, np.mean(forces)))["wear_depth"].values
    assert together.max() > 1.5 * mean_force.max()


def test_worn_pair_gives_load_away_and_wears_less(study, states, worn, run_stage, advance):
    pristine, state = states("with"), worn("with")
    state["transmission_error"] = run_stage("transmission_error", study(), "with", state)
    first, later = (advance(one)["wear_per_revolution"].values for one in (pristine, state))
    assert later[0, 0] < 0.9 * first[0, 0]
    assert (later[0] > first[0]).any()


def test_oil_decides_the_wear(states, advance):
    state = states("with")
    base = advance(state)["wear_depth"].values.max()
    assert advance(state, lubricant__pressure_viscosity=2.2e-8)["wear_depth"].values.max() > 2 * base
    assert advance(state, lubricant__composite_roughness=1e-6)["wear_depth"].values.max() > 2 * base
    assert advance(state, lubricant__dynamic_viscosity=0.05)["wear_depth"].values.max() < base


def test_a_block_of_cycles_that_overshoots_is_refused(states, advance):
    with pytest.raises(ValueError, match="wear.cycles_per_update: .* overshoot above 0.9; give at most"):
        advance(states("with"), lubricant__pressure_viscosity=1.5e-8)


def test_hot_steel_wears_faster_through_its_modulus(states, advance):
    state = states("with")
    hot, constant = (advance(state, elasticity__law=law)["wear_per_revolution"].values for law in ("li", "constant"))
    # k ~ E'^-9.6 apart from the film: 2.6 % of modulus are a quarter of wear
    assert hot.max() / constant.max() == pytest.approx(0.974**-9.6, rel=0.03, abs=0)


@pytest.fixture(scope="session")
def answered(study, states, with_reference, run_stage):
    """Return a function that gives the state of a case with its response."""

    def of(case):
        state = states(case)
        return state | {"response": run_stage("response", study(), case, with_reference(state))}

    return of


@pytest.mark.parametrize("case", ["without", "with"])
def test_mean_of_the_dynamic_force_is_the_static_one(answered, case):
    # over a closed orbit neither inertia nor damping leaves a mean
    state = answered(case)
    response, geometry = state["response"], state["geometry"]
    static = 130.0 / float(geometry["base_radius"][0])
    assert float(response["mean_force"]) == pytest.approx(static, rel=1e-12, abs=0)
    assert path_mean(response, "mesh_force", geometry) == pytest.approx(static, rel=2e-3, abs=0)
    force, partner = response["mesh_force_path"].values, geometry["partner"].values
    both = np.flatnonzero(partner >= 0)
    assert force[:, both] == pytest.approx(force[:, partner[both]], rel=1e-9, abs=0)


def test_chain_closes_with_the_first_block_of_dynamic_wear(study, answered, run_stage, advance):
    state = answered("with")
    dynamic = run_stage("wear", study(), "with", state)
    assert float(dynamic["running_cycles"]) == 1e8
    static = advance(state)["wear_depth"].values
    depth, force = dynamic["wear_depth"].values, state["response"]["mesh_force_path"].values
    mesh = 130.0 / float(state["geometry"]["base_radius"][0])
    worn_there = static > 1e-3 * static.max()
    more = np.broadcast_to(force.mean(axis=0) > mesh, depth.shape)
    assert (depth[worn_there & more] > static[worn_there & more]).all()
    assert (depth[worn_there & ~more] < static[worn_there & ~more]).all()
    assert worn_there.sum() > 100
