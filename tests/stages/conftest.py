"""Stage scripts run on a coarse grid in a temporary folder, without the workflow."""

import copy
import importlib
from pathlib import Path
from types import SimpleNamespace

import pytest
import yaml

from gearwear.plumbing import settings, store
from gearwear.plumbing.members import merged
from gearwear.plumbing.slices import slice_of

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
        return settings.check(raw)

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
