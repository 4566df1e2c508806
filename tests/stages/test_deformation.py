"""The stage of the growth of the flanks on a coarse grid."""

import numpy as np
import pytest

ROUND_OFF = 1e-16  # m, a few units in the last place of a radius


def test_growth_of_the_default_study(states):
    state = states("with")
    growth = 1e6 * state["deformation"]["thermal_growth"].values
    # independent evaluation: pinion 4.91 to 1.86, gear 2.23 to 5.37, four flanks 14.3 to 17.0, on average 16.1 um
    assert growth[0, [0, -1]] == pytest.approx([4.91, 1.86], abs=6e-3)
    assert growth[1, [0, -1]] == pytest.approx([2.23, 5.37], abs=6e-3)
    four, path = 2 * growth.sum(axis=0), state["geometry"]["path"].values
    assert [four.min(), four.max()] == pytest.approx([14.3, 17.0], abs=0.06)
    assert np.trapezoid(four, path) / np.ptp(path) == pytest.approx(16.1, abs=0.06)


@pytest.mark.parametrize("case", ["without", "wear_only"])
def test_cold_cases_do_not_grow(states, case):
    for stage in ("deformation", "flash_growth"):
        for name, values in states(case)[stage].data_vars.items():
            assert np.abs(values.values).max() < ROUND_OFF, name


def test_hotter_cases_grow_more(states):
    growths = [states(case)["deformation"]["thermal_growth"].values for case in ("n0700_t060", "n1400_t080", "with")]
    assert (np.diff(growths, axis=0) > 0).all()


def test_growth_modes_in_their_order(states, rerun):
    state = states("with")
    results = {
        mode: rerun("deformation", "with", state, heat__growth=mode) for mode in ("paper", "consistent", "eulerian")
    }
    growth = {mode: one["thermal_growth"].values for mode, one in results.items()}
    assert np.array_equal(growth["paper"], state["deformation"]["thermal_growth"].values)
    assert (growth["consistent"] < 0.65 * growth["paper"]).all()
    assert (growth["consistent"] > 0.45 * growth["paper"]).all()
    assert growth["eulerian"].sum(axis=0).min() > 2 * growth["paper"].sum(axis=0).max()
    assert (np.diff(growth["eulerian"][0]) >= 0).all()
    assert (np.diff(growth["paper"][0]) <= 0).all()
    same = [one["base_circle_growth"].values for one in results.values()]
    assert np.array_equal(same[0], same[1])
    assert np.array_equal(same[1], same[2])


def test_eulerian_growth_of_gears_at_one_temperature_is_the_change_of_the_centre_distance(states, rerun):
    state = states("with")
    geometry = state["geometry"]
    uniform = rerun("deformation", "with", state, heat__growth="eulerian", heat__shaft_temperature_drop=0.0)
    expected = 1.16e-5 * 80.0 * float(geometry["centre_distance"]) * np.sin(float(geometry["working_pressure_angle"]))
    total = uniform["thermal_growth"].values.sum(axis=0)
    assert total == pytest.approx(np.full(len(total), expected), rel=1e-9, abs=0)


def test_shaft_in_the_bore_holds_the_base_circle_back(states, rerun):
    state = states("with")
    held = rerun("deformation", "with", state, heat__hub="solid_shaft")
    free = state["deformation"]
    assert (held["base_circle_growth"].values < free["base_circle_growth"].values).all()
    assert (held["thermal_growth"].values < free["thermal_growth"].values).any()


def test_contact_temperature_in_the_whole_tooth_adds_the_growth_listed_for_it(states, rerun):
    state = states("with")
    bulk = state["deformation"]
    contact = rerun("deformation", "with", state, heat__temperature_rise="contact")
    extra = contact["thermal_growth"].values - bulk["thermal_growth"].values
    assert extra == pytest.approx(state["flash_growth"]["thermal_growth_flash"].values, abs=1e-16)
    flash = state["temperature"]["flash_temperature"].values
    assert (extra[:, flash > 1] > 0).all()
    assert np.array_equal(contact["base_circle_growth"].values, bulk["base_circle_growth"].values)


def test_growth_by_the_flash_is_that_of_a_hotter_tooth_on_the_same_base_circle(states):
    state = states("with")
    geometry = state["geometry"]
    strain = 1.16e-5 * state["temperature"]["flash_temperature"].values
    path = geometry["path"].values
    for i, curvature in enumerate((path, float(geometry["line_of_action"]) - path)):
        base = float(geometry["base_radius"][i])
        pressure = np.arctan(curvature / base)
        half = float(geometry["base_half_angle"][i]) - np.tan(pressure) + pressure
        expected = strain * base * (half + np.tan(pressure) * (1 - np.cos(pressure)))
        extra = state["flash_growth"]["thermal_growth_flash"].values[i]
        assert extra == pytest.approx(expected, rel=3e-3, abs=ROUND_OFF)


def test_cooler_shaft_shrinks_the_base_circle_until_it_reaches_the_initial_temperature(states, rerun):
    state = states("with")
    base = [
        rerun("deformation", "with", state, heat__shaft_temperature_drop=drop)["base_circle_growth"].values
        for drop in (0.0, 20.0, 80.0, 150.0)
    ]
    assert (base[0] > base[1]).all()
    assert (base[1] > base[2]).all()
    assert np.array_equal(base[2], base[3])
    uniform = 1.16e-5 * 80.0 * np.array([19, 48]) * 3.175e-3 / 2 * np.cos(np.radians(20))
    assert base[0] == pytest.approx(uniform, rel=1e-12, abs=0)


def test_growth_counts_from_the_initial_temperature(states, rerun):
    state = states("with")
    later = rerun(
        "deformation", "with", state, **{"heat.initial_temperature": 20.0, "cases.with.bulk_temperature": 60.0}
    )
    same = states("n0700_t060")["deformation"]
    assert np.array_equal(later["thermal_growth"].values, same["thermal_growth"].values)
    warm = rerun("deformation", "with", state, **{"heat.initial_temperature": 15.0})
    assert (warm["thermal_growth"].values > state["deformation"]["thermal_growth"].values).all()


def test_growth_is_proportional_to_expansion_to_first_order(states, rerun):
    state = states("with")
    twice = rerun(
        "deformation", "with", state, material__pinion__thermal_expansion=2.32e-5, material__gear__thermal_expansion=0.0
    )
    base = state["deformation"]["thermal_growth"].values
    assert twice["thermal_growth"].values[0] == pytest.approx(2 * base[0], rel=2e-3, abs=0)
    assert np.abs(twice["thermal_growth"].values[1]).max() < ROUND_OFF
