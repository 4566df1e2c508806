"""Check of the whole configuration, with one message that names every problem in it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pydantic import ValidationError
from pydantic.fields import FieldInfo

from gearwear.config import derived
from gearwear.config.messages import Place, problems_of
from gearwear.config.rules import disagreements
from gearwear.config.study import Configuration
from gearwear.config.text import Problem, dotted
from gearwear.config.types import UNUSABLE
from gearwear.errors import ConfigError

_MOST_LINES = 200
_MOST_ROUNDS = 8


def check(raw: Any) -> dict[str, Any]:
    """Return the configuration as nested dicts of builtin values, keys in the order of the models.

    What is null and follows from other values gets its number (`gearwear.config.derived`).
    Numbers may be written as text (`1e-8` is text in YAML 1.1), whole numbers as 2.1e+9.

    Parameters
    ----------
    raw : the configuration as read from YAML, overlays merged; sections may be validated models.

    Raises
    ------
    ConfigError : with path, value, allowed values with unit, and remedy for every bad key.
    """
    values, problems = _validated(raw)
    if not problems and (resolved := derived.resolved(values)) is not values:
        values, problems = _validated(resolved)
    named = {path[:depth] for path, _ in problems for depth in range(len(path) + 1)}
    problems += [problem for problem in disagreements(values) if problem[0] not in named]
    if problems:
        raise refused([("", problem) for problem in problems])
    return values


def refused(problems: list[tuple[str, Problem]]) -> ConfigError:
    """Return the error that names all the problems."""
    count = len(problems)
    lines = [f"configuration: {count} problem{'s' if count > 1 else ''}"]
    for root, (path, text) in problems[:_MOST_LINES]:
        lines.append(f"  {root.rstrip('/')}{': ' if root else ''}{dotted(path)}: {text}")
    if count > _MOST_LINES:
        lines.append(f"  and {count - _MOST_LINES} more")
    return ConfigError("\n".join(lines), problems)


def _validated(raw: Any) -> tuple[dict[str, Any], list[Problem]]:
    """Return the values that are valid on their own, and the problems of the others."""
    try:
        return Configuration.model_validate(raw).model_dump(), []
    except ValidationError as error:
        return _usable(raw), problems_of(error, Place((), Configuration, FieldInfo(), raw))


def _usable(raw: Any) -> dict[str, Any]:
    """Return the values that are valid on their own; others are absent."""
    values = _stripped(raw) if isinstance(raw, Mapping) else {}
    for _ in range(_MOST_ROUNDS):
        try:
            return _stripped(Configuration.model_validate(values).model_dump(warnings=False))
        except ValidationError as error:
            bad = [_bad(values, details["loc"], details["type"] == "missing") for details in error.errors()]
            for group, name in {(id(group), name): (group, name) for group, name in bad}.values():
                _blank(group, name)
    return {}


def _stripped(values: Any) -> Any:
    """Return a copy of nested dicts without unusable values and names that are not text."""
    if not isinstance(values, Mapping):
        return values
    return {name: _stripped(value) for name, value in values.items() if isinstance(name, str) and value is not UNUSABLE}


def _bad(group: dict[Any, Any], path: tuple[Any, ...], missing: bool) -> tuple[dict[Any, Any], Any]:
    """Return the group of keys with a bad or missing value, and its name there."""
    name, *rest = path
    value = group.get(name)
    if rest and isinstance(value, dict) and (missing or rest[0] in value):
        return _bad(value, tuple(rest), missing)
    return group, name


def _blank(group: dict[Any, Any], name: Any) -> None:
    """Mark a value as unusable; where no mark is allowed, empty it; else take it out."""
    value = group.get(name)
    if value is UNUSABLE:
        group[name] = {}
    elif value == {}:
        del group[name]
    else:
        group[name] = UNUSABLE
