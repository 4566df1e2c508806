"""The stage of load sharing and transmission error on a coarse grid."""

import numpy as np
import pytest

ROUND_OFF = 1e-16  # m, a few units in the last place of a radius


def path_mean(dataset, name, geometry):
    """Return the mean over the mesh of a quantity on the mesh phases."""
    return float(dataset[name].values @ geometry["mesh_phase_width"].values)


@pytest.mark.parametrize("case", ["without", "with"])
def test_load_shares_add_up(states, worn, rerun, case):
    for state in (states(case), worn(case)):
        factor = rerun("transmission_error", case, state)["load_sharing_factor"].values
        assert factor.sum(axis=1) == pytest.approx(np.ones(len(factor)), rel=1e-12, abs=0)
        assert factor.min() >= 0


def test_pristine_pair_deflects_by_force_over_stiffness(states):
    state = states("without")
    force = 130.0 / float(state["geometry"]["base_radius"][0])
    stiffness = state["mesh_stiffness"]["mesh_stiffness"].values
    error = state["transmission_error"]
    assert error["transmission_error"].values == pytest.approx(force / stiffness, rel=1e-12, abs=0)
    assert error["effective_stiffness"].values == pytest.approx(stiffness, rel=1e-12, abs=0)


HARMONIC = {"dynamics__ste_amplitude": "harmonic"}  # an error without load has no mean to compare with


def test_error_without_load_is_that_of_the_profiles(states, worn, rerun):
    state = states("without")
    pristine = rerun("transmission_error", "without", state, transmission_error__mode="no_load", **HARMONIC)
    assert np.abs(pristine["transmission_error"].values).max() < ROUND_OFF
    state = worn("without")
    free, loaded_one = (
        rerun("transmission_error", "without", state, transmission_error__mode=mode, **HARMONIC)[
            "transmission_error"
        ].values
        for mode in ("no_load", "loaded")
    )
    assert (free < loaded_one).all()
    geometry, wear = state["geometry"], state["wear"]["wear_depth"].values.sum(axis=0)
    entering, leaving = geometry["entering"].values, geometry["leaving"].values
    expected = np.where(leaving < 0, wear[entering], np.minimum(wear[entering], wear[leaving]))
    assert free == pytest.approx(expected, abs=ROUND_OFF)


def test_heat_as_a_profile_error(states, rerun):
    state = states("with")
    growth = state["deformation"]["thermal_growth"].values.sum(axis=0)
    expected = {
        "none": 0 * growth,
        "relative": growth.max() - growth,
        "full_removed": -growth,
        "full_added": 2 * growth,
    }
    means = {}
    for heat, removed in expected.items():
        error = rerun("transmission_error", "with", state, transmission_error__heat=heat)
        assert error["profile_error"].values == pytest.approx(removed, abs=ROUND_OFF)
        means[heat] = path_mean(error, "transmission_error", state["geometry"])
    assert means["full_removed"] < means["none"] < means["relative"] < means["full_added"]


@pytest.mark.parametrize("heat", ["none", "relative", "full_removed", "full_added"])
def test_heat_does_nothing_to_the_cold_pair(states, rerun, heat):
    state = states("without")
    error = rerun("transmission_error", "without", state, transmission_error__heat=heat)
    base = state["transmission_error"]["transmission_error"].values
    assert error["transmission_error"].values == pytest.approx(base, abs=ROUND_OFF)


def test_heat_in_load_sharing_moves_load_to_the_more_grown_pair(states, rerun):
    state = states("with")
    geometry, cold = state["geometry"], state["transmission_error"]
    hot = rerun("transmission_error", "with", state, transmission_error__heat_in_load_sharing=True)
    growth = state["deformation"]["thermal_growth"].values.sum(axis=0)
    partner = geometry["partner"].values
    both = np.flatnonzero(partner >= 0)
    more = growth[both] > growth[partner[both]]
    gain = hot["load_share_path"].values[both] - cold["load_share_path"].values[both]
    assert (gain[more] > 0).all()
    assert (gain[~more] <= 0).all()
    single = partner < 0
    assert np.array_equal(hot["load_share_path"].values[single], np.ones(single.sum()))
    assert np.array_equal(hot["transmission_error"].values, cold["transmission_error"].values)


def test_wear_raises_the_transmission_error(states, worn, rerun):
    pristine = rerun("transmission_error", "without", states("without"))["transmission_error"].values
    after = rerun("transmission_error", "without", worn("without"))["transmission_error"].values
    assert (after >= pristine).all()
    assert after.mean() > 1.05 * pristine.mean()


def test_more_torque_more_error(states, rerun):
    state = states("without")
    heavy = rerun("transmission_error", "without", state, operation__pinion_torque=260.0)["transmission_error"].values
    assert heavy == pytest.approx(2 * state["transmission_error"]["transmission_error"].values, rel=1e-12, abs=0)


RELIEF = {f"micro_geometry.tip_relief.{gear}.amount": 30e-6 for gear in ("pinion", "gear")}


@pytest.fixture(scope="session")
def relieved(study, run_chain):
    """State of a pristine pair whose relief is deeper than its load can close, and whose spacing is 2 um off."""
    return run_chain(study(RELIEF | {"micro_geometry.spacing_error": 2e-6}), "with")


def test_relief_and_spacing_reach_sharing_error_temperature_and_wear(relieved, advance):
    geometry, mesh = relieved["geometry"], relieved["transmission_error"]
    made = geometry["tip_relief"].values.sum(axis=0) + geometry["spacing"].values
    assert made.max() == pytest.approx(32e-6)
    assert mesh["sharing_error"].values == pytest.approx(made, abs=ROUND_OFF)
    share = mesh["load_share_path"].values
    apart = share == 0
    assert 0 < apart.sum() < len(share) / 3
    assert (made[apart] > 15e-6).all() and not mesh["elastic_deflection"].values[apart].any()
    assert not relieved["temperature"]["flash_temperature"].values[apart].any()
    assert not advance(relieved)["wear_depth"].values[:, apart].any()


def test_relief_opens_the_gap_as_wear_does_and_spacing_moves_a_tooth_with_both_its_flanks(relieved):
    mesh, growth = relieved["transmission_error"], relieved["deformation"]["thermal_growth"].values
    relief = relieved["geometry"]["tip_relief"].values.sum(axis=0)
    change = mesh["elastic_deflection"].values + relief - 2 * growth.sum(axis=0)
    expected = 65e-6 + np.cos(np.radians(40.0)) * change / 2
    assert relieved["backlash"]["backlash_path"].values == pytest.approx(expected, rel=1e-12, abs=0)
