"""Check of the whole configuration, with one message that names every problem in it."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Mapping
from functools import cache, partial
from typing import Any

from pydantic import TypeAdapter, ValidationError
from pydantic.fields import FieldInfo

from gearwear.config import derived, units
from gearwear.config.key_types import Section, adapter, adapter_of, entry_type, free_names, is_section, keys, unit_of
from gearwear.config.rules import Problem, disagreements
from gearwear.config.study_sections import Configuration
from gearwear.config.wording import allowed, dotted, listed, refusal, shown, with_units
from gearwear.errors import ConfigError

_MOST_LINES = 200
_LONGEST_KEY = 60
_UNUSABLE = object()
_NOTHING: Mapping[str, Any] = {}


def check(raw: Any, checked: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """Return the configuration as nested dicts of builtin values, keys in the order of the models.

    What is null and follows from other values gets its number (`gearwear.config.derived`).
    Numbers may be spelled as text (`1e-8` is text in YAML 1.1), whole numbers as 2.1e+9.

    Parameters
    ----------
    raw : the configuration as read from YAML, overlays merged.
    checked : a result of this function; sections that `raw` shares with it are not read again.

    Raises
    ------
    ConfigError : with path, value, allowed values with unit, and remedy for every bad key.
    """
    problems: list[Problem] = []
    values = _read_section(Configuration, raw, (), problems, checked or _NOTHING)
    if not problems:
        values = derived.resolved(values)
    told = {path[:depth] for path, _ in problems for depth in range(len(path) + 1)}
    problems += [problem for problem in disagreements(values) if problem[0] not in told]
    if problems:
        raise refused([("", problem) for problem in problems])
    return Configuration.model_validate(values).model_dump()


def refused(problems: list[tuple[str, Problem]]) -> ConfigError:
    """Return the error that names all the problems."""
    count = len(problems)
    lines = [f"configuration: {count} problem{'s' if count > 1 else ''}"]
    for root, (path, text) in problems[:_MOST_LINES]:
        lines.append(f"  {root.rstrip('/')}{': ' if root else ''}{dotted(path)}: {text}")
    if count > _MOST_LINES:
        lines.append(f"  and {count - _MOST_LINES} more")
    return ConfigError("\n".join(lines), problems)


def _read_section(
    model: type[Section], raw: Any, path: tuple, problems: list[Problem], checked: Mapping[str, Any] = _NOTHING
) -> dict[str, Any]:
    fields = model.model_fields
    found = _grouped(raw, path, f"give the keys {listed(list(fields))} below it", problems)
    problems.extend(((*path, key), _unknown(key, path, list(fields))) for key in found if key not in fields)
    values = {}
    for name, field in fields.items():
        if name in found and found[name] is checked.get(name, _UNUSABLE):
            values[name] = found[name]
        elif name in found:
            values[name] = _readers(model)[name](found[name], (*path, name), problems)
        elif isinstance(raw, Mapping) and field.is_required():
            problems.append(((*path, name), _missing(field)))
    return _usable(values)


def _read_table(field: FieldInfo, raw: Any, path: tuple, problems: list[Problem]) -> Any:
    entry = entry_type(field.annotation)
    values = {}
    for name, item in _grouped(raw, path, _entries_of(field), problems).items():
        here = (*path, name)
        if not isinstance(name, str):
            problems.append((here, "the name is not text; put it in quotes or choose another"))
        elif is_section(entry):
            values[name] = _read_section(entry, item, here, problems)
        else:
            values[name] = _read_value(adapter(entry), unit_of(field), item, here, problems)
    return _usable(values) if isinstance(raw, Mapping) else _UNUSABLE


@cache
def _readers(model: type[Section]) -> dict[str, Callable[[Any, tuple, list[Problem]], Any]]:
    return {name: _reader(field) for name, field in model.model_fields.items()}


def _reader(field: FieldInfo) -> Callable[[Any, tuple, list[Problem]], Any]:
    if is_section(field.annotation):
        return partial(_read_section, field.annotation)
    if entry_type(field.annotation) is not None:
        return partial(_read_table, field)
    return partial(_read_value, adapter_of(field), unit_of(field))


def _read_value(reader: TypeAdapter, unit: str | None, raw: Any, path: tuple, problems: list[Problem]) -> Any:
    known = len(problems)
    plain = _without_unit(reader, unit, raw, path, problems)
    if len(problems) > known:
        return _UNUSABLE
    try:
        return reader.validate_python(plain)
    except ValidationError as refused:
        schema = reader.json_schema()
        told = set()
        for error in refused.errors(include_url=False):
            # A choice of types yields one error for each of them; the first says enough.
            entry = tuple(f"[{part}]" for part in error["loc"] if isinstance(part, int))
            if entry not in told:
                told.add(entry)
                given = raw[error["loc"][0]] if entry else raw
                problems.append(((*path, *entry), refusal(error, given, schema["items"] if entry else schema, unit)))
        return _UNUSABLE


def _without_unit(reader: TypeAdapter, unit: str | None, raw: Any, path: tuple, problems: list[Problem]) -> Any:
    def convert(value, *entry):
        try:
            return units.plain(value, unit)
        except units.UnitError as refused:
            schema = reader.json_schema()
            meant = with_units(schema["items"] if entry else schema, unit)
            problems.append(((*path, *entry), f"{shown(value)} {refused}; {meant}"))

    if isinstance(raw, list):
        return [convert(value, f"[{place}]") for place, value in enumerate(raw)]
    return convert(raw)


def _grouped(raw: Any, path: tuple, remedy: str, problems: list[Problem]) -> Mapping:
    if isinstance(raw, Mapping):
        return raw
    problems.append((path, f"{shown(raw)} is not a section; {remedy}"))
    # A dash before every key makes YAML read a list of one-key sections: look at those keys too.
    groups = [item for item in raw if isinstance(item, Mapping)] if isinstance(raw, list | tuple) else []
    return {key: group[key] for group in groups for key in group}


def _usable(values: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in values.items() if value is not _UNUSABLE}


def _entries_of(field: FieldInfo) -> str:
    return f"give names of {free_names(field)} with their values below it"


def _missing(field: FieldInfo) -> str:
    if is_section(field.annotation):
        return f"missing section; give its keys {listed(list(field.annotation.model_fields))}"
    if entry_type(field.annotation) is not None:
        return f"missing section; {_entries_of(field)}"
    return f"missing; give {allowed(adapter_of(field).json_schema(), unit_of(field))}"


def _unknown(key: Any, path: tuple, siblings: list[str]) -> str:
    hints = []
    if isinstance(key, str):
        places = _places()
        if near := difflib.get_close_matches(key[:_LONGEST_KEY], siblings, 1):
            hints.append(f"did you mean {dotted((*path, near[0]))}?")
        if exact := [dotted(place) for place in places if place[-1] == key]:
            hints.append(f"the key of that name is {listed(exact[:3], 'or')}")
        if not hints:
            far = difflib.get_close_matches(key[:_LONGEST_KEY], [place[-1] for place in places], 1, 0.75)
            hints += [f"did you mean {dotted(place)}?" for place in places if place[-1] in far][:1]
    return f"unknown key ({' '.join(hints)})" if hints else f"unknown key; the keys here are {listed(siblings)}"


@cache
def _places() -> tuple[tuple[str, ...], ...]:
    return tuple(path for path, _ in keys(Configuration))
