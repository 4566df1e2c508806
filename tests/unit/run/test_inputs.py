"""Files of another configuration, of other files and on other grids are told from those of the run."""

import json
from types import SimpleNamespace

import netCDF4
import pytest

from gearwear.run import inputs


@pytest.fixture
def write(tmp_path, monkeypatch):
    """Return a function that writes a result file which holds nothing but what it says of itself."""
    monkeypatch.chdir(tmp_path)

    def write(name, stage, lineage, inputs=None, config=None, **sizes):
        path = tmp_path / "results" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        with netCDF4.Dataset(path, "w") as file:
            for dimension, size in ({"path": 9, "mesh_phase": 5} | sizes).items():
                file.createDimension(dimension, size)
            file.setncatts(
                {
                    "source": "gearwear",
                    "stage": stage,
                    "lineage": lineage,
                    "inputs": json.dumps(inputs or {}),
                    "config": json.dumps(config or {}),
                }
            )
        return f"results/{name}"

    return write


def job(config=None, **inputs):
    return SimpleNamespace(input=inputs, config=config or {})


def refused(match, **inputs):
    config = inputs.pop("config", None)
    with pytest.raises(ValueError, match=f"{match}.*; delete it and run the workflow again"):
        inputs.check(job(config, **inputs))


@pytest.fixture
def state(write):
    """The files of one state after a cycle of wear, and those of the pristine reference case."""
    mesh = {"geometry": "g", "deformation": "d", "wear": "w1"}
    return {
        "geometry": write("geometry.nc", "build_geometry", "g"),
        "wear": write(
            "with/wear/q001.nc", "advance_wear", "w1", {"geometry": "g", "wear": "w0", "mesh_stiffness": "k0"}
        ),
        "mesh_stiffness": write("with/mesh_stiffness/q001.nc", "build_stiffness", "k1", mesh),
        "transmission_error": write(
            "with/transmission_error/q001.nc", "share_load", "e1", mesh | {"mesh_stiffness": "k1"}
        ),
        "reference_stiffness": write("without/mesh_stiffness/q000.nc", "build_stiffness", "kr", mesh | {"wear": "wr"}),
        "reference_error": write("without/transmission_error/q000.nc", "share_load", "er", {"mesh_stiffness": "kr"}),
    }


def test_files_of_one_run_belong_together(state):
    inputs.check(job(**state, template="table.html.j2"))


@pytest.mark.parametrize("name", ["wear", "mesh_stiffness", "transmission_error", "reference_stiffness"])
def test_a_file_of_another_geometry_is_named(state, write, name):
    stage = {"wear": "advance_wear", "transmission_error": "share_load"}.get(name, "build_stiffness")
    write(state[name].removeprefix("results/"), stage, "x", {"geometry": "other"})
    refused(f"{state[name]}: made of another file than results/geometry.nc", **state)


def test_a_file_of_other_wear_or_stiffness_is_named(state, write):
    write("with/wear/q001.nc", "advance_wear", "w2", {"geometry": "g"})
    refused("with/mesh_stiffness/q001.nc: made of another file than results/with/wear/q001.nc", **state)
    write("without/mesh_stiffness/q000.nc", "build_stiffness", "k9", {"geometry": "g"})
    del state["wear"]
    refused("without/transmission_error/q000.nc: made of another file than results/without/mesh_stiff", **state)


def test_branches_of_another_excitation_are_named(write):
    excitation = write("with/excitation.nc", "build_excitation", "x1")
    branches = write("with/branches/ste.nc", "continue_orbits", "b", {"excitation": "x1"})
    inputs.check(job(branches=branches, excitation=excitation))
    write("with/excitation.nc", "build_excitation", "x2")
    refused(f"{branches}: made of another file than {excitation}", branches=branches, excitation=excitation)


def test_another_grid_is_named(state, write):
    write("with/wear/q001.nc", "advance_wear", "w1", {"geometry": "g"}, path=10)
    refused("with/wear/q001.nc: 10 points of path, results/geometry.nc has 9", **state)


@pytest.mark.parametrize(
    ("name", "config", "words"),
    [
        ("geometry.nc", {"grid": {"mesh_cells": 80}}, "grid.mesh_cells 80, and it is 32 now"),
        (
            "with/temperature.nc",
            {"case": {"bulk_temperature": 90.0}},
            "case.bulk_temperature 90.0, and it is 100.0 now",
        ),
    ],
)
def test_other_settings_are_named(write, name, config, words):
    now = {"grid": {"mesh_cells": 32}, "cases": {"with": {"bulk_temperature": 100.0}}}
    stage = {"geometry.nc": "build_geometry"}.get(name, "heat_contact")
    path = write(name, stage, "g", config=config)
    refused(f"{path}: made with {words}", config=now, it=path)
    inputs.check(job(config, it=path))


def test_members_have_settings_of_their_own(write):
    path = write("studies/heat/t120/geometry.nc", "build_geometry", "g", config={"grid": {"mesh_cells": 80}})
    inputs.check(job({"grid": {"mesh_cells": 32}}, it=path))


def test_parts_of_two_makings_are_named(write):
    parts = [write(f"with/sweeps/parts/ste/{n}-of-2.nc", "sweep_part", "p") for n in (1, 2)]
    inputs.check(job(parts=parts))
    write("with/sweeps/parts/ste/2-of-2.nc", "sweep_part", "q")
    refused("parts/ste/2-of-2.nc: not of one making with .*1-of-2.nc", parts=parts)
