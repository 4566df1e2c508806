"""Studies over grids in the workflow: shared chains, impossible combinations, what runs again."""

import csv
import re

import pytest
import xarray as xr

HEAT, AGE = "cases.with.bulk_temperature", "cases.with.running_cycles"
GRID = {HEAT: [10, 100], AGE: [0, 1e8]}
SMALL = {
    "sweeps": {"mesh_frequency": {"points": 7}},
    "portraits": {"mesh_frequency": {"without": [0.5], "with": [0.5]}},
    "studies": {"heat": {"grid": GRID}},
}
FILES = [f"results/studies/heat/{name}" for name in ("study.nc", "table.csv", "lives.csv")]


@pytest.fixture(scope="module")
def studied(smoke_run):
    run = smoke_run.snakemake("-j2", *FILES, "results/figures/study_heat.svg", *smoke_run.smoke(SMALL))
    assert run.returncode == 0, run.stdout[-8000:]
    return smoke_run


def test_two_ages_share_one_chain_and_an_impossible_combination_stops_nobody(studied):
    outcomes = sorted((studied.folder / "results").glob("studies/heat/*/outcome.nc"))
    assert [path.parent.name for path in outcomes] == [
        "bulk_temperature_100__running_cycles_0",
        "bulk_temperature_100__running_cycles_1e08",
    ]
    fresh, worn = (xr.open_dataset(path) for path in outcomes)
    assert fresh.attrs["inputs"] == worn.attrs["inputs"]
    with open(studied.folder / FILES[1], newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["hindrance"].startswith("cases.with.bulk_temperature: 10.0 is below") for row in rows] == [
        True,
        True,
        False,
        False,
    ]
    found = xr.open_dataset(studied.folder / FILES[0]).sel({HEAT: 100, AGE: 1e8})
    assert found["deepest_wear"].min() > 0 and found["motion_class"].shape == (3, 7)
    assert (found["motion_class"].values == worn["motion_class"].values).all()


def planned(project, settings):
    files = project.summary(*FILES, *project.smoke(settings))
    return {
        re.sub(r"\w+_[0-9a-f]{12}", "chain", name.removeprefix("results/studies/"))
        for name, anew in files.items()
        if anew and name.startswith("results/studies/")
    }


def test_only_what_a_change_reaches_runs_again(studied):
    assert planned(studied, SMALL) == set()
    longer = planned(studied, SMALL | {"studies": {"heat": {"grid": {HEAT: [10, 100], AGE: [0, 1e8, 2e8]}}}})
    assert "heat/bulk_temperature_100__running_cycles_2e08/outcome.nc" in longer
    assert "heat/bulk_temperature_100__running_cycles_1e08/outcome.nc" not in longer
    assert "chains/chain.nc" not in longer  # the study `life` has asked for as much of it
    finer = SMALL | {"sweeps": {"mesh_frequency": {"points": 9}}}
    assert not [name for name in planned(studied, finer) if name.startswith("chains")]


def test_the_shipped_life_is_planned_by_its_name(studied):
    jobs = studied.jobs("life")
    assert (jobs["outcome"], jobs["wear_history"]) == (56, 7)
