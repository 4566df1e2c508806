"""Files of other settings, other files, another place or on other grids are told from those of the run."""

import numpy as np
import pytest
import xarray as xr

from gearwear.errors import BadFile
from gearwear.io.store import Origin, result_of
from gearwear.run import inputs


def result(path, stage, made_of=None, config=None, code="", held=None, **sizes):
    """Return a dataset as it is loaded from a file, with nothing in it but what it says of itself."""
    origin = Origin(stage, config or {}, code, {name: one.attrs["lineage"] for name, one in (made_of or {}).items()})
    points = {"path": 9, "mesh_phase": 5} | sizes
    coords = {name: np.arange(float(size)) for name, size in points.items()}
    return xr.Dataset(coords=coords, attrs={"result": result_of(held or path), **origin.attributes()})


def check(config=None, **found):
    """Check inputs that are given as pairs of path and dataset, lists of them, or paths alone."""

    def part(one, place):
        return [pair[place] for pair in one] if isinstance(one, list) else one[place]

    files = {name: one if isinstance(one, str) else part(one, 0) for name, one in found.items()}
    loaded = {name: one if isinstance(one, str) else part(one, 1) for name, one in found.items()}
    inputs.check(files, loaded, config or {})


def refused(match, **found):
    with pytest.raises(BadFile, match=f"{match}.*; delete it and run the workflow again"):
        check(**found)


def at(path, *args, **kwargs):
    return f"results/{path}", result(f"results/{path}", *args, **kwargs)


@pytest.fixture
def state():
    """One state after a cycle of wear, and the mesh of the pristine reference case."""
    geometry, other_wear = at("geometry.nc", "geometry"), at("without/wear/q000.nc", "unworn")
    before = at("with/mesh_stiffness/q000.nc", "mesh_excitation")
    made_of = {"geometry": geometry[1]}
    wear = at("with/wear/q001.nc", "wear", made_of | {"mesh_stiffness": before[1]})
    found = {"geometry": geometry, "wear": wear}
    for name in ("mesh_stiffness", "transmission_error", "backlash"):
        found[name] = at(f"with/{name}/q001.nc", "mesh_excitation", made_of | {"wear": wear[1]})
    for name, one in {"reference_stiffness": "mesh_stiffness", "reference_error": "transmission_error"}.items():
        found[name] = at(f"without/{one}/q000.nc", "mesh_excitation", made_of | {"wear": other_wear[1]})
    return found


def test_files_of_one_run_belong_together(state):
    check(**state, template="table.html.j2")


@pytest.mark.parametrize("name", ["wear", "mesh_stiffness", "transmission_error", "reference_stiffness"])
def test_a_file_of_another_geometry_is_named(state, name):
    path, dataset = state[name]
    other = result("results/geometry.nc", "geometry", code="other")
    state[name] = path, result(path, dataset.attrs["stage"], {"geometry": other})
    refused(f"{path}: made of another file than results/geometry.nc", **state)


def test_a_file_of_other_wear_is_named(state):
    path = state["wear"][0]
    state["wear"] = path, result(path, "wear", {"geometry": state["geometry"][1]}, code="other")
    refused(f"with/mesh_stiffness/q001.nc: made of another file than {path}", **state)


def test_a_result_made_of_another_stiffness_is_named(state):
    motion = at("with/response/q001.nc", "response", {"mesh_stiffness": state["mesh_stiffness"][1]})
    check(**state, response=motion)
    path = state["mesh_stiffness"][0]
    other = path, result(path, "mesh_excitation", {"wear": state["wear"][1]}, code="other")
    refused(f"{motion[0]}: made of another file than {path}", mesh_stiffness=other, response=motion)


@pytest.mark.parametrize(
    ("name", "beside"),
    [("backlash", "with/mesh_stiffness/q001.nc"), ("reference_error", "without/mesh_stiffness/q000.nc")],
)
def test_excitations_of_two_makings_are_named(state, name, beside):
    path, dataset = state[name]
    state[name] = path, result(path, "mesh_excitation", {"geometry": state["geometry"][1]}, code="other")
    refused(f"{path}: not made together with results/{beside}", **state)


def test_branches_of_another_excitation_are_named():
    excitation = at("with/excitation.nc", "excitation")
    branches = at("with/branches/ste.nc", "branches", {"excitation": excitation[1]})
    check(branches=branches, excitation=excitation)
    other = at("with/excitation.nc", "excitation", code="other")
    refused(f"{branches[0]}: made of another file than {other[0]}", branches=branches, excitation=other)


@pytest.mark.parametrize("name", ["path", "mesh_phase"])
def test_another_grid_is_named(state, name):
    path, dataset = state["wear"]
    state["wear"] = path, dataset.drop_dims(name).assign_coords({name: np.arange(10.0)})
    size = state["geometry"][1].sizes[name]
    refused(f"{path}: 10 points of {name}, results/geometry.nc has {size}", **state)


@pytest.mark.parametrize("held", ["without/wear/q001.nc", "with/wear/q002.nc", "with/backlash/q001.nc", "wear.nc"])
def test_a_file_at_the_place_of_another_is_named(state, held):
    path, dataset = state["wear"]
    dataset.attrs["result"] = held
    refused(f"{path}: holds the result {held}", **state)


def test_two_exchanged_files_of_a_list_are_named():
    files = [at(f"with/response/q00{q}.nc", "response", code=str(q)) for q in (0, 1)]
    check(response=files)
    exchanged = [(path, other) for (path, _), (_, other) in zip(files, files[::-1], strict=True)]
    refused("q000.nc: holds the result with/response/q001.nc", response=exchanged)


def test_a_file_that_does_not_name_its_place_is_named():
    path, dataset = at("geometry.nc", "geometry")
    del dataset.attrs["result"]
    refused(f"{path}: holds the result of an old version", geometry=(path, dataset))


@pytest.mark.parametrize(
    ("name", "config", "words"),
    [
        ("geometry.nc", {"grid": {"mesh_cells": 80}}, "grid.mesh_cells 80, and it is 32 now"),
        ("with/temperature.nc", {"case": {"bulk_temperature": 90.0}}, "case.bulk_temperature 90.0, and it is 100.0"),
    ],
)
def test_other_settings_are_named(name, config, words):
    now = {"grid": {"mesh_cells": 32}, "cases": {"with": {"bulk_temperature": 100.0}}}
    one = at(name, "geometry", config=config)
    refused(f"{one[0]}: made with {words}", config=now, it=one)
    check(config, it=one)


def test_members_have_settings_of_their_own():
    check(
        {"grid": {"mesh_cells": 32}}, it=at("studies/heat/t120/geometry.nc", "g", config={"grid": {"mesh_cells": 80}})
    )


def test_parts_of_two_makings_are_named():
    parts = [at(f"with/sweeps/parts/ste/{n}-of-2.nc", "sweep_part") for n in (1, 2)]
    check(parts=parts)
    parts[1] = at("with/sweeps/parts/ste/2-of-2.nc", "sweep_part", code="other")
    refused("parts/ste/2-of-2.nc: not made together with .*1-of-2.nc", parts=parts)
