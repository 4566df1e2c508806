"""Words for configuration values and for what a key allows, the same in messages and tables."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from decimal import Decimal
from typing import Any

from gearwear.config.units import example

_PLAIN_KEY = re.compile(r"[A-Za-z0-9_-]{1,60}", re.ASCII)
_LONGEST_TEXT = 40
_LARGEST_SHOWN = 10**30
_KINDS = {"number": "a number", "integer": "a whole number", "boolean": "true or false", "string": "a name"}
_MIXED_UP = ("m", "Pa", "Pa s", "1/Pa")  # units whose prefixes are often left out
_REASONS = {
    "not_a_number": "is not a number",
    "not_finite": "is not a finite number",
    "not_whole": "is not a whole number",
    "bool_type": "is neither true nor false",
    "string_type": "is not text",
    "string_unicode": "is not valid text",
    "list_type": "is not a list",
    "dict_type": "is not a group of keys",
    "literal_error": "is not a choice of this key",
    "greater_than_equal": "is below the least allowed value {ge}",
    "greater_than": "is not above {gt}",
    "less_than_equal": "is above the largest allowed value {le}",
    "less_than": "is not below {lt}",
    "too_short": "is too short",
    "too_long": "is too long",
}
_LIMITS = {
    "minimum": "from",
    "exclusiveMinimum": "above",
    "maximum": "up to",
    "exclusiveMaximum": "up to below",
}
_BOUNDS = ("ge", "gt", "le", "lt")
_OUT_OF_RANGE = ("greater_than_equal", "greater_than", "less_than_equal", "less_than")


def shown(value: Any) -> str:
    """Return a short, safe wording of any configuration value."""
    if value is None:
        return "null"
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        cut = value if len(value) <= _LONGEST_TEXT else value[:_LONGEST_TEXT] + "..."
        return f"text {ascii(cut)}"
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if isinstance(value, int | float):
        return figure(value) if abs(value) < _LARGEST_SHOWN else "a number beyond 1.0e+30"
    if isinstance(value, Mapping):
        return "a group of keys"
    if isinstance(value, list | tuple):
        return f"a list of {len(value)}"
    return f"a value of type {type(value).__name__}"


def dotted(path: tuple[Any, ...]) -> str:
    """Return `path` as a.b.c; positions in a list are ("[i]",) entries and follow without a dot."""
    name = ""
    for key in path:
        if isinstance(key, str) and re.fullmatch(r"\[\d+\]", key):
            name += key
        else:
            plain = isinstance(key, str) and _PLAIN_KEY.fullmatch(key)
            name += ("." if name else "") + (key if plain else f"({shown(key)})")
    return name or "(whole configuration)"


def listed(words: list[str], last: str = "and") -> str:
    """Return "a, b and c"."""
    return f" {last} ".join(filter(None, [", ".join(words[:-1]), words[-1] if words else ""]))


def figure(value: float) -> str:
    """Return a number as config.yaml writes it: 0.3, 240, 2.1e+9, 1.0e-20."""
    if value == 0 or 1e-3 <= abs(value) < 1e6:
        return repr(value)
    number = Decimal(repr(value)).normalize()
    first, *rest = number.as_tuple().digits
    return f"{'-' * (value < 0)}{first}.{''.join(map(str, rest)) or '0'}e{number.adjusted():+d}"


def span(schema: dict[str, Any]) -> str:
    """Return the limits of a JSON schema of a number, such as "above 0 up to 1", or ""."""
    words = [f"{word} {_bound(schema[key])}" for key, word in _LIMITS.items() if key in schema]
    return " ".join(words).replace("up to", "to") if "minimum" in schema else " ".join(words)


def _bound(value: float) -> str:
    return figure(int(value) if float(value).is_integer() else value)


def allowed(schema: dict[str, Any], unit: str | None = None) -> str:
    """Return in words what the JSON schema of one key allows, with its unit."""
    if "anyOf" in schema:
        return listed([allowed(option, unit) for option in schema["anyOf"]], "or")
    if "enum" in schema:
        return listed(schema["enum"], "or")
    if "const" in schema:
        return schema["const"]
    kind = schema["type"]
    if kind == "null":
        return "null"
    if kind == "object":
        return "keys of the configuration with their values"
    if kind == "array":
        entries = {"string": "names", None: "values"}.get(schema["items"].get("type"), "numbers")
        fewest, most = schema.get("minItems", 0), schema.get("maxItems")
        bounds = f" with {fewest} to {most} entries" if most else " with at least one entry" if fewest else ""
        return f"a list of {entries}{bounds}"
    return " ".join(filter(None, [_KINDS[kind], span(schema), unit if unit and unit != "1" else ""]))


def with_units(schema: dict[str, Any], unit: str | None) -> str:
    """Return in words what a key allows, with an example of a value that carries its unit."""
    return f"give {allowed(schema, unit)} (or with its unit, such as {example(unit)})"


def refusal(error: Mapping[str, Any], given: Any, schema: dict[str, Any], unit: str | None) -> str:
    """Return the message for one pydantic error of a key with the JSON schema and unit given.

    Parameters
    ----------
    given : the value as it was written.
    """
    limits = {name: _bound(limit) for name, limit in error.get("ctx", {}).items() if name in _BOUNDS}
    reason = _REASONS.get(error["type"], "cannot be used").format(**limits)
    out = error["type"] in _OUT_OF_RANGE
    value = given if isinstance(given, str) and example(unit) else error["input"]
    advice = with_units(schema, unit) if out and unit in _MIXED_UP else f"give {allowed(schema, unit)}"
    return f"{shown(value)} {reason}{f' {unit}' if out and example(unit) else ''}; {advice}"
