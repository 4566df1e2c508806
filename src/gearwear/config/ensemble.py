"""The ensemble of studies over a box of the parameters that the reference paper leaves open.

Plain numbers only: the members are made anew at every start of the workflow.
"""

from __future__ import annotations

from typing import Any

STUDY = "onsets"
NOMINAL = 1.0

# Name in the box: section and key of the configuration; a key with values for both gears is scaled as a whole.
PLACES = {
    "damping_ratio": ("dynamics", "damping_ratio"),
    "bore_radius": ("gear_pair", "bore_radius"),
    "pinion_torque": ("operation", "pinion_torque"),
    "pressure_viscosity": ("lubricant", "pressure_viscosity"),
}
_BASES = (2, 3, 5, 7)


def factors(settings: dict[str, Any]) -> dict[str, dict[str, float]]:
    """Return the factors on the parameters of every member, by its name.

    First every parameter alone at either end of its range, if that is not 1; then `settings["members"]` points of the
    Halton sequence (1960) in the box. More members leave those before them as they are.

    Parameters
    ----------
    settings : the section `onsets`.
    """
    box = settings["box"]
    found = {}
    for name in PLACES:
        for end in ("low", "high"):
            if box[name][end] != NOMINAL:
                found[f"{name}_{end}"] = {other: box[name][end] if other == name else NOMINAL for other in PLACES}
    for index in range(1, settings["members"] + 1):
        found[f"box_{index:03d}"] = {
            name: _between(box[name], radical_inverse(index, base)) for name, base in zip(PLACES, _BASES, strict=True)
        }
    return found


def overrides(config: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """Return the keys in which every member of the ensemble differs from the configuration."""
    members = {}
    for member, scale in factors(config["onsets"]).items():
        changed: dict[str, Any] = {}
        for name, (section, key) in PLACES.items():
            changed.setdefault(section, {})[key] = _scaled(config[section][key], scale[name])
        members[member] = changed
    return members


def radical_inverse(index: int, base: int) -> float:
    """Return the number in (0, 1) whose digits are those of `index`, mirrored at the point."""
    inverse, share = 0.0, 1.0
    while index:
        share /= base
        index, digit = divmod(index, base)
        inverse += digit * share
    return inverse


def _between(ends: dict[str, float], share: float) -> float:
    return ends["low"] + share * (ends["high"] - ends["low"])


def _scaled(value: Any, factor: float) -> Any:
    return {name: factor * one for name, one in value.items()} if isinstance(value, dict) else factor * value
