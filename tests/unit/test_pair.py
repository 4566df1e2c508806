"""The gear pair and its oscillator as the library offers them: the numbers of the stages, and clear refusals."""

from pathlib import Path

import numpy as np
import pytest
import xarray as xr
import yaml

import gearwear
from gearwear.chain.deformation import deformation
from gearwear.chain.geometry import geometry
from gearwear.chain.history import states_of_case
from gearwear.chain.mesh import mesh_excitation
from gearwear.chain.temperature import temperature
from gearwear.chain.wear import unworn
from gearwear.config.check import check
from gearwear.dynamics import SETTLING
from gearwear.heat.bulk import bulk_temperature
from gearwear.motions.settling import Settling
from gearwear.motions.sweep import sweep
from gearwear.oscillator.excitation import SweptOscillator, excitation
from gearwear.oscillator.prescribed import given_excitation

ROOT = Path(__file__).resolve().parents[2]
CELLS = 40
SHORT = {"transient_periods": 60, "longest_transient": 200, "sampled_periods": 80, "largest_period": 16}


@pytest.fixture(scope="module")
def config():
    """The default study on a coarse grid."""
    raw = yaml.safe_load((ROOT / "config" / "config.yaml").read_text())
    raw["grid"]["mesh_cells"] = CELLS
    return check(raw)


@pytest.fixture(scope="module")
def pair():
    return gearwear.GearPair((26, 78), 3.175e-3, 16e-3, (16e-3, 55e-3), mesh_cells=CELLS)


@pytest.fixture(scope="module")
def load(config):
    return {"torque": config["operation"]["pinion_torque"], "speed": config["operation"]["pinion_speed"]}


def at(config, case):
    return config | {"case": config["cases"][case]}


def assert_same(found, expected):
    """Equal to the bit, in every variable of the stage, whatever the attributes."""
    for name, values in expected.variables.items():
        assert found[name].dims == values.dims, name
        assert found[name].dtype == values.dtype, name
        assert found[name].values.tobytes() == values.values.tobytes() or values.dtype == object, name
        assert found[name].equals(expected[name]), name


def test_the_defaults_are_those_of_the_default_study(config, pair):
    for section, values in pair._cfg.items():
        assert values == config[section], section


def test_numbers_and_arrays_of_numpy_are_taken():
    numbers = np.array([26, 78]), np.float32(0.003175), np.float64(16e-3), np.array([16e-3, 55e-3])
    pair = gearwear.GearPair(*numbers, mesh_cells=np.int64(CELLS))
    assert pair._cfg["gear_pair"]["teeth"] == {"pinion": 26, "gear": 78}


def test_a_body_is_held_where_the_workflow_holds_it_by_default():
    raw = yaml.safe_load((ROOT / "config" / "config.yaml").read_text())
    raw["gear_pair"]["bore_radius"] = {"pinion": None, "gear": None}
    found = gearwear.GearPair((26, 78), 3.175e-3, 16e-3)._cfg["gear_pair"]
    assert found["bore_radius"] == check(raw)["gear_pair"]["bore_radius"]


def test_geometry_is_that_of_the_stage(config, pair):
    assert_same(pair.geometry, geometry(config))
    assert pair.geometry["path"].attrs["units"] == "m"


@pytest.mark.parametrize("case", ["without", "with"])
def test_stiffness_error_and_backlash_are_those_of_the_stages(config, pair, load, case):
    cfg, cold = at(config, case), geometry(config)
    expected = mesh_excitation(cfg, cold, deformation(cfg, cold), unworn(cold))
    state = {"torque": load["torque"], "bulk_temperature": cfg["case"]["bulk_temperature"]}
    assert_same(pair.mesh_stiffness(**state), expected["mesh_stiffness"])
    assert_same(pair.transmission_error(**state), expected["transmission_error"])
    assert_same(pair.backlash(**state), expected["backlash"])
    shared = pair.load_sharing(**state)
    assert set(shared.data_vars) == {"load_sharing_factor", "load_share_path", "elastic_deflection"}
    assert shared["load_share_path"].identical(pair.transmission_error(**state)["load_share_path"])


@pytest.mark.parametrize("case", ["without", "with"])
def test_contact_temperature_and_growth_are_those_of_the_stages(config, pair, load, case):
    cfg, cold = at(config, case), geometry(config)
    bulk, flash = cfg["case"]["bulk_temperature"], cfg["case"]["flash"]
    contact = pair.contact_temperature(**load, bulk_temperature=bulk, flash=flash)
    assert_same(contact, temperature(cfg, cold))
    assert_same(pair.thermal_growth(bulk), deformation(cfg, cold))
    hot = cfg | {"heat": cfg["heat"] | {"temperature_rise": "contact"}}
    assert_same(pair.thermal_growth(bulk, contact=contact), deformation(hot, cold, contact))


def test_the_bulk_temperature_is_that_of_the_balance(config, pair, load):
    assert pair.bulk_temperature(**load) == bulk_temperature(config)


def test_dynamic_wear_is_that_of_the_wear_history(config, pair, load):
    cfg = config | {"cases": config["cases"] | {"short": config["cases"]["with"] | {"running_cycles": int(2e8)}}}
    cold = geometry(cfg)
    (reference,) = states_of_case(cfg, cold, "without")
    expected = list(states_of_case(cfg, cold, "short", reference))
    found = pair.wear(**load, cycles=2e8, bulk_temperature=100.0)
    assert found.sizes["wear_cycle"] == len(expected) == 3
    for cycle, state in enumerate(expected):
        own = found.sel(wear_cycle=cycle)
        for name in ("wear_depth", "running_cycles", "mesh_stiffness", "transmission_error", "backlash"):
            assert own[name].values.tobytes() == state[name].values.tobytes(), (cycle, name)


def test_wear_goes_on_from_worn_flanks(pair, load):
    options = load | {"bulk_temperature": 100.0, "force": "quasi_static"}
    whole = pair.wear(cycles=3e8, **options)
    first = pair.wear(cycles=1e8, **options)
    rest = pair.wear(cycles=2e8, wear=first.isel(wear_cycle=-1), **options)
    assert rest["wear_depth"].values[-1].tobytes() == whole["wear_depth"].values[-1].tobytes()
    assert rest["running_cycles"].values.tolist() == [1e8, 2e8, 3e8]
    assert whole["wear_depth"].attrs["units"] == "m"


def test_wear_and_growth_are_taken_as_arrays_too(pair, load):
    worn = pair.wear(cycles=1e8, force="quasi_static", **load).isel(wear_cycle=-1)
    grown = pair.thermal_growth(80.0)
    state = {"torque": load["torque"], "bulk_temperature": 80.0}
    of_datasets = pair.transmission_error(**state, wear=worn, growth=grown)
    of_arrays = pair.transmission_error(**state, wear=worn["wear_depth"].values, growth=grown["thermal_growth"].values)
    assert of_arrays.identical(of_datasets)
    assert of_arrays.identical(pair.transmission_error(**state, wear=worn["wear_depth"]))
    cold = pair.transmission_error(**state, growth=0.0)["profile_error"]
    assert (cold.values == 0).all()


@pytest.mark.parametrize("order", ["restart", "up", "down"])
def test_the_sweep_of_the_pair_is_that_of_the_workflow(config, pair, load, order):
    cold = geometry(config)
    (reference,) = states_of_case(config, cold, "without")
    hot = at(config, "with")
    state = xr.merge(mesh_excitation(hot, cold, deformation(hot, cold), unworn(cold)).values())
    source = excitation(cold, state, reference, load["torque"], config["dynamics"])
    oscillator = pair.oscillator(load["torque"], bulk_temperature=100.0)
    assert oscillator.excitation == source
    values = np.linspace(0.6, 1.5, 4)
    settling = Settling(**config["settling"] | SHORT)
    expected = sweep(SweptOscillator(source, "mesh_frequency", config["dynamics"]), values, settling, order)
    found = oscillator.sweep(values, order=order, **SHORT)
    for name, one in expected.variables.items():
        assert found[name].values.tobytes() == one.values.tobytes(), name
    assert found.sel(mesh_frequency=0.9, method="nearest")["motion_class"].attrs["flag_meanings"].startswith("not_conv")


def test_the_defaults_of_the_oscillator_are_those_of_the_default_study(config, pair, load):
    oscillator = pair.oscillator(load["torque"])
    for name, value in oscillator._dynamics.items():
        expected = config["dynamics"][name]
        found = (
            {key: list(one) if isinstance(one, tuple) else one for key, one in value.items()}
            if isinstance(value, dict)
            else value
        )
        assert found == expected, name
    assert Settling(**config["settling"]) == SETTLING


@pytest.mark.parametrize(
    ("quantity", "settings"),
    [
        ("ste", {"mesh_frequency": 0.8}),
        ("backlash", {"mesh_frequency": 0.8, "reading": "rescale"}),
        ("backlash", {"mesh_frequency": 0.8, "reading": "clearance"}),
    ],
)
def test_sweeps_over_other_quantities_are_those_of_the_workflow(config, pair, load, quantity, settings):
    oscillator = pair.oscillator(load["torque"])
    swept = SweptOscillator(oscillator.excitation, quantity, config["dynamics"], settings)
    values = np.array([0.8, 1.1])
    expected = sweep(swept, values, Settling(**config["settling"] | SHORT))
    found = oscillator.sweep(**settings | {quantity: values}, **SHORT)
    assert found["section_displacement"].values.tobytes() == expected["section_displacement"].values.tobytes()
    assert found[quantity].values.tolist() == values.tolist()


@pytest.fixture(scope="module")
def ks_1991():
    return gearwear.Oscillator.from_harmonics(
        0.1, stiffness=[-0.2, -0.1, -0.05], error=[0.01, 0.004, 0.002], damping_ratio=0.05, start="pair_entry"
    )


def test_an_oscillator_by_its_equation_is_that_of_the_workflow(ks_1991):
    preset = yaml.safe_load((ROOT / "config" / "presets" / "ks-1991.yaml").read_text())
    assert ks_1991.excitation == given_excitation(preset["oscillators"]["ks_1991"])


def test_settle_takes_a_state_and_agrees_with_the_sweep(ks_1991):
    rest = ks_1991.settle(0.7, **SHORT)
    swept = ks_1991.sweep([0.7], **SHORT).isel(mesh_frequency=0)
    assert rest["section_displacement"].values.tobytes() == swept["section_displacement"].values.tobytes()


def test_settle_leads_a_state_to_the_attractor_of_its_basin(ks_1991):
    basins = ks_1991.basins(0.7, resolution=8, displacement=(0.0, 3.0), **SHORT).isel(point=0)
    highest = []
    for attractor in range(2):
        row, column = np.argwhere(basins["basin"].values == attractor)[0]
        state = float(basins["initial_displacement"][row]), float(basins["initial_velocity"][column])
        highest.append(float(ks_1991.settle(0.7, state=state, **SHORT)["displacement_max"]))
    assert highest == pytest.approx(basins["displacement_max"].values[:2].tolist(), abs=1e-6)
    assert abs(highest[0] - highest[1]) > 0.1


def test_branches_join_the_motions_of_both_sweeps_through_unstable_orbits(ks_1991):
    values = np.linspace(0.65, 0.75, 5)
    low, high = (ks_1991.sweep(values, order=order, **SHORT) for order in ("restart", "up"))
    branches = ks_1991.branches([low, high])
    assert branches["mesh_frequency"].dims == ("node",)
    assert branches["mesh_frequency"].min() == 0.65
    assert branches["mesh_frequency"].max() == 0.75
    assert branches.identical(ks_1991.branches((low, high), largest_period=4))


def test_basins_hold_the_motions_that_coexist(ks_1991):
    basins = ks_1991.basins([0.7, 0.9], resolution=8, displacement=(0.0, 3.0), **SHORT)
    assert basins["attractors"].sel(point=0) >= 2
    assert basins["share"].sum("attractor").values.tolist() == pytest.approx([1.0, 1.0])
    assert basins["basin"].shape == (2, 8, 8)


def test_portraits_close_after_their_period(ks_1991):
    orbit = ks_1991.portraits(0.9, **SHORT).isel(point=0)
    period = float(orbit["period"])
    start, end = (orbit["orbit_displacement"].values[orbit["orbit_period"].values == at][0] for at in (0.0, period))
    assert start == pytest.approx(end, abs=1e-9)


def test_arrays_give_the_oscillator_of_the_pair_that_they_come_from(pair, load):
    torque, geometry_ = load["torque"], pair.geometry
    state = {"torque": torque, "bulk_temperature": 80.0}
    for harmonics in (2, "full"):
        expected = pair.oscillator(
            **state, harmonics=harmonics, ste_amplitude="harmonic", clearance="varying"
        ).excitation
        found = gearwear.Oscillator.from_arrays(
            pair.mesh_stiffness(**state)["mesh_stiffness"],
            pair.transmission_error(**state)["transmission_error"],
            torque / float(geometry_["base_radius"][0]),
            damping_ratio=0.072,
            clearance=pair.backlash(**state)["backlash"],
            half_backlash=65e-6,
            mass=float(geometry_["equivalent_mass"]),
            width=geometry_["mesh_phase_width"],
            harmonics=harmonics,
            double_contact=geometry_["leaving"] >= 0,
        ).excitation
        assert found.stiffness == expected.stiffness
        assert found.shape == expected.shape
        assert found.clearance == expected.clearance
        for name in ("force_parameter", "natural_frequency", "error_amplitude", "mean_force", "length"):
            assert getattr(found, name) == pytest.approx(getattr(expected, name), rel=1e-14), name


PAIR = {"teeth": (26, 78), "module": 3e-3, "face_width": 16e-3, "bore_radius": (16e-3, 55e-3)}


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        (
            {"teeth": (3, 78)},
            "teeth of the pinion: 3 is below the least allowed value 6; give a whole number from 6 to 500",
        ),
        ({"teeth": (26, 78, 9)}, r"teeth: 3 values; give \(pinion, gear\), or one value for both"),
        ({"module": "thick"}, "module: text 'thick' is not a number"),
        ({"module": 0.2}, "module: 0.2 is above the largest allowed value 0.1 m"),
        ({"modulus_law": "hooke"}, "modulus_law: text 'hooke' is not a choice .* give li, linear, table or constant"),
        ({"error_mode": "free"}, "error_mode: .* give loaded or no_load"),
        ({"material": gearwear.Material(poisson_ratio=0.6)}, "poisson_ratio of the pinion: 0.6 is not below 0.5"),
        ({"lubricant": gearwear.Lubricant(viscosity_law="x")}, "viscosity_law: .* give fixed or vogel"),
        (
            {"tip_relief": (gearwear.TipRelief(), gearwear.TipRelief(length=3.0))},
            "tip_relief.length of the gear: 3.0 is above the largest allowed value 2",
        ),
        ({"tip_relief": 1e-5}, "tip_relief: 1e-05; give a TipRelief, or two, of pinion and gear"),
        ({"lubricant": {}}, "lubricant: {}; give a Lubricant"),
        ({"housing_expansion": 1.0}, "housing_expansion: 1.0 is above the largest allowed value 3.0e-4"),
        ({"profile_shift": (1.9, 1.9), "centre_distance": 0.156}, "the teeth jam"),
        ({"bore_radius": (0.05, 0.055)}, "bore_radius.pinion: 50 mm is not below the root radius"),
    ],
)
def test_a_pair_that_cannot_be_is_refused_by_its_argument(changed, message):
    with pytest.raises(gearwear.GearwearError, match=message):
        gearwear.GearPair(**PAIR | changed)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda pair: pair.transmission_error(-1.0), "torque: -1.0 is not above 0"),
        (lambda pair: pair.contact_temperature(100.0, 0.0, 80.0), "speed: 0.0 is not above 0"),
        (
            lambda pair: pair.contact_temperature(100.0, 3e3, 80.0, dry_friction=-1.0),
            "dry_friction: -1.0 is not above 0",
        ),
        (lambda pair: pair.mesh_stiffness(bulk_temperature=400.0), "bulk_temperature: 400.0 is above the largest"),
        (lambda pair: pair.mesh_stiffness(bulk_temperature="balance"), "bulk_temperature: give degC"),
        (lambda pair: pair.mesh_stiffness(wear=np.zeros((2, 7))), r"wear: shape \(2, 7\); give finite numbers"),
        (lambda pair: pair.mesh_stiffness(wear=-1e-6), "wear: -1e-06 m; a depth is from 0"),
        (lambda pair: pair.mesh_stiffness(growth=xr.Dataset()), "growth: the dataset has no thermal_growth"),
        (lambda pair: pair.wear(100.0, 3e3, 1.5e8), "cycles: 1.5e[+]08 is not a whole multiple of cycles_per_update"),
        (lambda pair: pair.wear(100.0, 3e3, 1e8, cycles_per_update=0), "cycles_per_update: 0.* is below the least"),
        (lambda pair: pair.wear(100.0, 3e3, 1e8, law="other"), "law: .* give janakiraman or constant"),
        (lambda pair: pair.oscillator(100.0, harmonics=0), "harmonics: 0"),
        (lambda pair: pair.oscillator(100.0, start="anywhere"), "start: 'anywhere'; give stiffest_mesh or pair_entry"),
        (lambda pair: pair.thermal_growth(80.0, hub="none"), "hub: .* give free_bore or solid_shaft"),
    ],
)
def test_a_wrong_argument_is_refused_by_name(pair, call, message):
    with pytest.raises(gearwear.GearwearError, match=message):
        call(pair)


def test_a_contact_law_that_depends_on_the_load_asks_for_it():
    soft = gearwear.GearPair(**PAIR, hertz="weber")
    with pytest.raises(gearwear.GearwearError, match="torque: missing"):
        soft.mesh_stiffness()
    light, heavy = (float(soft.mesh_stiffness(torque=torque)["mesh_stiffness"].mean()) for torque in (10.0, 300.0))
    assert light < heavy


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda one: one.sweep([0.7, 0.6]), "mesh_frequency: the values must ascend"),
        (lambda one: one.sweep([]), r"mesh_frequency: shape \(0,\)"),
        (lambda one: one.sweep([-1.0, 1.0]), "mesh_frequency: give finite numbers above 0"),
        (lambda one: one.sweep([0.6], order="left"), "order: 'left'; give restart, up or down"),
        (lambda one: one.sweep([0.6, 0.7], ste=[1.0]), "mesh_frequency: several values; give one for a sweep over ste"),
        (lambda one: one.sweep(0.6, ste=[1.0], backlash=[1.0]), "ste and backlash: one of them"),
        (lambda one: one.sweep([0.6], periods=3), "periods: unknown argument; settling takes transient_periods"),
        (lambda one: one.sweep([0.6], sampled_periods=10), "sampled_periods: 10"),
        (lambda one: one.branches([]), "sweeps: give results of Oscillator.sweep"),
        (lambda one: one.basins(0.6, resolution=0), "resolution: 0 must be at least 1"),
        (lambda one: one.settle(np.inf), "mesh_frequency: inf; give finite numbers above 0"),
        (lambda _: gearwear.Oscillator.from_harmonics(0.1, damping_ratio=-0.1), "damping_ratio: -0.1"),
        (
            lambda _: gearwear.Oscillator.from_harmonics(0.1, stiffness=[2.0], damping_ratio=0.1),
            "stiffness: least value",
        ),
        (
            lambda _: gearwear.Oscillator.from_harmonics(0.1, error=[0, 1], damping_ratio=0.1),
            "error: the first amplitude is 0",
        ),
        (
            lambda _: gearwear.Oscillator.from_harmonics(0.1, error=[1], error_phases=[], damping_ratio=0.1),
            "error_phases: 0 for 1 amplitudes",
        ),
    ],
)
def test_a_motion_that_cannot_be_is_refused_by_argument(ks_1991, call, message):
    with pytest.raises(gearwear.GearwearError, match=message):
        call(ks_1991)


ARRAYS = {
    "stiffness": np.full(8, 4e8),
    "error": np.zeros(8),
    "force": 1e3,
    "damping_ratio": 0.05,
    "half_backlash": 5e-5,
}


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"error": np.zeros(7)}, r"error: shape \(7,\)"),
        ({"error": np.full(8, np.nan)}, "error: .* finite"),
        ({"half_backlash": None}, "clearance: give it over the mesh period, or half_backlash"),
        ({"half_backlash": -1.0}, "half_backlash: -1; give finite numbers above 0"),
        ({"width": np.full(8, 0.2)}, "width: above 0 with sum 1, not 1.6"),
        ({"harmonics": 9}, "harmonics: 9; give a whole number from 1 to below 8"),
        ({"harmonics": "full"}, "double_contact: harmonics"),
    ],
)
def test_arrays_that_do_not_fit_are_refused_by_name(changed, message):
    with pytest.raises(gearwear.GearwearError, match=message):
        gearwear.Oscillator.from_arrays(**ARRAYS | changed)
