"""Members of studies in the workflow: asked for by name, computed with their own settings in their own folder."""

import json

import netCDF4
import pytest
import xarray as xr

STUDIES = {"heat": {"members": {"t120": {"cases": {"with": {"bulk_temperature": 120.0}}}}}}
MEMBER = "results/studies/heat/t120"
OWN = f"{MEMBER}/with/temperature.nc"


@pytest.fixture(scope="module")
def project(make_project):
    """A copy of the program where the temperature of the study and of a member are computed."""
    project = make_project("members")
    run = overlaid(project, {"studies": STUDIES}, "-j1", "--", OWN, "results/with/temperature.nc")
    assert run.returncode == 0, run.stdout
    return project


def overlaid(project, settings, *arguments):
    return project.snakemake(*project.smoke(settings), *arguments)


def planned(project, settings):
    options = project.smoke({"studies": STUDIES} | settings)
    files = project.summary(*options, "--", OWN, "results/with/temperature.nc")
    assert len(files) == 4
    return {name for name, anew in files.items() if anew}


def test_a_member_is_computed_with_its_own_settings_beside_the_study(project):
    for path, bulk in ((OWN, 120.0), ("results/with/temperature.nc", 100.0)):
        with netCDF4.Dataset(project.folder / path) as file:
            assert json.loads(file.config)["case"]["bulk_temperature"] == bulk
    results = project.folder / "results"
    made = {str(path.relative_to(results)) for path in results.rglob("*") if path.is_file()}
    stems = {"geometry", "with/temperature"}
    files = {"geometry.nc", "with/temperature.nc"}
    assert made == {
        where
        for root in ("", "studies/heat/t120/")
        for where in (
            *(f"{root}{file}" for file in files),
            *(f"logs/{root}{stem}.log" for stem in stems),
            *(f"benchmarks/{root}{stem}.tsv" for stem in stems),
        )
    }


def test_settings_that_agree_give_what_the_study_has_but_for_the_place(project):
    one, other = (xr.load_dataset(project.folder / root / "geometry.nc") for root in ("results", MEMBER))
    assert (one.attrs["result"], other.attrs.pop("result")) == ("geometry.nc", "studies/heat/t120/geometry.nc")
    assert one.identical(other.assign_attrs(result="geometry.nc"))


def test_a_changed_value_of_the_study_reruns_its_members_and_one_of_a_member_only_this(project):
    assert planned(project, {}) == set()
    both = {OWN, "results/with/temperature.nc"}
    assert planned(project, {"friction": {"boundary": 0.11}}) == both
    other = {"heat": {"members": {"t120": {"cases": {"with": {"bulk_temperature": 125.0}}}}}}
    assert planned(project, {"studies": other}) == {OWN}


def test_a_balance_decides_the_temperature_of_the_study_and_gives_way_to_that_of_a_member(project):
    assert planned(project, {"cases": {"with": {"bulk_temperature": "balance"}}}) == {"results/with/temperature.nc"}


def test_the_last_cycle_and_the_reference_are_those_of_the_member(project):
    overrides = {"cases": {"with": {"running_cycles": 0}}, "dynamics": {"reference_case": "temperature_only"}}
    overlay = {"studies": {"new": {"members": {"unworn": overrides}}}}
    sweep = "results/studies/new/unworn/with/sweeps/restart/ste.nc"
    files = project.summary(*project.smoke(overlay), "--", sweep)
    assert sweep in files
    assert "results/studies/new/unworn/temperature_only/mesh_stiffness/q000.nc" in files
    assert "results/studies/new/unworn/with/backlash/q000.nc" in files
    assert not [path for path in files if "/without/" in path or not path.startswith("results/studies/new/unworn/")]


def test_a_bad_override_stops_the_run_with_member_and_key(project):
    overlay = {"studies": {"heat": {"members": {"t120": {"cases": {"with": {"bulk_temprature": 120.0}}}}}}}
    run = overlaid(project, overlay, "-n", "all")
    assert run.returncode != 0
    assert (
        "configuration: 1 problem\n"
        "  studies/heat/t120: cases.with.bulk_temprature: unknown key (did you mean cases.with.bulk_temperature?)\n"
    ) in run.stdout
    assert "Building DAG" not in run.stdout


def test_an_unknown_member_is_named_with_those_there_are(project):
    run = overlaid(project, {"studies": STUDIES}, "-n", "--", "results/studies/heat/t130/with/temperature.nc")
    assert run.returncode != 0
    assert "studies/heat/t130: no such member; members of study heat: t120\n" in run.stdout
