"""Where the function of every stage is; a stage, its rule and its function have one name."""

from __future__ import annotations

import ast
from importlib import import_module
from pathlib import Path
from typing import Any

_STAGES = {
    "chain.geometry": "geometry",
    "chain.temperature": "temperature",
    "chain.deformation": "deformation flash_growth",
    "chain.wear": "unworn wear",
    "chain.mesh": "mesh_excitation",
    "chain.response": "response",
    "chain.history": "wear_history",
    "stages.motion": "excitation prescribed_excitation sweep_part sweep branches portraits motions basins",
    "stages.maps": "map_tile temperature_map_tile map",
    "stages.onsets": "case_onsets onset_variants member_onsets onset_shifts",
    "stages.studies": "outcome study measures sensitivity_comparison",
    "stages.calibration": "search calibration",
    "stages.handover": "handover_dataset handover_tables",
    "stages.evaluation": "parameters versions warnings claims claims_page motion_page",
    "stages.validation": "validation_group validation_page",
}
MODULES = {name: module for module, names in _STAGES.items() for name in names.split()}

# Variables that a stage reads of an input that has many files; of all other inputs it reads all.
VARIABLES = {
    "warnings": {
        "transmission_error": ("elastic_deflection",),
        "wear": ("wear_per_revolution", "running_cycles"),
        "response": ("motion_class",),
    },
}


def target_of(stage: str) -> str:
    """Return the function of a stage as `gearwear.run.digest` names it."""
    return f"{MODULES[stage]}:{stage}"


def function_of(stage: str) -> Any:
    """Return the function of a stage."""
    return getattr(import_module(f"gearwear.{MODULES[stage]}"), stage)


def arguments_of(stage: str) -> list[str]:
    """Return the names of the arguments of a stage, read from its source: planning does without the numerics."""
    module = Path(__file__).resolve().parents[1].joinpath(*MODULES[stage].split(".")).with_suffix(".py")
    definitions = ast.parse(module.read_text(encoding="utf-8")).body
    arguments = next(one.args for one in definitions if isinstance(one, ast.FunctionDef) and one.name == stage)
    return [argument.arg for argument in arguments.args]
