"""Response, sweeps and figure of a pair on bearings, by the configuration alone."""

import numpy as np
import pytest

from gearwear.config.slices import slice_of
from gearwear.stages.motion import sweep, sweep_part

STIFF, SOFT = 1e12, 3e8
SHORT = {
    "settling.transient_periods": 100,
    "settling.longest_transient": 3200,  # bearings damp little
    "settling.sampled_periods": 32,
    "settling.largest_period": 4,
    "sweeps.mesh_frequency.first": 0.5,
    "sweeps.mesh_frequency.last": 0.9,
    "sweeps.mesh_frequency.points": 3,
    "portraits.mesh_frequency.without": [0.6],
    "portraits.mesh_frequency.with": [0.6],
    "basins.points.mesh_frequency": {},
}


@pytest.fixture(scope="module")
def state(states, with_reference):
    return with_reference(states("without"))


@pytest.fixture(scope="module")
def of_model(study):
    """Return a function that gives the short study with bearings of a stiffness; None, of the torsional model."""

    def make(stiffness=None, across=1.0):
        changes = dict(SHORT)
        if stiffness is not None:
            changes["dynamics.model"] = "translational"
            for gear in ("pinion", "gear"):
                changes[f"dynamics.bearings.{gear}.stiffness_along"] = stiffness
                changes[f"dynamics.bearings.{gear}.stiffness_across"] = across * stiffness
        return study(changes)

    return make


@pytest.fixture(scope="module")
def settled(state, run_stage):
    """Return a function that gives slice, excitation and the part from rest of the sweep over the mesh frequency."""

    def run(config):
        cfg = slice_of(config, "sweep", "without", "mesh_frequency")
        source = run_stage("excitation", config, "without", state)
        return cfg, source, sweep_part(cfg, source, "mesh_frequency", slice(None))

    return run


def test_mass_of_a_gear_is_that_of_its_disc(state, study):
    geometry, cfg = state["geometry"], study()
    reference, bore = geometry["reference_radius"].values, geometry["bore_radius"].values
    density = [cfg["material"][gear]["density"] for gear in ("pinion", "gear")]
    volume = np.pi * cfg["gear_pair"]["face_width"] * (reference**2 - bore**2)
    np.testing.assert_allclose(geometry["mass"], density * volume, rtol=1e-12)
    # a solid disc: J = m (r^2 + r_bore^2)/2
    inertia = geometry["mass"] * (reference**2 + bore**2) / 2
    np.testing.assert_allclose(geometry["moment_of_inertia"], inertia, rtol=1e-12)


def test_response_on_stiff_bearings_is_that_of_the_torsional_model(state, of_model, run_stage):
    torsional, stiff, soft = (
        run_stage("response", of_model(stiffness), "without", state) for stiffness in (None, STIFF, SOFT)
    )
    force = torsional["mesh_force"].values
    assert stiff["mesh_force"].values == pytest.approx(force, rel=2e-3, abs=0)
    assert stiff["natural_frequency"] == torsional["natural_frequency"]
    assert np.abs(soft["mesh_force"].values / force - 1).max() > 0.02
    # over a closed orbit neither inertia, bearings nor damping leave a mean
    width = state["geometry"]["mesh_phase_width"].values
    assert soft["mesh_force"].values @ width == pytest.approx(float(soft["mean_force"]), rel=2e-3)


def test_sweeps_of_both_kinds_are_classified_as_the_torsional_ones(of_model, settled):
    _, _, torsional = settled(of_model())
    _, _, stiff = settled(of_model(STIFF))
    cfg, source, soft = settled(of_model(SOFT, across=0.3))
    assert set(stiff.variables) == set(torsional.variables)
    np.testing.assert_array_equal(stiff["motion_class"], torsional["motion_class"])
    np.testing.assert_allclose(
        stiff["section_displacement"][:, -1], torsional["section_displacement"][:, -1], atol=2e-3
    )
    np.testing.assert_allclose(stiff["force_max"], torsional["force_max"], rtol=2e-3)
    assert np.abs(soft["force_max"] - torsional["force_max"]).max() > 0.02
    assert (soft["motion_class"] > 0).all() and (soft["stable_orbit_period"] > 0).all()
    sweeps = sweep(cfg, source, [soft], "mesh_frequency")
    assert set(sweeps) == {"restart", "up", "down"} and sweeps["restart"].identical(soft)
    continued = sweeps["down"]
    np.testing.assert_array_equal(continued["motion_class"], soft["motion_class"])
    # both approach one orbit, and say how far from it they ended
    away = continued["stable_orbit_distance"].values + soft["stable_orbit_distance"].values
    apart = continued["section_displacement"].values[:, -1] - soft["section_displacement"].values[:, -1]
    assert (np.abs(apart) <= away).all() and away.max() < 1e-3


def test_branches_are_refused_by_their_name(of_model):
    with pytest.raises(ValueError, match="dynamics.model: translational has neither branches of periodic orbits"):
        slice_of(of_model(SOFT), "branches", "with", "mesh_frequency")
