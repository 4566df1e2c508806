"""Axes of a study and their values, as tables and figures word them."""

from __future__ import annotations

from typing import Any

_NO_UNIT = ("", "1")
_SIGNS = {"degC": "°C"}


def quantity(key: str) -> str:
    """Return the name of a key without its sections: damping ratio."""
    return key.rsplit(".", 1)[-1].replace("_", " ")


def plain(value: Any) -> str:
    """Return a value without its unit."""
    return value if isinstance(value, str) else f"{value:g}"


def valued(value: Any, unit: str) -> str:
    """Return a value with its unit: 60 °C."""
    return plain(value) if unit in _NO_UNIT else f"{plain(value)} {_SIGNS.get(unit, unit)}"


def axis(key: str, unit: str) -> str:
    """Return the label of an axis: Bulk temperature, °C."""
    name = quantity(key).capitalize()
    return name if unit in _NO_UNIT else f"{name}, {_SIGNS.get(unit, unit)}"


def state(values: dict[str, Any], units: dict[str, str]) -> str:
    """Return the values of several axes in words: bulk temperature 60 °C, damping ratio 0.07."""
    return ", ".join(f"{quantity(key)} {valued(value, units.get(key, ''))}" for key, value in values.items())
