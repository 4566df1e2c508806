"""The stage of the mesh stiffness on a coarse grid: heat, wear, foundation, contact."""

import numpy as np
import pytest


def test_wear_only_has_the_stiffness_of_the_cold_pristine_pair(states):
    for stage, name in (("mesh_stiffness", "mesh_stiffness"), ("transmission_error", "transmission_error")):
        cold, dry = (states(case)[stage][name].values for case in ("without", "wear_only"))
        assert np.array_equal(cold, dry)


@pytest.mark.parametrize("law", ["li", "linear", "table", "constant"])
@pytest.mark.parametrize("options", [{}, {"mesh_stiffness__cantilever": "root"}, {"mesh_stiffness__pairs": "coupled"}])
def test_heat_lowers_the_stiffness_by_the_modulus_ratio(states, rerun, law, options):
    settings = {"mesh_stiffness__profile_changes": "off", "elasticity__law": law} | options
    cold, hot = (rerun("mesh_stiffness", case, states(case), **settings) for case in ("without", "with"))
    ratio = hot["youngs_modulus"].values / cold["youngs_modulus"].values
    assert ratio[0] == ratio[1]
    if law == "constant":
        assert ratio[0] == 1.0
    else:
        assert ratio[0] == pytest.approx(0.974, abs=1e-3)
    for name in ("mesh_stiffness", "pair_stiffness"):
        assert hot[name].values / cold[name].values == pytest.approx(
            np.full(cold.sizes[cold[name].dims[0]], ratio[0]), rel=1e-12, abs=0
        )


def test_calibration_softens_the_hot_steel(states, rerun):
    state = states("with")
    moduli = [
        rerun("mesh_stiffness", "with", state, elasticity__calibration=value)["youngs_modulus"].values
        for value in (0.0, 1.0, 5.3, 10.0)
    ]
    assert (np.diff(moduli, axis=0) < 0).all()


def test_tooth_clamped_at_the_root_circle(states, rerun):
    state = states("without")
    base = state["mesh_stiffness"]
    root = rerun("mesh_stiffness", "without", state, mesh_stiffness__cantilever="root")
    geometry = state["geometry"]
    below = geometry["root_radius"].values < geometry["base_radius"].values
    assert below.tolist() == [True, False]
    softer = root["bending_compliance"].values > base["bending_compliance"].values
    assert softer[0].all()
    assert not softer[1].any()


@pytest.mark.parametrize("fillet", ["straight", "generated"])
def test_fillet_angle_acts_through_the_gear_body_alone(states, rerun, fillet):
    state = states("without")
    geometry, rack = state["geometry"], state["mesh_stiffness"]
    other = rerun("mesh_stiffness", "without", state, mesh_stiffness__fillet_angle=fillet)
    assert np.array_equal(rack["bending_compliance"].values, other["bending_compliance"].values)
    wider = geometry["rack_root_angle"].values > geometry[f"{fillet}_root_angle"].values
    stiffer = rack["foundation_compliance"].values < other["foundation_compliance"].values
    for i in range(2):
        assert (stiffer[i] == wider[i]).all()


def test_weber_contact_stiffens_with_load(states, rerun):
    state = states("without")
    light, heavy = (
        rerun("mesh_stiffness", "without", state, mesh_stiffness__hertz="weber", operation__pinion_torque=torque)
        for torque in (60.0, 240.0)
    )
    assert (heavy["mesh_stiffness"].values > light["mesh_stiffness"].values).all()
    linear = state["mesh_stiffness"]
    assert np.ptp(linear["hertz_compliance"].values) == 0
    assert (light["mesh_stiffness"].values < linear["mesh_stiffness"].values).all()


@pytest.mark.parametrize("mode", ["paper", "exact"])
def test_wear_softens_the_mesh(states, worn, rerun, mode):
    settings = {"mesh_stiffness__profile_changes": mode}
    pristine = rerun("mesh_stiffness", "without", states("without"), **settings)["mesh_stiffness"].values
    after = rerun("mesh_stiffness", "without", worn("without"), **settings)["mesh_stiffness"].values
    assert (after < pristine).all()
    assert (after > 0.97 * pristine).all()


def test_profile_changes_off_ignores_wear_and_growth(states, worn, rerun):
    settings = {"mesh_stiffness__profile_changes": "off", "elasticity__law": "constant"}
    cold = rerun("mesh_stiffness", "without", states("without"), **settings)["mesh_stiffness"].values
    assert np.array_equal(rerun("mesh_stiffness", "with", worn("with"), **settings)["mesh_stiffness"].values, cold)


@pytest.mark.parametrize("mode", ["paper", "exact"])
def test_growth_stiffens_the_mesh_at_a_given_modulus(states, rerun, mode):
    settings = {"mesh_stiffness__profile_changes": mode, "elasticity__law": "constant"}
    cold = rerun("mesh_stiffness", "without", states("without"), **settings)["mesh_stiffness"].values
    hot = rerun("mesh_stiffness", "with", states("with"), **settings)["mesh_stiffness"].values
    assert (hot > cold).all()


def test_common_foundation_softens_two_pairs_and_leaves_one(states, rerun):
    state = states("without")
    single = state["geometry"]["leaving"].values < 0
    plain = state["mesh_stiffness"]["mesh_stiffness"].values
    previous = plain
    for coupling in (0.0, 0.3, 0.8):
        coupled = rerun(
            "mesh_stiffness",
            "without",
            state,
            mesh_stiffness__pairs="coupled",
            mesh_stiffness__foundation_coupling=coupling,
        )["mesh_stiffness"].values
        assert coupled[single] == pytest.approx(plain[single], rel=1e-14, abs=0)
        if coupling == 0.0:
            assert coupled == pytest.approx(plain, rel=1e-14, abs=0)
        else:
            assert (coupled[~single] < previous[~single]).all()
        previous = coupled
