"""Where the stages are, and what they take."""

import subprocess
import sys
from inspect import signature
from pathlib import Path

import pytest

from gearwear.chain.cycle import CYCLE
from gearwear.run.stages import MODULES, arguments_of, function_of

RULES = Path(__file__).resolve().parents[3] / "workflow" / "rules"


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
