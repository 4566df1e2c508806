"""Which configuration keys each stage reads: the contract behind every re-run.

`case` stands for the entry of the case at hand in `cases`, `{sweep}` for the name of a sweep, `{reference}` for that of
the reference case.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gearwear.plumbing.calibration_sections import Calibration
from gearwear.plumbing.key_types import SWEEPS

_EXCITED = ("dynamics", "settling", "operation.pinion_torque")
_WHOLE_CHAIN = (
    "gear_pair",
    "grid",
    "material",
    "elasticity",
    "operation",
    "lubricant",
    "friction",
    "heat",
    "mesh_stiffness",
    "transmission_error",
    "backlash",
    "wear",
    "dynamics",
    "settling",
    "cases.without",
    "cases.with",
    "cases.{reference}",
)
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
    "geometry": ("gear_pair", "grid", "material.pinion.density", "material.gear.density"),
    "temperature": (
        "elasticity",
        "material",
        "operation",
        "lubricant",
        "friction",
        "mesh_stiffness",
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
    "start_wear": (),
    "advance_wear": ("wear", "operation", "lubricant", *_HOT_STEEL),
    "mesh_stiffness": ("mesh_stiffness", *_HOT_STEEL),
    "transmission_error": ("transmission_error", "operation.pinion_torque"),
    "backlash": ("backlash",),
    "response": (*_EXCITED, "operation.pinion_speed"),
    "sweep": (*_EXCITED, "sweeps.{sweep}"),
    "branches": ("dynamics", "operation.pinion_torque", "sweeps.{sweep}", "branches"),
    "map_ste": (*_EXCITED, "maps.mesh_frequency", "maps.ste"),
    "map_backlash": (*_EXCITED, "maps.mesh_frequency", "maps.backlash", "sweeps.backlash.reading"),
    "map_temperature": (*_EXCITED, "maps.mesh_frequency", "maps.temperature"),
    "map_wear": (*_EXCITED, "maps.mesh_frequency"),
    "onsets": (*_EXCITED, "sweeps.order", "onsets.refinement"),
    "measures": (
        *_WHOLE_CHAIN,
        "sweeps.order",
        "sweeps.mesh_frequency",
        "branches.largest_step",
        "branches.most_nodes",
        "onsets.refinement",
    ),
    "sensitivity": ("sensitivity",),
    "onset_shifts": ("sweeps.order", "onsets.members", "onsets.box"),
    "calibration": (
        *_WHOLE_CHAIN,
        "sweeps.mesh_frequency",
        "sweeps.ste",
        "sweeps.backlash",
        *(f"calibration.{name}" for name in Calibration.model_fields if name != "islands"),
    ),
    "warnings": ("lubricant.pressure_viscosity", "lubricant.composite_roughness", "wear.law"),
    "portraits": (*_EXCITED, "sweeps.{sweep}", "portraits.{sweep}.{case}"),
    "basins": (
        *_EXCITED,
        "sweeps.{sweep}",
        "basins.points.{sweep}.{case}",
        "basins.displacement",
        "basins.velocity",
        "basins.resolution",
    ),
}

# Keys of a sweep that a stage passes over: the list of cases decides which files are made, not what is in them.
_PASSED_OVER = {
    "sweep": ("cases",),
    "measures": ("cases",),
    "calibration": ("cases",),
    "branches": ("cases", "points"),
    "portraits": ("cases", "first", "last", "points"),
    "basins": ("cases", "first", "last", "points"),
}


def slice_of(config: dict, stage: str, case: str = "", sweep: str = "") -> dict[str, Any]:
    """Return the settings `stage` may see, as one nested dict of builtin values with sorted keys."""
    wanted = list(STAGES[stage])
    if stage == "mesh_stiffness" and config["mesh_stiffness"]["hertz"] == "weber":
        wanted.append("operation.pinion_torque")
    cut: dict[str, Any] = {}
    for dotted in wanted:
        path = dotted.format(case=case, sweep=sweep, reference=config["dynamics"]["reference_case"]).split(".")
        source: Any = {**config, "case": config["cases"].get(case)}
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
