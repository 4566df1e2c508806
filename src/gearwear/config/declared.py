"""Units and meanings of the keys of the configuration, by their dotted names."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from gearwear.config.key_types import keys, unit_of
from gearwear.config.study_sections import Configuration


class Declared(NamedTuple):
    """What a key is declared as: unit, empty if it is no number, and meaning."""

    unit: str
    meaning: str


def declared_at(key: str) -> Declared | None:
    """Return the declaration of a key, None if there is no such key; free names stand for any name."""
    path = tuple(key.split("."))
    for pattern, field in _table():
        if len(pattern) == len(path) and all(map(_matches, pattern, path)):
            return Declared(unit_of(field) or "", field.description or "")
    return None


@cache
def _table():
    return tuple(keys(Configuration))


def _matches(part: str, name: str) -> bool:
    return part == name or part.startswith("<")
