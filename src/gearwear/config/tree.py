"""Nested dicts of values, and values by dotted keys such as `heat.growth`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


def value_at(values: Any, key: str) -> Any:
    """Return the value of a dotted key, None where it or a section around it is absent."""
    try:
        for name in key.split("."):
            values = values[name]
    except (LookupError, TypeError):
        return None
    return values


def nested(values: Mapping[str, Any]) -> dict[str, Any]:
    """Return dotted keys with their values as groups of keys."""
    result: dict[str, Any] = {}
    for key, value in values.items():
        *groups, last = key.split(".")
        below = result
        for group in groups:
            below = below.setdefault(group, {})
        below[last] = value
    return result


def merged(base: Mapping[str, Any], overrides: Mapping[str, Any]) -> dict[str, Any]:
    """Return `base` with `overrides` laid over it: groups of keys are merged, all else is replaced."""
    result = dict(base)
    for key, value in overrides.items():
        below = result.get(key)
        if isinstance(below, Mapping) and isinstance(value, Mapping):
            value = merged(below, value)
        result[key] = value
    return result


def dotted_keys(values: Mapping[str, Any], before: str = "") -> list[str]:
    """Return the dotted keys of all values that are no groups of keys."""
    found: list[str] = []
    for name, value in values.items():
        found += dotted_keys(value, f"{before}{name}.") if isinstance(value, dict) else [f"{before}{name}"]
    return found
