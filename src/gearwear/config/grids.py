"""Grids of studies: every combination of some values of some keys is a member."""

from __future__ import annotations

import itertools
import re
from typing import Any, NamedTuple

MOST_COMBINATIONS = 10_000
_LONGEST_NAME = 60


class Combination(NamedTuple):
    """One member of a grid: its name, and the value of every key of the grid, in their order."""

    name: str
    values: dict[str, Any]


def combinations(grid: dict[str, list[Any]]) -> list[Combination]:
    """Return every combination, the last key changing fastest.

    A name is made of the last part of every key and its value; where such names are too long, or not all different,
    the combinations are numbered.

    Parameters
    ----------
    grid : values of every dotted key.
    """
    if not grid:
        return []
    rows = [dict(zip(grid, row, strict=True)) for row in itertools.product(*grid.values())]
    names = ["__".join(f"{key.rsplit('.', 1)[-1]}_{slug(value)}" for key, value in row.items()) for row in rows]
    if len(set(names)) < len(names) or any(len(name) > _LONGEST_NAME for name in names):
        names = [f"member_{number:04d}" for number in range(1, len(rows) + 1)]
    return [Combination(name, row) for name, row in zip(names, rows, strict=True)]


def slug(value: Any) -> str:
    """Return a value as part of a name: small letters, digits and underscores."""
    text = f"{value:g}" if isinstance(value, int | float) and not isinstance(value, bool) else str(value)
    return re.sub(r"[^a-z0-9]+", "_", text.lower().replace("-", "m").replace("+", ""))


def nested(values: dict[str, Any]) -> dict[str, Any]:
    """Return dotted keys with their values as groups of keys."""
    result: dict[str, Any] = {}
    for key, value in values.items():
        *groups, last = key.split(".")
        below = result
        for group in groups:
            below = below.setdefault(group, {})
        below[last] = value
    return result
