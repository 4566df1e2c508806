"""The stage of the contact temperature on a coarse grid: flash, friction, film, balance of losses."""

import numpy as np
import pytest

from gearwear.heat.bulk import resolved

PITCH = "pitch_point"


def test_flash_peaks_at_the_ends_and_vanishes_at_the_pitch_point(states):
    state = states("with")
    geometry, heat = state["geometry"], state["temperature"]
    flash, path = heat["flash_temperature"].values, geometry["path"].values
    assert flash[np.argmin(abs(path - float(geometry[PITCH])))] < 1e-9 * flash.max()
    assert flash.min() >= 0
    assert flash.argmax() == 0
    # tip contact of the gear slides most: pinion dedendum hotter than pinion addendum
    assert flash[0] > flash[-1] > 0
    assert heat["contact_temperature"].values == pytest.approx(100.0 + flash, rel=1e-14, abs=0)


def test_load_per_width_carries_the_mesh_force(states):
    state = states("with")
    geometry, heat = state["geometry"], state["temperature"]
    load, partner = heat["load_per_width"].values, geometry["partner"].values
    whole = 130.0 / float(geometry["base_radius"][0]) / float(geometry["face_width"])
    both = partner >= 0
    assert load[both] + load[partner[both]] == pytest.approx(np.full(both.sum(), whole), rel=1e-12, abs=0)
    assert load[~both] == pytest.approx(np.full((~both).sum(), whole), rel=1e-12, abs=0)


def test_each_influence_raises_the_flash(states):
    ratio = states("with")["temperature"]["flash_sensitivity"]
    assert ratio["influence"].values.tolist() == ["friction", "speed", "load"]
    assert (ratio.values > 1).all()
    assert ratio.values[0] == pytest.approx(1.1, rel=1e-12, abs=0)


@pytest.mark.parametrize("case", ["without", "wear_only"])
def test_flash_off_gives_the_bulk_temperature(states, case):
    heat = states(case)["temperature"]
    assert not heat["flash_temperature"].values.any()
    assert (heat["contact_temperature"].values == 20.0).all()
    assert (heat["flash_sensitivity"].values == 1.0).all()
    assert (heat["friction_coefficient"].values.max()) > 0.01


def test_flash_switched_off_in_the_hot_case(states, rerun):
    state = states("with")
    cold = rerun("temperature", "with", state, **{"cases.with.flash": False})
    assert not cold["flash_temperature"].values.any()
    assert np.array_equal(cold["film_ratio"].values, state["temperature"]["film_ratio"].values)


def test_flash_follows_its_coefficient(states, rerun):
    state = states("with")
    base = state["temperature"]["flash_temperature"].values
    halved = rerun("temperature", "with", state, heat__flash_coefficient=0.415)["flash_temperature"].values
    assert halved == pytest.approx(base / 2, rel=1e-12, abs=0)


@pytest.mark.parametrize(
    ("changes", "factor"),
    [
        ({"friction__law": "thresholds"}, 1.2),
        ({"friction__boundary": 0.15}, 1.1),
        ({"operation__pinion_torque": 260.0}, 1.4),
        ({"lubricant__composite_roughness": 1e-6}, 1.05),
        ({"lubricant__dynamic_viscosity": 0.005}, 1.05),
        ({"lubricant__pressure_viscosity": 1.2e-8}, 1.05),
        ({"material__pinion__thermal_conductivity": 23.0, "material__gear__thermal_conductivity": 23.0}, 1.414),
    ],
)
def test_what_heats_the_contact(states, rerun, changes, factor):
    state = states("with")
    base = state["temperature"]["flash_temperature"].values
    raised = rerun("temperature", "with", state, **changes)["flash_temperature"].values
    assert raised.max() > factor * base.max()


@pytest.mark.parametrize("law", ["load_sharing", "thresholds"])
def test_dry_friction_matters_once_the_film_is_gone(states, rerun, law):
    state = states("with")
    thin = {"friction__law": law, "lubricant__dynamic_viscosity": 1.2e-3, "lubricant__composite_roughness": 2e-5}
    low, high = (
        rerun("temperature", "with", state, **thin, friction__dry=dry)["friction_coefficient"].values
        for dry in (0.2, 0.4)
    )
    assert (high > 1.2 * low).all()
    usual = [rerun("temperature", "with", state, friction__law="load_sharing", friction__dry=dry) for dry in (0.2, 0.4)]
    assert np.array_equal(*(one["friction_coefficient"].values for one in usual))


def test_vogel_oil_is_thicker_below_100_degrees_and_the_same_there(states, rerun):
    state = states("n0700_t060")
    fixed = rerun("temperature", "n0700_t060", state)["film_ratio"].values
    vogel = rerun("temperature", "n0700_t060", state, lubricant__viscosity_law="vogel")["film_ratio"].values
    assert (vogel > 1.5 * fixed).all()
    hot = rerun("temperature", "with", state, lubricant__viscosity_law="vogel")["film_ratio"].values
    assert hot == pytest.approx(rerun("temperature", "with", state)["film_ratio"].values, rel=1e-12, abs=0)


def test_losses_and_convection_are_equal_where_the_case_asks_for_a_balance(study, run_stage, states):
    config = resolved(study({"cases.with.bulk_temperature": "balance", "heat_balance.immersion.gear": 10e-3}))
    found = run_stage("temperature", config, "with", states("with"))
    given = states("with")["temperature"]
    assert float(found["mesh_loss"] + found["churning_loss"]) == pytest.approx(float(found["convection"]), rel=1e-9)
    assert float(given["mesh_loss"] + given["churning_loss"]) != pytest.approx(float(given["convection"]), rel=1e-2)
    bulk = config["cases"]["with"]["bulk_temperature"]
    assert found["contact_temperature"].values.min() == pytest.approx(bulk, rel=1e-12)
