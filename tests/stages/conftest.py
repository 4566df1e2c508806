"""States of the pair of the preset `benchmark` on a coarse grid, stage by stage in one process."""

import copy
from inspect import signature
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
import yaml

from gearwear.chain import deformation, geometry, mesh, response, temperature, wear
from gearwear.config import check
from gearwear.config.members import merged
from gearwear.config.slices import slice_of
from gearwear.stages import motion

ROOT = Path(__file__).resolve().parents[2]
CHAIN = {
    "geometry": geometry.geometry,
    "temperature": temperature.temperature,
    "deformation": deformation.deformation,
    "flash_growth": deformation.flash_growth,
    "unworn": wear.unworn,
    "mesh_stiffness": mesh.mesh_stiffness,
    "transmission_error": mesh.transmission_error,
    "backlash": mesh.backlash,
    "mesh_excitation": mesh.mesh_excitation,
    "response": response.response,
    "wear": wear.wear,
    "excitation": motion.excitation,
}
SLICES = {"flash_growth": "deformation"} | dict.fromkeys(
    ("mesh_stiffness", "transmission_error", "backlash"), "mesh_excitation"
)


@pytest.fixture(scope="session")
def study():
    """Return a function that makes a checked configuration from dotted keys and their values.

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
def run_stage():
    """Return a function that calls a stage of the chain with its slice and with what it takes of a state."""

    def run(name, config, case, state):
        stage = CHAIN[name]
        available = state | {"cfg": slice_of(config, SLICES.get(name, name), case)}
        return stage(**{one: available[one] for one in signature(stage).parameters if one in available})

    return run


@pytest.fixture(scope="session")
def run_chain(run_stage):
    """Return a function that makes a state of the flanks, from the geometry to the backlash.

    Datasets of an earlier state stand instead of the stages that would make them.
    """

    def run(config, case, given=None):
        state = dict(given or {})
        for name in ("geometry", "temperature", "deformation", "flash_growth"):
            if name not in state:
                state[name] = run_stage(name, config, case, state)
        if "wear" not in state:
            state["wear"] = run_stage("unworn", config, case, state)
        return state | run_stage("mesh_excitation", config, case, state)

    return run


@pytest.fixture(scope="session")
def states(study, run_chain):
    """Return a function that gives a pristine state of one case of the default study, made once."""
    made = {}

    def of(case):
        if case not in made:
            given = {"geometry": next(iter(made.values()))["geometry"]} if made else {}
            made[case] = run_chain(study(), case, given)
        return dict(made[case])

    return of


@pytest.fixture(scope="session")
def with_reference(states):
    """Return a function that adds the mesh of the pristine reference case to a state."""
    cold = states("without")
    reference = {"reference_stiffness": cold["mesh_stiffness"], "reference_error": cold["transmission_error"]}
    return lambda state: state | reference


@pytest.fixture(scope="session")
def worn(states):
    """Return a function that gives a state of a case whose flanks are worn like a run-in pair, up to 10 um."""

    def of(case):
        state = states(case)
        pair = state["geometry"]
        path, pitch = pair["path"].values, float(pair["pitch_point"])
        shape = 10e-6 * abs(path - pitch) / (pitch - path[0])
        depth = np.stack([shape * np.where(path < pitch, 1.0, 0.3), 0.2 * shape])
        return state | {"wear": state["wear"].assign(wear_depth=(("gear", "path"), depth), running_cycles=1e8)}

    return of


@pytest.fixture(scope="session")
def rerun(study, run_stage):
    """Return a function that runs one stage on a state under changed settings."""

    def run(stage, case, state, **changes):
        return run_stage(stage, study({name.replace("__", "."): value for name, value in changes.items()}), case, state)

    return run


@pytest.fixture(scope="session")
def advance(rerun):
    """Return a function that wears the flanks by one block under a given mesh force; default the static one."""

    def run(state, case="with", force=None, **changes):
        pair = state["geometry"]
        if force is None:
            force = np.full(pair.sizes["path"], 130.0 / float(pair["base_radius"][0]))
        along = {"mesh_force_path": (("response_period", "path"), np.atleast_2d(force))}
        return rerun("wear", case, state | {"response": xr.Dataset(along)}, **changes)

    return run
