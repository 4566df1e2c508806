"""Every value of a configuration with its key, unit and meaning."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

from gearwear.plumbing.key_types import unit_of
from gearwear.plumbing.keytable import leaves

COLUMNS = ("key", "value", "unit", "meaning")


def rows(config: dict[str, Any]) -> Iterator[tuple[str, str, str, str]]:
    """Yield key, value, unit ("-" for what is no number) and meaning, in the order of the declarations."""
    for path, field in leaves():
        for names, value in _values(config, path):
            yield ".".join(names), _worded(value), unit_of(field) or "-", field.description


def _values(values: Any, path: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], Any]]:
    """Yield the names and the value of every entry at `path`; a placeholder stands for all names there."""
    if not path:
        yield (), values
        return
    for name in values if path[0].startswith("<") else path[:1]:
        for rest, value in _values(values[name], path[1:]):
            yield (name, *rest), value


def _worded(value: Any) -> str:
    return value if isinstance(value, str) else json.dumps(value)
