"""Every value of a configuration with its key, unit, origin and meaning."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from typing import Any

from gearwear.config.key_table import leaves
from gearwear.config.key_types import unit_of
from gearwear.config.origins import Layer, origin

COLUMNS = ("key", "value", "unit", "origin", "meaning")


def rows(config: dict[str, Any], layers: Sequence[Layer]) -> Iterator[tuple[str, ...]]:
    """Yield key, value, unit ("-" for what is no number), origin and meaning, in the order of the declarations.

    Parameters
    ----------
    config : the checked configuration; layers : the files and the command line it was merged from.
    """
    for path, field in leaves():
        for names, value in _values(config, path):
            unit = unit_of(field) or "-"
            yield ".".join(names), _worded(value), unit, origin(names, layers), field.description or ""


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
