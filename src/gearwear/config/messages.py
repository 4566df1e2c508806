"""Messages for what pydantic finds wrong in a configuration, each with key, value, allowed range and remedy."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from functools import cache
from typing import Any, NamedTuple

from pydantic import TypeAdapter, ValidationError
from pydantic.fields import FieldInfo

from gearwear.config.study import Configuration
from gearwear.config.text import Path, Problem, dotted, figure, listed, shown
from gearwear.config.types import entry_type, free_names, is_section, keys, schema_of, unit_of
from gearwear.config.units import example

_LONGEST_KEY = 60
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
_LIMITS = {"minimum": "from", "exclusiveMinimum": "above", "maximum": "up to", "exclusiveMaximum": "up to below"}
_BOUNDS = ("ge", "gt", "le", "lt")
_MISSING = "missing"


class Place(NamedTuple):
    """Where an error is: path with "[i]" for positions in lists, type and declaration of the key, value as written."""

    path: Path
    kind: Any
    field: FieldInfo
    given: Any


def problems_of(error: ValidationError, place: Place) -> list[Problem]:
    """Return path and message of every problem in the order of the models, unknown keys last in their section.

    Parameters
    ----------
    place : of what was validated.
    """
    problems: dict[Path, str] = {}
    for details in error.errors(include_url=False):
        found = _place_of(details, place)
        # A choice of types yields one error for each of them; the first says enough.
        if found.path not in problems:
            problems[found.path] = _message(details, found)
            problems |= _below(found)
    return list(problems.items())


def _place_of(details: Mapping[str, Any], place: Place) -> Place:
    """Return the place of a pydantic error; an unknown key, or one that is not text, has the type of what it is in."""
    path, kind, field, given = place
    for part in details["loc"]:
        if part == "[key]" and details["type"].startswith("string_"):
            return Place((*path[:-1], details["input"]), kind, field, given)
        if is_section(kind) and part not in kind.model_fields:
            return Place((*path, details["input"] if details["type"] == "invalid_key" else part), kind, field, given)
        if is_section(kind):
            field = kind.model_fields[part]
            path, kind = (*path, part), field.annotation
        elif entry_type(kind) is not None:
            path, kind = (*path, part), entry_type(kind)
        elif isinstance(part, int):
            path = (*path, f"[{part}]")
        else:  # a type of a choice
            continue
        try:
            given = given[part]
        except (LookupError, TypeError):  # missing
            given = None
    return Place(path, kind, field, given)


def _below(place: Place) -> dict[Path, str]:
    """Return the problems in the keys of a list of one-key sections: what YAML reads with a dash before every key."""
    groups = [item for item in place.given if isinstance(item, Mapping)] if isinstance(place.given, list) else []
    given = {key: group[key] for group in groups for key in group}
    if not given or not (is_section(place.kind) or _is_table(place)):
        return {}
    try:
        TypeAdapter(place.kind).validate_python(given)
    except ValidationError as error:
        keys_of = len(place.path) + 1
        found = problems_of(error, place._replace(given=given))
        return {path: text for path, text in found if len(path) > keys_of or not text.startswith(_MISSING)}
    return {}


def _message(details: Mapping[str, Any], place: Place) -> str:
    """Return the message for a pydantic error."""
    if details["type"] in ("extra_forbidden", "invalid_key"):
        return _unknown(place.path, list(place.kind.model_fields))
    if details["type"].startswith("string_") and details["loc"][-1] == "[key]":
        return "the name is not text; put it in quotes or choose another"
    field, unit, missing = place.field, unit_of(place.field), details["type"] == "missing"
    if is_section(place.kind):
        names = listed(list(place.kind.model_fields))
        remedy = f"give its keys {names}" if missing else f"give the keys {names} below it"
    else:
        remedy = f"give names of {free_names(field)} with their values below it" if _is_table(place) else ""
    if missing:
        return f"{_MISSING} section; {remedy}" if remedy else f"{_MISSING}; give {allowed(schema_of(field), unit)}"
    if remedy:
        return f"{shown(place.given)} is not a section; {remedy}"
    schema = schema_of(field)
    if place.path[-1].startswith("["):
        schema = schema["items"]
    if details["type"] == "unit":
        return f"{shown(place.given)} {details['msg']}; {_with_units(schema, unit)}"
    limits = {name: _bound(limit) for name, limit in details.get("ctx", {}).items() if name in _BOUNDS}
    reason = _REASONS.get(details["type"], "cannot be used").format(**limits)
    value = place.given if isinstance(place.given, str) and example(unit) else details["input"]
    advice = _with_units(schema, unit) if limits and unit in _MIXED_UP else f"give {allowed(schema, unit)}"
    return f"{shown(value)} {reason}{f' {unit}' if limits and example(unit) else ''}; {advice}"


def _is_table(place: Place) -> bool:
    return place.kind is place.field.annotation and entry_type(place.kind) is not None


def _unknown(path: Path, siblings: list[str]) -> str:
    hints, key = [], path[-1]
    if isinstance(key, str):
        places = _places()
        if near := difflib.get_close_matches(key[:_LONGEST_KEY], siblings, 1):
            hints.append(f"did you mean {dotted((*path[:-1], near[0]))}?")
        if exact := [dotted(place) for place in places if place[-1] == key]:
            hints.append(f"the key of that name is {listed(exact[:3], 'or')}")
        if not hints:
            far = difflib.get_close_matches(key[:_LONGEST_KEY], [place[-1] for place in places], 1, 0.75)
            hints += [f"did you mean {dotted(place)}?" for place in places if place[-1] in far][:1]
    return f"unknown key ({' '.join(hints)})" if hints else f"unknown key; the keys here are {listed(siblings)}"


@cache
def _places() -> tuple[tuple[str, ...], ...]:
    return tuple(path for path, _ in keys(Configuration))


def span(schema: dict[str, Any]) -> str:
    """Return the limits of a JSON schema of a number, such as "above 0 up to 1", or ""."""
    words = [f"{word} {_bound(schema[key])}" for key, word in _LIMITS.items() if key in schema]
    return " ".join(words).replace("up to", "to") if "minimum" in schema else " ".join(words)


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


def _with_units(schema: dict[str, Any], unit: str | None) -> str:
    """Return in words what a key allows, with an example of a value that carries its unit."""
    return f"give {allowed(schema, unit)} (or with its unit, such as {example(unit)})"


def _bound(value: float) -> str:
    return figure(int(value) if float(value).is_integer() else value)
