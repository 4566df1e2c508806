"""Stage scripts run on a coarse grid in a temporary folder, without the workflow."""

import copy
import importlib
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import xarray as xr
import yaml

from gearwear.config import check
from gearwear.config.members import merged
from gearwear.config.slices import slice_of
from gearwear.io import store

ROOT = Path(__file__).resolve().parents[2]

MESH = ("geometry", "mesh_stiffness", "transmission_error", "backlash", "reference_stiffness", "reference_error")

# stage: script and named inputs
STAGES = {
    "geometry": ("build_geometry", ()),
    "temperature": ("heat_contact", ("geometry",)),
    "deformation": ("grow_flanks", ("geometry", "temperature")),
    "start_wear": ("start_wear", ("geometry",)),
    "mesh_stiffness": ("build_stiffness", ("geometry", "deformation", "wear")),
    "transmission_error": ("share_load", ("geometry", "deformation", "wear", "mesh_stiffness")),
    "backlash": ("open_backlash", ("geometry", "deformation", "wear", "transmission_error")),
    "response": ("solve_response", MESH),
    "excitation": ("build_excitation", MESH),
    "advance_wear": ("advance_wear", ("geometry", "wear", "mesh_stiffness", "transmission_error", "response")),
}


class Inputs(dict):
    """Named input files, by attribute and as items, as a job has them."""

    __getattr__ = dict.__getitem__


@pytest.fixture(scope="session")
def study():
    """Return a function that makes a valid configuration from dotted keys and their values.

    The pair is that of the preset `benchmark`: the numbers that the tests expect belong to it.
    """
    texts = [(ROOT / "config" / name).read_text() for name in ("config.yaml", "presets/benchmark.yaml")]

    def make(changes=None):
        raw = merged(*map(yaml.safe_load, texts))
        for dotted, value in ({"grid.mesh_cells": 40} | (changes or {})).items():
            *sections, key = dotted.split(".")
            target = raw
            for name in sections:
                target = target[name]
            target[key] = copy.deepcopy(value)
        return check.check(raw)

    return make


@pytest.fixture(scope="session")
def run_stage(tmp_path_factory):
    """Return a function that runs one stage and returns its file."""

    def run(stage, config, case, files):
        script, names = STAGES[stage]
        output = tmp_path_factory.mktemp(stage) / f"{stage}.nc"
        job = SimpleNamespace(
            rule=script,
            input=Inputs({name: str(files[name]) for name in names}),
            output=[str(output)],
            params=SimpleNamespace(cfg=slice_of(config, stage, case), code="0123456789abcdef"),
            log=[str(output.with_suffix(".log"))],
            wildcards=SimpleNamespace(case=case),
        )
        importlib.import_module(script).main(job)
        return output

    return run


@pytest.fixture(scope="session")
def run_chain(run_stage):
    """Return a function that runs the stages from geometry to backlash of one state of the flanks.

    Given are the changed files of an earlier state (`files`), which stand instead of the stages that would make them.
    """

    def run(config, case, files=None):
        files = dict(files or {})
        for stage in ("geometry", "temperature", "deformation", "start_wear", "mesh_stiffness"):
            name = "wear" if stage == "start_wear" else stage
            if name not in files:
                files[name] = run_stage(stage, config, case, files)
        for stage in ("transmission_error", "backlash"):
            files[stage] = run_stage(stage, config, case, files)
        return files

    return run


@pytest.fixture(scope="session")
def loaded():
    """Return a function that loads one file of a chain by its name."""
    return lambda files, name: store.load(files[name])


@pytest.fixture(scope="session")
def states(study, run_chain):
    """Return a function that gives the files of a pristine state of one case of the default study, made once."""
    made = {}

    def of(case):
        if case not in made:
            given = {"geometry": next(iter(made.values()))["geometry"]} if made else {}
            made[case] = run_chain(study(), case, given)
        return dict(made[case])

    return of


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
        path, pitch = geometry["path"].values, float(geometry["pitch_point"])
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


@pytest.fixture
def advance(rerun, write_response, loaded):
    """Return a function that wears the flanks by one block under a given mesh force; default the static one."""

    def run(files, case="with", force=None, **changes):
        geometry = loaded(files, "geometry")
        if force is None:
            force = np.full(geometry.sizes["path"], 130.0 / float(geometry["base_radius"][0]))
        return rerun("advance_wear", case, files | {"response": write_response(geometry, force)}, **changes)

    return run
