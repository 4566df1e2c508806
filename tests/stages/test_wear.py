"""The stages of the wear and the response that drives it, on a coarse grid."""

import numpy as np
import pytest

from gearwear.io import store

PITCH = "pitch_point"


def path_mean(dataset, name, geometry):
    """Return the mean over the mesh of a quantity on the mesh phases."""
    return float(dataset[name].values @ geometry["mesh_phase_width"].values)


def test_start_wear_is_no_wear(states, loaded):
    wear = loaded(states("with"), "wear")
    assert not wear["wear_depth"].values.any()
    assert float(wear["running_cycles"]) == 0.0


def test_first_block_of_wear(states, loaded, advance):
    files = states("with")
    geometry, wear = loaded(files, "geometry"), advance(files)
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


def test_wear_adds_up(states, worn, loaded, advance):
    files = worn("with")
    before = loaded(files, "wear")
    after = advance(files)
    added = after["wear_depth"].values - before["wear_depth"].values
    assert added == pytest.approx(1e8 * after["wear_per_revolution"].values, abs=1e-18)
    assert float(after["running_cycles"]) == 2e8


def test_cycles_per_update_scale_the_block(states, advance):
    files = states("with")
    base, half = advance(files), advance(files, wear__cycles_per_update=5e7)
    assert half["wear_depth"].values == pytest.approx(base["wear_depth"].values / 2, rel=1e-12, abs=0)
    assert float(half["running_cycles"]) == 5e7


def test_constant_coefficient_is_a_straight_line_of_archard(states, loaded, advance):
    files = states("with")
    geometry = loaded(files, "geometry")
    wear = advance(files, wear__law="constant", wear__coefficient=3e-20)
    speed = loaded(files, "temperature")["surface_speed"].values
    per_width = loaded(files, "transmission_error")["load_share_path"].values * (
        130.0 / float(geometry["base_radius"][0]) / float(geometry["face_width"])
    )
    expected = 3e-20 * per_width * abs(1 - speed[::-1] / speed) * np.array([[1.0], [19 / 48]])
    assert wear["wear_per_revolution"].values == pytest.approx(expected, rel=1e-12, abs=1e-30)
    assert not np.array_equal(wear["wear_depth"].values, advance(files)["wear_depth"].values)


def test_coefficient_is_read_by_its_law_only(states, advance):
    files = states("with")
    assert np.array_equal(
        advance(files, wear__coefficient=9e-20)["wear_depth"].values, advance(files)["wear_depth"].values
    )


def test_peak_pressure_wears_four_over_pi_times_as_deep(states, advance):
    files = states("with")
    peak = advance(files, wear__pressure="peak")["wear_depth"].values
    assert peak == pytest.approx(4 / np.pi * advance(files)["wear_depth"].values, rel=1e-12, abs=0)


def test_gear_cycles_change_the_gear_alone(states, advance):
    files = states("with")
    ratio = advance(files, wear__gear_cycles="pinion")["wear_depth"].values
    base = advance(files)["wear_depth"].values
    assert np.array_equal(ratio[0], base[0])
    assert ratio[1] == pytest.approx(48 / 19 * base[1], rel=1e-12, abs=0)


def test_quasi_static_force_forgets_the_response(states, loaded, advance):
    files = states("with")
    n = loaded(files, "geometry").sizes["path"]
    static = advance(files)["wear_depth"].values
    rough = np.full(n, 9000.0)
    assert advance(files, force=rough, wear__force="quasi_static")["wear_depth"].values == pytest.approx(
        static, rel=1e-12, abs=0
    )
    dynamic = advance(files, force=rough)["wear_depth"].values
    assert dynamic.max() > 2 * static.max()


def test_separated_teeth_and_back_contact_do_not_wear(states, loaded, advance):
    files = states("with")
    n = loaded(files, "geometry").sizes["path"]
    assert not advance(files, force=np.zeros(n))["wear_depth"].values.any()
    assert not advance(files, force=np.full(n, -4000.0))["wear_depth"].values.any()


def test_wear_of_many_periods_is_the_mean_of_their_wear(states, loaded, advance):
    files = states("with")
    n = loaded(files, "geometry").sizes["path"]
    forces = [2000.0, 0.0, 7000.0]
    alone = [advance(files, force=np.full(n, force))["wear_depth"].values for force in forces]
    together = advance(files, force=np.outer(forces, np.ones(n)))["wear_depth"].values
    assert together == pytest.approx(np.mean(alone, axis=0), rel=1e-12, abs=1e-20)
    mean_force = advance(files, force=np.full(n, np.mean(forces)))["wear_depth"].values
    assert together.max() > 1.5 * mean_force.max()


def test_worn_pair_gives_load_away_and_wears_less(study, states, worn, run_stage, advance):
    pristine, files = states("with"), worn("with")
    files["transmission_error"] = run_stage("transmission_error", study(), "with", files)
    first, later = (advance(one)["wear_per_revolution"].values for one in (pristine, files))
    assert later[0, 0] < 0.9 * first[0, 0]
    assert (later[0] > first[0]).any()


def test_oil_decides_the_wear(states, advance):
    files = states("with")
    base = advance(files)["wear_depth"].values.max()
    assert advance(files, lubricant__pressure_viscosity=2.2e-8)["wear_depth"].values.max() > 2 * base
    assert advance(files, lubricant__composite_roughness=1e-6)["wear_depth"].values.max() > 2 * base
    assert advance(files, lubricant__dynamic_viscosity=0.05)["wear_depth"].values.max() < base


def test_a_block_of_cycles_that_overshoots_is_refused(states, advance):
    with pytest.raises(ValueError, match="wear.cycles_per_update: .* overshoot above 0.9; give at most"):
        advance(states("with"), lubricant__pressure_viscosity=1.5e-8)


def test_hot_steel_wears_faster_through_its_modulus(states, advance):
    files = states("with")
    hot, constant = (advance(files, elasticity__law=law)["wear_per_revolution"].values for law in ("li", "constant"))
    # k ~ E'^-9.6 apart from the film: 2.6 % of modulus are a quarter of wear
    assert hot.max() / constant.max() == pytest.approx(0.974**-9.6, rel=0.03, abs=0)


@pytest.fixture(scope="session")
def answered(study, states, run_stage):
    """Return a function that adds the response of a case to its files."""

    def of(case):
        files, reference = states(case), states("without")
        files["reference_stiffness"] = reference["mesh_stiffness"]
        files["reference_error"] = reference["transmission_error"]
        files["response"] = run_stage("response", study(), case, files)
        return files

    return of


@pytest.mark.parametrize("case", ["without", "with"])
def test_mean_of_the_dynamic_force_is_the_static_one(answered, loaded, case):
    # over a closed orbit neither inertia nor damping leaves a mean
    files = answered(case)
    response, geometry = loaded(files, "response"), loaded(files, "geometry")
    static = 130.0 / float(geometry["base_radius"][0])
    assert float(response["mean_force"]) == pytest.approx(static, rel=1e-12, abs=0)
    assert path_mean(response, "mesh_force", geometry) == pytest.approx(static, rel=2e-3, abs=0)
    force, partner = response["mesh_force_path"].values, geometry["partner"].values
    both = np.flatnonzero(partner >= 0)
    assert force[:, both] == pytest.approx(force[:, partner[both]], rel=1e-9, abs=0)


def test_chain_closes_with_the_first_block_of_dynamic_wear(study, answered, run_stage, loaded, advance):
    files = answered("with")
    dynamic = store.load(run_stage("advance_wear", study(), "with", files))
    assert float(dynamic["running_cycles"]) == 1e8
    static = advance(files)["wear_depth"].values
    depth, force = dynamic["wear_depth"].values, loaded(files, "response")["mesh_force_path"].values
    mesh = 130.0 / float(loaded(files, "geometry")["base_radius"][0])
    worn_there = static > 1e-3 * static.max()
    more = np.broadcast_to(force.mean(axis=0) > mesh, depth.shape)
    assert (depth[worn_there & more] > static[worn_there & more]).all()
    assert (depth[worn_there & ~more] < static[worn_there & ~more]).all()
    assert worn_there.sum() > 100
