"""Every stage up to the dynamics and the advance of wear, on a coarse grid."""

import json
from types import SimpleNamespace

import numpy as np
import pytest
import xarray as xr

from gearwear.plumbing import store
from gearwear.plumbing.bulk import resolved
from gearwear.plumbing.fields import FIELDS, field_of

PATH, PHASE, BOTH = ("path",), ("mesh_phase",), ("gear", "path")
CONTENTS = {
    "geometry": {
        "path": PATH,
        "partner": PATH,
        "mesh_phase": PHASE,
        "mesh_phase_width": PHASE,
        "base_radius": ("gear",),
        "tip_relief": BOTH,
        "spacing": PATH,
    },
    "temperature": {
        "contact_temperature": PATH,
        "flash_temperature": PATH,
        "friction_coefficient": PATH,
        "film_ratio": PATH,
        "hertz_half_width": PATH,
        "load_per_width": PATH,
        "surface_speed": BOTH,
        "flash_sensitivity": ("influence",),
        "mesh_loss": (),
        "churning_loss": (),
        "convection": (),
    },
    "deformation": {
        "thermal_growth": BOTH,
        "thermal_growth_flash": BOTH,
        "involute_error": BOTH,
        "base_circle_growth": ("gear",),
    },
    "wear": {"wear_depth": BOTH, "wear_per_revolution": BOTH, "running_cycles": ()},
    "mesh_stiffness": {
        "mesh_stiffness": PHASE,
        "pair_stiffness": PATH,
        "pair_coupling": PATH,
        "hertz_compliance": PATH,
        "bending_compliance": BOTH,
        "shear_compliance": BOTH,
        "axial_compliance": BOTH,
        "foundation_compliance": BOTH,
        "youngs_modulus": ("gear",),
    },
    "transmission_error": {
        "transmission_error": PHASE,
        "effective_stiffness": PHASE,
        "load_sharing_factor": ("mesh_phase", "pair"),
        "load_share_path": PATH,
        "elastic_deflection": PATH,
        "profile_error": PATH,
        "sharing_error": PATH,
    },
    "backlash": {
        "backlash": PHASE,
        "backlash_path": PATH,
        "initial_half_backlash": (),
        "centre_distance_change": (),
    },
}
PITCH = "pitch_point"
ROUND_OFF = 1e-16  # m, a few units in the last place of a radius


@pytest.fixture(scope="session")
def write_response(tmp_path_factory):
    """Return a function that writes a response of given mesh force (N), shape (periods, n), along the path."""

    def write(geometry, force):
        output = tmp_path_factory.mktemp("response") / "response.nc"
        values = {"mesh_force_path": (("response_period", "path"), np.atleast_2d(force))}
        job = SimpleNamespace(
            rule="solve_response",
            input={},
            output=[str(output)],
            params=SimpleNamespace(cfg={}, code="0" * 16),
        )
        store.save(xr.Dataset(values, {"path": geometry["path"]}), job)
        return output

    return write


@pytest.fixture(scope="session")
def write_wear(tmp_path_factory):
    """Return a function that writes a wear file with given depths (m), shape (2, n)."""

    def write(geometry, depth):
        output = tmp_path_factory.mktemp("wear") / "wear.nc"
        along = ("gear", "path")
        values = {"wear_depth": (along, depth), "wear_per_revolution": (along, 0 * depth), "running_cycles": 1e8}
        job = SimpleNamespace(
            rule="advance_wear", input={}, output=[str(output)], params=SimpleNamespace(cfg={}, code="0" * 16)
        )
        store.save(xr.Dataset(values, {"path": geometry["path"], "gear": geometry["gear"]}), job)
        return output

    return write


@pytest.fixture(scope="session")
def worn(states, write_wear, loaded):
    """Return a function that gives the files of a case whose flanks are worn like a run-in pair, up to 10 um."""

    def of(case):
        files = states(case)
        geometry = loaded(files, "geometry")
        path, pitch = geometry["path"].values, float(geometry[PITCH])
        shape = 10e-6 * abs(path - pitch) / (pitch - path[0])
        files["wear"] = write_wear(geometry, np.stack([shape * np.where(path < pitch, 1.0, 0.3), 0.2 * shape]))
        return files

    return of


@pytest.fixture(scope="session")
def rerun(study, run_stage):
    """Return a function that runs one stage on the given files under changed settings."""

    def run(stage, case, files, **changes):
        changed = {name.replace("__", "."): value for name, value in changes.items()}
        return store.load(run_stage(stage, study(changed), case, files))

    return run


def path_mean(dataset, name, geometry):
    """Return the mean over the mesh of a quantity on the mesh phases."""
    return float(dataset[name].values @ geometry["mesh_phase_width"].values)


# contents


@pytest.mark.parametrize("case", ["without", "with", "wear_only"])
@pytest.mark.parametrize("stage", CONTENTS)
def test_file_holds_its_variables(states, loaded, case, stage):
    dataset = loaded(states(case), stage)
    for name, dims in CONTENTS[stage].items():
        assert dataset[name].dims == dims
        assert np.isfinite(dataset[name].values).all() if dataset[name].dtype.kind == "f" else True
        units = field_of(name, dims).units
        assert dataset[name].attrs.get("units", "") == units
        assert dataset[name].attrs["long_name"]
    assert set(dataset.variables) - set(CONTENTS[stage]) <= set(FIELDS)


@pytest.mark.parametrize("stage", CONTENTS)
def test_file_names_its_settings_and_its_inputs(states, loaded, stage):
    dataset = loaded(states("with"), stage)
    assert dataset.attrs["lineage"]
    assert json.loads(dataset.attrs["config"]) is not None
    assert ("geometry" in json.loads(dataset.attrs["inputs"])) == (stage != "geometry")


def test_grids_are_the_same_in_every_file(states, loaded):
    files = states("with")
    geometry = loaded(files, "geometry")
    for stage in CONTENTS:
        dataset = loaded(files, stage)
        for name in ("path", "mesh_phase"):
            if name in dataset.coords:
                assert np.array_equal(dataset[name].values, geometry[name].values)


def test_same_settings_give_the_same_bytes(study, run_chain):
    twice = [run_chain(study(), "with") for _ in range(2)]
    for name in twice[0]:
        assert twice[0][name].read_bytes() == twice[1][name].read_bytes()


# contact temperature


def test_flash_peaks_at_the_ends_and_vanishes_at_the_pitch_point(states, loaded):
    files = states("with")
    geometry, heat = loaded(files, "geometry"), loaded(files, "temperature")
    flash, path = heat["flash_temperature"].values, geometry["path"].values
    assert flash[np.argmin(abs(path - float(geometry[PITCH])))] < 1e-9 * flash.max()
    assert flash.min() >= 0
    assert flash.argmax() == 0
    # tip contact of the gear slides most: pinion dedendum hotter than pinion addendum
    assert flash[0] > flash[-1] > 0
    assert heat["contact_temperature"].values == pytest.approx(100.0 + flash, rel=1e-14, abs=0)


def test_load_per_width_carries_the_mesh_force(states, loaded):
    files = states("with")
    geometry, heat = loaded(files, "geometry"), loaded(files, "temperature")
    load, partner = heat["load_per_width"].values, geometry["partner"].values
    whole = 130.0 / float(geometry["base_radius"][0]) / float(geometry["face_width"])
    both = partner >= 0
    assert load[both] + load[partner[both]] == pytest.approx(np.full(both.sum(), whole), rel=1e-12, abs=0)
    assert load[~both] == pytest.approx(np.full((~both).sum(), whole), rel=1e-12, abs=0)


def test_each_influence_raises_the_flash(states, loaded):
    ratio = loaded(states("with"), "temperature")["flash_sensitivity"]
    assert ratio["influence"].values.tolist() == ["friction", "speed", "load"]
    assert (ratio.values > 1).all()
    assert ratio.values[0] == pytest.approx(1.1, rel=1e-12, abs=0)


@pytest.mark.parametrize("case", ["without", "wear_only"])
def test_flash_off_gives_the_bulk_temperature(states, loaded, case):
    heat = loaded(states(case), "temperature")
    assert not heat["flash_temperature"].values.any()
    assert (heat["contact_temperature"].values == 20.0).all()
    assert (heat["flash_sensitivity"].values == 1.0).all()
    assert (heat["friction_coefficient"].values.max()) > 0.01


def test_flash_switched_off_in_the_hot_case(states, loaded, rerun):
    files = states("with")
    cold = rerun("temperature", "with", files, **{"cases.with.flash": False})
    assert not cold["flash_temperature"].values.any()
    assert np.array_equal(cold["film_ratio"].values, loaded(files, "temperature")["film_ratio"].values)


def test_flash_follows_its_coefficient(states, loaded, rerun):
    files = states("with")
    base = loaded(files, "temperature")["flash_temperature"].values
    halved = rerun("temperature", "with", files, heat__flash_coefficient=0.415)["flash_temperature"].values
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
def test_what_heats_the_contact(states, loaded, rerun, changes, factor):
    files = states("with")
    base = loaded(files, "temperature")["flash_temperature"].values
    raised = rerun("temperature", "with", files, **changes)["flash_temperature"].values
    assert raised.max() > factor * base.max()


@pytest.mark.parametrize("law", ["load_sharing", "thresholds"])
def test_dry_friction_matters_once_the_film_is_gone(states, rerun, law):
    files = states("with")
    thin = {"friction__law": law, "lubricant__dynamic_viscosity": 1.2e-3, "lubricant__composite_roughness": 2e-5}
    low, high = (
        rerun("temperature", "with", files, **thin, friction__dry=dry)["friction_coefficient"].values
        for dry in (0.2, 0.4)
    )
    assert (high > 1.2 * low).all()
    usual = [rerun("temperature", "with", files, friction__law="load_sharing", friction__dry=dry) for dry in (0.2, 0.4)]
    assert np.array_equal(*(one["friction_coefficient"].values for one in usual))


def test_vogel_oil_is_thicker_below_100_degrees_and_the_same_there(states, rerun):
    files = states("n0700_t060")
    fixed = rerun("temperature", "n0700_t060", files)["film_ratio"].values
    vogel = rerun("temperature", "n0700_t060", files, lubricant__viscosity_law="vogel")["film_ratio"].values
    assert (vogel > 1.5 * fixed).all()
    hot = rerun("temperature", "with", files, lubricant__viscosity_law="vogel")["film_ratio"].values
    assert hot == pytest.approx(rerun("temperature", "with", files)["film_ratio"].values, rel=1e-12, abs=0)


def test_losses_and_convection_are_equal_where_the_case_asks_for_a_balance(study, run_stage, states):
    config = resolved(study({"cases.with.bulk_temperature": "balance", "heat_balance.immersion.gear": 10e-3}))
    found = store.load(run_stage("temperature", config, "with", states("with")))
    given = store.load(states("with")["temperature"])
    assert float(found["mesh_loss"] + found["churning_loss"]) == pytest.approx(float(found["convection"]), rel=1e-9)
    assert float(given["mesh_loss"] + given["churning_loss"]) != pytest.approx(float(given["convection"]), rel=1e-2)
    bulk = config["cases"]["with"]["bulk_temperature"]
    assert found["contact_temperature"].values.min() == pytest.approx(bulk, rel=1e-12)


# growth of the flanks


def test_growth_of_the_default_study(states, loaded):
    files = states("with")
    growth = 1e6 * loaded(files, "deformation")["thermal_growth"].values
    # independent evaluation: pinion 4.91 to 1.86, gear 2.23 to 5.37, four flanks 14.3 to 17.0, on average 16.1 um
    assert growth[0, [0, -1]] == pytest.approx([4.91, 1.86], abs=6e-3)
    assert growth[1, [0, -1]] == pytest.approx([2.23, 5.37], abs=6e-3)
    four, path = 2 * growth.sum(axis=0), loaded(files, "geometry")["path"].values
    assert [four.min(), four.max()] == pytest.approx([14.3, 17.0], abs=0.06)
    assert np.trapezoid(four, path) / np.ptp(path) == pytest.approx(16.1, abs=0.06)


@pytest.mark.parametrize("case", ["without", "wear_only"])
def test_cold_cases_do_not_grow(states, loaded, case):
    deformation = loaded(states(case), "deformation")
    for name in CONTENTS["deformation"]:
        assert np.abs(deformation[name].values).max() < ROUND_OFF


def test_hotter_cases_grow_more(states, loaded):
    growths = [
        loaded(states(case), "deformation")["thermal_growth"].values for case in ("n0700_t060", "n1400_t080", "with")
    ]
    assert (np.diff(growths, axis=0) > 0).all()


def test_growth_modes_in_their_order(states, loaded, rerun):
    files = states("with")
    results = {
        mode: rerun("deformation", "with", files, heat__growth=mode) for mode in ("paper", "consistent", "eulerian")
    }
    growth = {mode: one["thermal_growth"].values for mode, one in results.items()}
    assert np.array_equal(growth["paper"], loaded(files, "deformation")["thermal_growth"].values)
    assert (growth["consistent"] < 0.65 * growth["paper"]).all()
    assert (growth["consistent"] > 0.45 * growth["paper"]).all()
    assert growth["eulerian"].sum(axis=0).min() > 2 * growth["paper"].sum(axis=0).max()
    assert (np.diff(growth["eulerian"][0]) >= 0).all()
    assert (np.diff(growth["paper"][0]) <= 0).all()
    same = [one["base_circle_growth"].values for one in results.values()]
    assert np.array_equal(same[0], same[1])
    assert np.array_equal(same[1], same[2])


def test_eulerian_growth_of_gears_at_one_temperature_is_the_change_of_the_centre_distance(states, loaded, rerun):
    files = states("with")
    geometry = loaded(files, "geometry")
    uniform = rerun("deformation", "with", files, heat__growth="eulerian", heat__shaft_temperature_drop=0.0)
    expected = 1.16e-5 * 80.0 * float(geometry["centre_distance"]) * np.sin(float(geometry["working_pressure_angle"]))
    total = uniform["thermal_growth"].values.sum(axis=0)
    assert total == pytest.approx(np.full(len(total), expected), rel=1e-9, abs=0)


def test_shaft_in_the_bore_holds_the_base_circle_back(states, loaded, rerun):
    files = states("with")
    held = rerun("deformation", "with", files, heat__hub="solid_shaft")
    free = loaded(files, "deformation")
    assert (held["base_circle_growth"].values < free["base_circle_growth"].values).all()
    assert (held["thermal_growth"].values < free["thermal_growth"].values).any()


def test_contact_temperature_in_the_whole_tooth_adds_the_growth_listed_for_it(states, loaded, rerun):
    files = states("with")
    bulk = loaded(files, "deformation")
    contact = rerun("deformation", "with", files, heat__temperature_rise="contact")
    extra = contact["thermal_growth"].values - bulk["thermal_growth"].values
    assert extra == pytest.approx(bulk["thermal_growth_flash"].values, abs=1e-16)
    flash = loaded(files, "temperature")["flash_temperature"].values
    assert (extra[:, flash > 1] > 0).all()
    assert np.array_equal(contact["base_circle_growth"].values, bulk["base_circle_growth"].values)


def test_growth_by_the_flash_is_that_of_a_hotter_tooth_on_the_same_base_circle(states, loaded):
    files = states("with")
    geometry, deformation = loaded(files, "geometry"), loaded(files, "deformation")
    strain = 1.16e-5 * loaded(files, "temperature")["flash_temperature"].values
    path = geometry["path"].values
    for i, curvature in enumerate((path, float(geometry["line_of_action"]) - path)):
        base = float(geometry["base_radius"][i])
        pressure = np.arctan(curvature / base)
        half = float(geometry["base_half_angle"][i]) - np.tan(pressure) + pressure
        expected = strain * base * (half + np.tan(pressure) * (1 - np.cos(pressure)))
        extra = deformation["thermal_growth_flash"].values[i]
        assert extra == pytest.approx(expected, rel=3e-3, abs=ROUND_OFF)


def test_cooler_shaft_shrinks_the_base_circle_until_it_reaches_the_initial_temperature(states, rerun):
    files = states("with")
    base = [
        rerun("deformation", "with", files, heat__shaft_temperature_drop=drop)["base_circle_growth"].values
        for drop in (0.0, 20.0, 80.0, 150.0)
    ]
    assert (base[0] > base[1]).all()
    assert (base[1] > base[2]).all()
    assert np.array_equal(base[2], base[3])
    uniform = 1.16e-5 * 80.0 * np.array([19, 48]) * 3.175e-3 / 2 * np.cos(np.radians(20))
    assert base[0] == pytest.approx(uniform, rel=1e-12, abs=0)


def test_growth_counts_from_the_initial_temperature(states, loaded, rerun):
    files = states("with")
    later = rerun(
        "deformation", "with", files, **{"heat.initial_temperature": 20.0, "cases.with.bulk_temperature": 60.0}
    )
    same = loaded(states("n0700_t060"), "deformation")
    assert np.array_equal(later["thermal_growth"].values, same["thermal_growth"].values)
    warm = rerun("deformation", "with", files, **{"heat.initial_temperature": 15.0})
    assert (warm["thermal_growth"].values > loaded(files, "deformation")["thermal_growth"].values).all()


def test_growth_is_proportional_to_expansion_to_first_order(states, loaded, rerun):
    files = states("with")
    twice = rerun(
        "deformation", "with", files, material__pinion__thermal_expansion=2.32e-5, material__gear__thermal_expansion=0.0
    )
    base = loaded(files, "deformation")["thermal_growth"].values
    assert twice["thermal_growth"].values[0] == pytest.approx(2 * base[0], rel=2e-3, abs=0)
    assert np.abs(twice["thermal_growth"].values[1]).max() < ROUND_OFF


# mesh stiffness


def test_start_wear_is_no_wear(states, loaded):
    wear = loaded(states("with"), "wear")
    assert not wear["wear_depth"].values.any()
    assert float(wear["running_cycles"]) == 0.0


def test_wear_only_has_the_stiffness_of_the_cold_pristine_pair(states, loaded):
    for stage, name in (("mesh_stiffness", "mesh_stiffness"), ("transmission_error", "transmission_error")):
        cold, dry = (loaded(states(case), stage)[name].values for case in ("without", "wear_only"))
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
    files = states("with")
    moduli = [
        rerun("mesh_stiffness", "with", files, elasticity__calibration=value)["youngs_modulus"].values
        for value in (0.0, 1.0, 5.3, 10.0)
    ]
    assert (np.diff(moduli, axis=0) < 0).all()


def test_tooth_clamped_at_the_root_circle(states, loaded, rerun):
    files = states("without")
    base = loaded(files, "mesh_stiffness")
    root = rerun("mesh_stiffness", "without", files, mesh_stiffness__cantilever="root")
    geometry = loaded(files, "geometry")
    below = geometry["root_radius"].values < geometry["base_radius"].values
    assert below.tolist() == [True, False]
    softer = root["bending_compliance"].values > base["bending_compliance"].values
    assert softer[0].all()
    assert not softer[1].any()


@pytest.mark.parametrize("fillet", ["straight", "generated"])
def test_fillet_angle_acts_through_the_gear_body_alone(states, loaded, rerun, fillet):
    files = states("without")
    geometry, rack = loaded(files, "geometry"), loaded(files, "mesh_stiffness")
    other = rerun("mesh_stiffness", "without", files, mesh_stiffness__fillet_angle=fillet)
    assert np.array_equal(rack["bending_compliance"].values, other["bending_compliance"].values)
    wider = geometry["rack_root_angle"].values > geometry[f"{fillet}_root_angle"].values
    stiffer = rack["foundation_compliance"].values < other["foundation_compliance"].values
    for i in range(2):
        assert (stiffer[i] == wider[i]).all()


def test_weber_contact_stiffens_with_load(states, loaded, rerun):
    files = states("without")
    light, heavy = (
        rerun("mesh_stiffness", "without", files, mesh_stiffness__hertz="weber", operation__pinion_torque=torque)
        for torque in (60.0, 240.0)
    )
    assert (heavy["mesh_stiffness"].values > light["mesh_stiffness"].values).all()
    linear = loaded(files, "mesh_stiffness")
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


def test_common_foundation_softens_two_pairs_and_leaves_one(states, loaded, rerun):
    files = states("without")
    single = loaded(files, "geometry")["leaving"].values < 0
    plain = loaded(files, "mesh_stiffness")["mesh_stiffness"].values
    previous = plain
    for coupling in (0.0, 0.3, 0.8):
        coupled = rerun(
            "mesh_stiffness",
            "without",
            files,
            mesh_stiffness__pairs="coupled",
            mesh_stiffness__foundation_coupling=coupling,
        )["mesh_stiffness"].values
        assert coupled[single] == pytest.approx(plain[single], rel=1e-14, abs=0)
        if coupling == 0.0:
            assert coupled == pytest.approx(plain, rel=1e-14, abs=0)
        else:
            assert (coupled[~single] < previous[~single]).all()
        previous = coupled


# transmission error and load sharing


@pytest.mark.parametrize("case", ["without", "with"])
def test_load_shares_add_up(states, worn, rerun, case):
    for files in (states(case), worn(case)):
        factor = rerun("transmission_error", case, files)["load_sharing_factor"].values
        assert factor.sum(axis=1) == pytest.approx(np.ones(len(factor)), rel=1e-12, abs=0)
        assert factor.min() >= 0


def test_pristine_pair_deflects_by_force_over_stiffness(states, loaded):
    files = states("without")
    force = 130.0 / float(loaded(files, "geometry")["base_radius"][0])
    stiffness = loaded(files, "mesh_stiffness")["mesh_stiffness"].values
    error = loaded(files, "transmission_error")
    assert error["transmission_error"].values == pytest.approx(force / stiffness, rel=1e-12, abs=0)
    assert error["effective_stiffness"].values == pytest.approx(stiffness, rel=1e-12, abs=0)


HARMONIC = {"dynamics__ste_amplitude": "harmonic"}  # an error without load has no mean to compare with


def test_error_without_load_is_that_of_the_profiles(states, worn, rerun, loaded):
    files = states("without")
    pristine = rerun("transmission_error", "without", files, transmission_error__mode="no_load", **HARMONIC)
    assert np.abs(pristine["transmission_error"].values).max() < ROUND_OFF
    files = worn("without")
    free, loaded_one = (
        rerun("transmission_error", "without", files, transmission_error__mode=mode, **HARMONIC)[
            "transmission_error"
        ].values
        for mode in ("no_load", "loaded")
    )
    assert (free < loaded_one).all()
    geometry, wear = loaded(files, "geometry"), loaded(files, "wear")["wear_depth"].values.sum(axis=0)
    entering, leaving = geometry["entering"].values, geometry["leaving"].values
    expected = np.where(leaving < 0, wear[entering], np.minimum(wear[entering], wear[leaving]))
    assert free == pytest.approx(expected, abs=ROUND_OFF)


def test_heat_as_a_profile_error(states, loaded, rerun):
    files = states("with")
    growth = loaded(files, "deformation")["thermal_growth"].values.sum(axis=0)
    expected = {
        "none": 0 * growth,
        "relative": growth.max() - growth,
        "full_removed": -growth,
        "full_added": 2 * growth,
    }
    means = {}
    for heat, removed in expected.items():
        error = rerun("transmission_error", "with", files, transmission_error__heat=heat)
        assert error["profile_error"].values == pytest.approx(removed, abs=ROUND_OFF)
        means[heat] = path_mean(error, "transmission_error", loaded(files, "geometry"))
    assert means["full_removed"] < means["none"] < means["relative"] < means["full_added"]


@pytest.mark.parametrize("heat", ["none", "relative", "full_removed", "full_added"])
def test_heat_does_nothing_to_the_cold_pair(states, loaded, rerun, heat):
    files = states("without")
    error = rerun("transmission_error", "without", files, transmission_error__heat=heat)
    base = loaded(files, "transmission_error")["transmission_error"].values
    assert error["transmission_error"].values == pytest.approx(base, abs=ROUND_OFF)


def test_heat_in_load_sharing_moves_load_to_the_more_grown_pair(states, loaded, rerun):
    files = states("with")
    geometry, cold = loaded(files, "geometry"), loaded(files, "transmission_error")
    hot = rerun("transmission_error", "with", files, transmission_error__heat_in_load_sharing=True)
    growth = loaded(files, "deformation")["thermal_growth"].values.sum(axis=0)
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


def test_more_torque_more_error(states, loaded, rerun):
    files = states("without")
    heavy = rerun("transmission_error", "without", files, operation__pinion_torque=260.0)["transmission_error"].values
    assert heavy == pytest.approx(
        2 * loaded(files, "transmission_error")["transmission_error"].values, rel=1e-12, abs=0
    )


RELIEF = {f"micro_geometry.tip_relief.{gear}.amount": 30e-6 for gear in ("pinion", "gear")}


@pytest.fixture(scope="session")
def relieved(study, run_chain):
    """Files of a pristine pair whose relief is deeper than its load can close, and whose spacing is 2 um off."""
    return run_chain(study(RELIEF | {"micro_geometry.spacing_error": 2e-6}), "with")


def test_relief_and_spacing_reach_sharing_error_temperature_and_wear(relieved, loaded, advance):
    geometry, mesh = loaded(relieved, "geometry"), loaded(relieved, "transmission_error")
    made = geometry["tip_relief"].values.sum(axis=0) + geometry["spacing"].values
    assert made.max() == pytest.approx(32e-6)
    assert mesh["sharing_error"].values == pytest.approx(made, abs=ROUND_OFF)
    share = mesh["load_share_path"].values
    apart = share == 0
    assert 0 < apart.sum() < len(share) / 3
    assert (made[apart] > 15e-6).all() and not mesh["elastic_deflection"].values[apart].any()
    assert not loaded(relieved, "temperature")["flash_temperature"].values[apart].any()
    assert not advance(relieved)["wear_depth"].values[:, apart].any()


def test_relief_opens_the_gap_as_wear_does_and_spacing_moves_a_tooth_with_both_its_flanks(relieved, loaded):
    mesh, growth = loaded(relieved, "transmission_error"), loaded(relieved, "deformation")["thermal_growth"].values
    relief = loaded(relieved, "geometry")["tip_relief"].values.sum(axis=0)
    change = mesh["elastic_deflection"].values + relief - 2 * growth.sum(axis=0)
    expected = 65e-6 + np.cos(np.radians(40.0)) * change / 2
    assert loaded(relieved, "backlash")["backlash_path"].values == pytest.approx(expected, rel=1e-12, abs=0)


# backlash


def test_moved_shafts_and_a_hot_housing_open_the_gap(states, loaded, rerun):
    files = states("with")
    near = loaded(files, "backlash")
    moved = rerun("backlash", "with", files, backlash__centre_distance_change=50e-6)
    assert float(moved["centre_distance_change"]) == 50e-6
    first_order = 50e-6 * np.sin(np.radians(20.0))
    opened = moved["backlash_path"].values - near["backlash_path"].values
    assert opened == pytest.approx(np.full(len(opened), first_order), rel=1e-2)
    hot = rerun("backlash", "with", files, backlash__housing__temperature_rise=0.75, heat__growth="eulerian")
    centre_distance = float(loaded(files, "geometry")["centre_distance"])
    assert float(hot["centre_distance_change"]) == pytest.approx(2.3e-5 * 60 * centre_distance, rel=1e-12)
    assert (hot["backlash_path"].values > near["backlash_path"].values + 20e-6).all()


@pytest.mark.parametrize(("projection", "factor"), [("shi", np.cos(np.radians(40.0))), ("exact", 1.0)])
def test_backlash_of_the_worn_hot_pair(worn, loaded, rerun, projection, factor):
    files = worn("with")
    gap = rerun("backlash", "with", files, backlash__projection=projection)
    deflection = loaded(files, "transmission_error")["elastic_deflection"].values
    wear = loaded(files, "wear")["wear_depth"].values.sum(axis=0)
    growth = loaded(files, "deformation")["thermal_growth"].values.sum(axis=0)
    assert gap["backlash_path"].values == pytest.approx(
        65e-6 + factor * (deflection + wear - 2 * growth) / 2, rel=1e-12, abs=0
    )
    entering = loaded(files, "geometry")["entering"].values
    assert np.array_equal(gap["backlash"].values, gap["backlash_path"].values[entering])


def test_heat_closes_and_wear_opens_the_gap(states, worn, loaded, rerun):
    cold, hot = (loaded(states(case), "backlash")["backlash_path"].values for case in ("without", "with"))
    assert (cold > 65e-6).all()
    assert (hot < cold - 3e-6).all()
    assert hot.min() < 65e-6
    assert (rerun("backlash", "without", worn("without"))["backlash_path"].values >= cold).all()


def test_initial_gap_shifts_all(states, loaded, rerun):
    files = states("with")
    wide = rerun("backlash", "with", files, backlash__half_backlash=80e-6)
    assert float(wide["initial_half_backlash"]) == 80e-6
    assert wide["backlash_path"].values - loaded(files, "backlash")["backlash_path"].values == pytest.approx(
        np.full(wide.sizes["path"], 15e-6), rel=1e-9, abs=0
    )


def test_jammed_teeth_are_an_error(states, rerun):
    with pytest.raises(ValueError, match="the teeth jam") as jam:
        rerun("backlash", "with", states("with"), backlash__half_backlash=1e-6)
    assert "half_backlash" in str(jam.value)


# wear


@pytest.fixture
def advance(rerun, write_response, loaded):
    """Return a function that wears the flanks by one block under a given mesh force; default the static one."""

    def run(files, case="with", force=None, **changes):
        geometry = loaded(files, "geometry")
        if force is None:
            force = np.full(geometry.sizes["path"], 130.0 / float(geometry["base_radius"][0]))
        return rerun("advance_wear", case, files | {"response": write_response(geometry, force)}, **changes)

    return run


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


# response


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
