"""Where the stages are, and what they take."""

import subprocess
import sys
from inspect import getdoc, signature
from pathlib import Path

import pytest

from gearwear.chain.cycle import CYCLE
from gearwear.io.variables import variables
from gearwear.run.stages import MODULES, VARIABLES, arguments_of, function_of, target_of

RULES = Path(__file__).resolve().parents[3] / "workflow" / "rules"


@pytest.mark.parametrize("stage", MODULES)
def test_every_stage_has_a_function_of_its_name(stage):
    function = function_of(stage)
    assert (function.__module__, function.__name__) == (f"gearwear.{MODULES[stage]}", stage)
    assert target_of(stage) == f"{MODULES[stage]}:{stage}"
    assert getdoc(function).startswith("Return ")


def test_variables_that_are_read_alone_belong_to_inputs_of_the_stage():
    for stage, inputs in VARIABLES.items():
        assert set(inputs) <= set(arguments_of(stage))
        assert {name for names in inputs.values() for name in names} <= set(variables())


@pytest.mark.parametrize("stage", MODULES)
def test_the_arguments_of_a_stage_are_those_of_its_signature(stage):
    assert arguments_of(stage) == list(signature(function_of(stage)).parameters)


def test_a_wear_cycle_is_made_of_stages():
    assert list(CYCLE) == ["wear", "mesh_excitation", "response"] and set(CYCLE) <= set(MODULES)


def test_planning_loads_no_numerics():
    lines = [line for file in RULES.glob("*.smk") for line in file.read_text(encoding="utf-8").splitlines()]
    modules = {line.split()[1] for line in lines if line.startswith("from gearwear")}
    assert "gearwear.config.members" in modules
    code = f"import sys, {', '.join(sorted(modules))}; print({{'numpy', 'xarray', 'numba'}} & set(sys.modules))"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert run.stdout.strip() == "set()", run.stderr
