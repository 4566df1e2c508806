"""The stage of the backlash on a coarse grid."""

import numpy as np
import pytest


def test_moved_shafts_and_a_hot_housing_open_the_gap(states, rerun):
    state = states("with")
    near = state["backlash"]
    moved = rerun("backlash", "with", state, backlash__centre_distance_change=50e-6)
    assert float(moved["centre_distance_change"]) == 50e-6
    first_order = 50e-6 * np.sin(np.radians(20.0))
    opened = moved["backlash_path"].values - near["backlash_path"].values
    assert opened == pytest.approx(np.full(len(opened), first_order), rel=1e-2)
    hot = rerun("backlash", "with", state, backlash__housing__temperature_rise=0.75, heat__growth="eulerian")
    centre_distance = float(state["geometry"]["centre_distance"])
    assert float(hot["centre_distance_change"]) == pytest.approx(2.3e-5 * 60 * centre_distance, rel=1e-12)
    assert (hot["backlash_path"].values > near["backlash_path"].values + 20e-6).all()


@pytest.mark.parametrize(("projection", "factor"), [("shi", np.cos(np.radians(40.0))), ("exact", 1.0)])
def test_backlash_of_the_worn_hot_pair(worn, rerun, projection, factor):
    state = worn("with")
    gap = rerun("backlash", "with", state, backlash__projection=projection)
    deflection = state["transmission_error"]["elastic_deflection"].values
    wear = state["wear"]["wear_depth"].values.sum(axis=0)
    growth = state["deformation"]["thermal_growth"].values.sum(axis=0)
    assert gap["backlash_path"].values == pytest.approx(
        65e-6 + factor * (deflection + wear - 2 * growth) / 2, rel=1e-12, abs=0
    )
    entering = state["geometry"]["entering"].values
    assert np.array_equal(gap["backlash"].values, gap["backlash_path"].values[entering])


def test_heat_closes_and_wear_opens_the_gap(states, worn, rerun):
    cold, hot = (states(case)["backlash"]["backlash_path"].values for case in ("without", "with"))
    assert (cold > 65e-6).all()
    assert (hot < cold - 3e-6).all()
    assert hot.min() < 65e-6
    assert (rerun("backlash", "without", worn("without"))["backlash_path"].values >= cold).all()


def test_initial_gap_shifts_all(states, rerun):
    state = states("with")
    wide = rerun("backlash", "with", state, backlash__half_backlash=80e-6)
    assert float(wide["initial_half_backlash"]) == 80e-6
    assert wide["backlash_path"].values - state["backlash"]["backlash_path"].values == pytest.approx(
        np.full(wide.sizes["path"], 15e-6), rel=1e-9, abs=0
    )


def test_jammed_teeth_are_an_error(states, rerun):
    with pytest.raises(ValueError, match="the teeth jam") as jam:
        rerun("backlash", "with", states("with"), backlash__half_backlash=1e-6)
    assert "half_backlash" in str(jam.value)
