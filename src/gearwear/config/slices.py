"""Which configuration keys each stage reads: the contract behind every re-run.

`case` stands for the entry of the case at hand in `cases`, `{sweep}` for the name of a sweep, `{reference}` for that of
the reference case.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gearwear.config.parameters import SWEEPS
from gearwear.config.study import Calibration
from gearwear.errors import ConfigError

_EXCITED = ("dynamics", "settling", "operation.pinion_torque")
_OSCILLATOR = ("dynamics.damping_ratio", "dynamics.torque_fluctuation", "dynamics.tolerance")
_MOVED = (*_OSCILLATOR, "dynamics.start", "settling")
_WHOLE_CHAIN = (
    "gear_pair",
    "micro_geometry",
    "grid",
    "material",
    "elasticity",
    "operation",
    "lubricant",
    "friction",
    "heat",
    "heat_balance",
    "mesh_stiffness",
    "transmission_error",
    "backlash",
    "wear",
    "dynamics",
    "settling",
)
_BOTH_CASES = ("cases.without", "cases.with", "cases.{reference}")
_ROUTE = ("sweeps.order", "sweeps.mesh_frequency", "branches.largest_step", "branches.most_nodes", "onsets.refinement")
_HOT_STEEL = (
    "elasticity",
    "material.pinion.youngs_modulus",
    "material.pinion.poisson_ratio",
    "material.pinion.thermal_expansion",
    "material.gear.youngs_modulus",
    "material.gear.poisson_ratio",
    "material.gear.thermal_expansion",
    "case.bulk_temperature",
)

STAGES: dict[str, tuple[str, ...]] = {
    "geometry": ("gear_pair", "micro_geometry", "grid", "material.pinion.density", "material.gear.density"),
    "temperature": (
        "elasticity",
        "material",
        "operation",
        "lubricant",
        "friction",
        "mesh_stiffness",
        "heat_balance",
        "heat.flash_coefficient",
        "case.bulk_temperature",
        "case.flash",
    ),
    "deformation": (
        "heat.initial_temperature",
        "heat.shaft_temperature_drop",
        "heat.temperature_rise",
        "heat.hub",
        "heat.growth",
        "material.pinion.thermal_expansion",
        "material.gear.thermal_expansion",
        "case.bulk_temperature",
    ),
    "wear_history": (*_WHOLE_CHAIN, "case.bulk_temperature", "case.flash", "cases.{reference}"),
    "unworn": (),
    "wear": ("wear", "operation", "lubricant", *_HOT_STEEL),
    "mesh_excitation": (
        "mesh_stiffness",
        "transmission_error",
        "backlash",
        "heat.initial_temperature",
        "operation.pinion_torque",
        *_HOT_STEEL,
    ),
    "handover_dataset": ("dynamics.stiffness",),
    "response": (*_EXCITED, "operation.pinion_speed"),
    "excitation": (
        "dynamics.stiffness",
        "dynamics.harmonics",
        "dynamics.ste_amplitude",
        "dynamics.clearance",
        "dynamics.model",
        "dynamics.bearings",
        "operation.pinion_torque",
    ),
    "prescribed_excitation": ("oscillators.{case}",),
    "sweep": (*_MOVED, "sweeps.{sweep}"),
    "branches": (*_OSCILLATOR, "sweeps.{sweep}", "branches"),
    "map_ste": (*_EXCITED, "maps.mesh_frequency", "maps.ste"),
    "map_backlash": (*_EXCITED, "maps.mesh_frequency", "maps.backlash", "sweeps.backlash.reading"),
    "temperature_map_tile": (*_EXCITED, "maps.mesh_frequency", "maps.temperature"),
    "map_wear": (*_EXCITED, "maps.mesh_frequency"),
    "case_onsets": (*_MOVED, "sweeps.order", "onsets.refinement"),
    "measures": (*_WHOLE_CHAIN, *_BOTH_CASES, *_ROUTE),
    "member_onsets": (
        *_WHOLE_CHAIN,
        *_BOTH_CASES,
        "sweeps.order",
        "sweeps.mesh_frequency",
        "branches",
        "onsets.refinement",
    ),
    "outcome": (*_EXCITED, "operation.pinion_speed", *_ROUTE),
    "study": ("sweeps.order", "sweeps.mesh_frequency"),
    "sensitivity_comparison": ("sensitivity",),
    "onset_shifts": ("sweeps.order", "onsets.members", "onsets.box"),
    "calibration": (
        *_WHOLE_CHAIN,
        *_BOTH_CASES,
        "sweeps.mesh_frequency",
        "sweeps.ste",
        "sweeps.backlash",
        *(f"calibration.{name}" for name in Calibration.model_fields if name != "islands"),
    ),
    "warnings": ("lubricant.pressure_viscosity", "lubricant.composite_roughness", "wear.law"),
    "portraits": (*_MOVED, "sweeps.{sweep}", "portraits.{sweep}.{case}"),
    "motions": (*_OSCILLATOR, "sweeps.{sweep}"),
    "basins": (
        *_OSCILLATOR,
        "settling",
        "sweeps.{sweep}",
        "basins.points.{sweep}.{case}",
        "basins.displacement",
        "basins.velocity",
        "basins.resolution",
    ),
}

# Stages that follow branches of periodic orbits, or take a motion up from its section, which model torsional alone has.
FOLLOWING = ("branches", "case_onsets", "measures", "member_onsets", "outcome", "motions")

# Keys of a sweep that a stage passes over: the list of cases decides which files are made, not what is in them.
_PASSED_OVER = {
    "sweep": ("cases",),
    "measures": ("cases",),
    "member_onsets": ("cases",),
    "outcome": ("cases",),
    "study": ("cases",),
    "calibration": ("cases",),
    "branches": ("cases", "points"),
    "portraits": ("cases", "first", "last", "points"),
    "motions": ("cases", "first", "last", "points"),
    "basins": ("cases", "first", "last", "points"),
}


def slice_of(config: dict[str, Any], stage: str, case: str = "", sweep: str = "") -> dict[str, Any]:
    """Return the settings `stage` may see, as one nested dict of builtin values with sorted keys.

    Raises
    ------
    ConfigError : the model of the configuration has no such stage.
    """
    wanted, model = list(STAGES[stage]), config["dynamics"]["model"]
    if stage in FOLLOWING and model != "torsional":
        raise ConfigError(
            f"dynamics.model: {model} has neither branches of periodic orbits nor a section that is its whole state; "
            f"without them there are no {stage}: give torsional, or leave this target out"
        )
    cut: dict[str, Any] = {}
    for dotted in wanted:
        path = dotted.format(case=case, sweep=sweep, reference=config["dynamics"]["reference_case"]).split(".")
        source: Any = {**config, "case": config["cases"][case]} if case in config["cases"] else config
        target = cut
        for name in path[:-1]:
            source = source[name]
            target = target.setdefault(name, {})
        target[path[-1]] = source[path[-1]]
    for name, settings in cut.get("sweeps", {}).items():
        if isinstance(settings, dict):
            passed_over = _PASSED_OVER.get(stage, ())
            cut["sweeps"][name] = {key: value for key, value in settings.items() if key not in passed_over}
    return _sorted(cut)


def readers(path: tuple[str, ...], stages: Mapping[str, tuple[str, ...]]) -> list[str]:
    """Return the stages that read the key at `path` or a section around it, in the order of `stages`."""
    return [stage for stage, wanted in stages.items() if any(_covers(key, path) for key in wanted)]


def _covers(key: str, path: tuple[str, ...]) -> bool:
    parts = key.split(".")
    if parts[0] == "case":
        parts[:1] = ["cases", "{case}"]
    return len(parts) <= len(path) and all(map(_matches, parts, path))


def _matches(part: str, name: str) -> bool:
    return part == name or name == "<case>" or (part == "{sweep}" and name in SWEEPS)


def _sorted(value: Any) -> Any:
    return {key: _sorted(value[key]) for key in sorted(value)} if isinstance(value, dict) else value
