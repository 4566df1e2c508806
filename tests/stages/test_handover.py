"""What is handed over of a case: the dataset, its tables, and what other programs make of them."""

import csv
import importlib.util
from inspect import signature
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from gearwear.config.slices import slice_of
from gearwear.io import store
from gearwear.io.tables import write_csv
from gearwear.stages.handover import handover_dataset, handover_tables

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
TABLES = {"mesh": 2 * 40, "wear": None, "states": 2, "gears": 2}


@pytest.fixture(scope="module", params=["nominal", "effective"])
def cycles(request, study, states, with_reference, run_stage):
    """Settings and states of two wear cycles of a case, the second worn by the first."""
    config = study({"dynamics.stiffness": request.param})
    first = with_reference(states("with"))
    first["response"] = run_stage("response", config, "with", first)
    second = first | {"wear": run_stage("wear", config, "with", first)}
    second |= run_stage("mesh_excitation", config, "with", second)
    second["response"] = run_stage("response", config, "with", second)
    return config, [first, second]


@pytest.fixture(scope="module")
def found(cycles):
    """Return the dataset that is handed over."""
    config, states = cycles
    parts = [name for name in signature(handover_dataset).parameters if name not in ("cfg", "geometry")]
    several = {part: [one[part] for one in states] for part in parts}
    return handover_dataset(slice_of(config, "handover_dataset", "with"), states[0]["geometry"], **several)


@pytest.fixture(scope="module")
def handed(found, tmp_path_factory):
    """Return the folder of what is handed over."""
    folder = tmp_path_factory.mktemp("handover")
    store.save(found, folder / "handover.nc", store.Origin("handover_dataset", {}, ""))
    tables = handover_tables(store.load(folder / "handover.nc"))
    assert set(tables) == {*TABLES, "dictionary"}
    for name, table in tables.items():
        write_csv(folder / f"{name}.csv", *table)
    return folder


def example(name, package):
    """Return a module of the examples, or skip the test where the package it calls is not installed."""
    pytest.importorskip(package, reason=f"{package} is not installed: ./run examples")
    spec = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_every_cycle_is_that_of_its_stage(cycles, found):
    for cycle, made in enumerate(cycles[1]):
        state = found.sel(wear_cycle=cycle)
        for part, names in {
            "wear": ("wear_depth", "running_cycles"),
            "mesh_stiffness": ("mesh_stiffness",),
            "transmission_error": ("transmission_error", "effective_stiffness"),
            "backlash": ("backlash",),
            "response": ("natural_frequency", "mean_force"),
        }.items():
            for name in names:
                assert np.array_equal(state[name], made[part][name]), (cycle, name)
    assert (np.diff(found["running_cycles"]) > 0).all() and (found["wear_depth"][1] > 0).any()


def test_time_runs_at_the_running_speed_and_the_mean_stiffness_gives_the_natural_frequency(cycles, found):
    period = 60 / cycles[0]["operation"]["pinion_speed"] / float(found["teeth"][0])
    np.testing.assert_allclose(found["mesh_time"], found["mesh_phase"] * period, rtol=1e-12)
    frequency = np.sqrt(found["mean_stiffness"] / found["equivalent_mass"])
    np.testing.assert_allclose(frequency, found["natural_frequency"], rtol=1e-12)


def test_tables_hold_the_dataset_to_the_last_bit(found, handed):
    mesh = pd.read_csv(handed / "mesh.csv", float_precision="round_trip")
    wear = pd.read_csv(handed / "wear.csv", float_precision="round_trip")
    for column, name in {"mesh_stiffness [N m-1]": "mesh_stiffness", "backlash [m]": "backlash"}.items():
        assert np.array_equal(mesh[column], found[name].values.ravel())
    assert np.array_equal(mesh["mesh_time [s]"], np.tile(found["mesh_time"], 2))
    for gear in ("pinion", "gear"):
        assert np.array_equal(wear[f"wear_depth_{gear} [m]"], found["wear_depth"].sel(gear=gear).values.ravel())
    assert np.array_equal(wear["running_cycles"], np.repeat(found["running_cycles"], found.sizes["path"]))
    gears = pd.read_csv(handed / "gears.csv", index_col="gear")
    assert list(gears.index) == ["pinion", "gear"]
    assert (gears["equivalent_mass [kg]"] == float(found["equivalent_mass"])).all()
    for name, count in TABLES.items():
        assert len(pd.read_csv(handed / f"{name}.csv")) == (count or 2 * found.sizes["path"])


def test_dictionary_has_every_column_with_its_unit(handed):
    with open(handed / "dictionary.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    for name in TABLES:
        own = [row for row in rows if row["file"] == f"{name}.csv"]
        assert [row["column"] for row in own] == list(pd.read_csv(handed / f"{name}.csv"))
        for row in own:
            assert row["meaning"]
            assert row["column"].endswith(f" [{row['unit']}]") or row["unit"] in ("1", "-")


def test_opentorsion_finds_our_natural_frequency(found, handed):
    module = example("opentorsion_gears", "opentorsion")
    ours = found["natural_frequency"]
    for cycle in (0, 1):
        assert module.natural_frequency(handed, cycle) == pytest.approx(float(ours[cycle]), rel=1e-9)


def test_ross_finds_our_natural_frequency_less_the_give_of_its_bearings(found, handed):
    module = example("ross_gears", "ross")
    found = found.isel(wear_cycle=1)
    give = float(found["mean_stiffness"]) / module.BEARING
    assert give < 1e-4
    frequency = module.natural_frequency(handed, 1)
    assert frequency / float(found["natural_frequency"]) - 1 == pytest.approx(-give, abs=3e-6)
