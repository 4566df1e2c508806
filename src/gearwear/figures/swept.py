"""The swept quantities as axes: labels, and the unit of length behind displacements."""

from __future__ import annotations

from typing import Any

LABELS = {
    "mesh_frequency": "Mesh frequency over natural frequency",
    "ste": "Mean static transmission error over that of the reference case",
    "backlash": "Mean backlash over its initial value",
}
# Of an oscillator that is given, not found for a gear pair.
_OVER_THE_GIVEN = {"ste": "Transmission error over the one given", "backlash": "Clearance over the one given"}


def label(sweep: str, state: dict[str, Any]) -> str:
    """Return the swept quantity as an axis names it, for a state of the gear pair or a given oscillator."""
    given = {} if "bulk_temperature" in state else _OVER_THE_GIVEN
    return given.get(sweep, LABELS[sweep])


def length_unit(sweep: str, settings: dict[str, Any]) -> str:
    """Return in words what a displacement of this sweep is divided by."""
    rescaled = sweep == "backlash" and settings["reading"] == "rescale"
    return "swept half backlash" if rescaled else "initial half backlash"


def condition(sweep: str, settings: dict[str, Any]) -> str:
    """Return what the sweep holds fixed, or nothing."""
    return "" if sweep == "mesh_frequency" else f"mesh frequency / natural frequency = {settings['mesh_frequency']:g}"
