"""The parameters that the model sensitivity varies between two ends."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from gearwear.config.wording import figure

OPTION, PARAMETER = "option", "parameter"  # groups of variations
ENDS = ("low", "high")

# Name in the section `sensitivity`: key of the configuration.
PLACES = {
    "damping_ratio": "dynamics.damping_ratio",
    "pinion_torque": "operation.pinion_torque",
    "pinion_speed": "operation.pinion_speed",
    "pinion_bore_radius": "gear_pair.bore_radius.pinion",
    "gear_bore_radius": "gear_pair.bore_radius.gear",
    "pressure_viscosity": "lubricant.pressure_viscosity",
    "composite_roughness": "lubricant.composite_roughness",
    "shaft_temperature_drop": "heat.shaft_temperature_drop",
    "half_backlash": "backlash.half_backlash",
}


def out_of_order(values: dict[str, Any]) -> Iterator[tuple[tuple[str, ...], str]]:
    """Yield path and message of every range whose high end is not above its low one.

    Parameters
    ----------
    values : nested dict of the values that are valid on their own; others are absent.
    """
    for name in PLACES:
        low, high = (value_at(values, f"sensitivity.{name}.{end}") for end in ENDS)
        if low is not None and high is not None and high <= low:
            yield (
                ("sensitivity", name, "high"),
                f"{figure(high)} is not above sensitivity.{name}.low, {figure(low)}; exchange them or widen the range",
            )


def value_at(values: dict[str, Any], key: str) -> Any:
    """Return the value of a dotted key, None where it or a section around it is absent."""
    for name in key.split("."):
        if not isinstance(values, dict) or name not in values:
            return None
        values = values[name]
    return values
