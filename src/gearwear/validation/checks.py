"""Checks as data: what is expected, of which source, how near to it a computed number has to be.

They stand in config/validation.yaml; the functions they name are those of the modules beside this one.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import yaml
from pydantic import BaseModel, ConfigDict, ValidationError

from gearwear.errors import BadFile

UNITS = {
    "1": 1.0,
    "mm": 1e-3,
    "µm": 1e-6,
    "fm": 1e-15,
    "deg": math.pi / 180,
    "rad": 1.0,
    "N": 1.0,
    "N/m": 1.0,
    "GPa": 1e9,
    "MPa": 1e6,
    "m/s": 1.0,
    "m2/N": 1.0,
    "N/(µm mm)": 1.0,
    "mm µm/N": 1.0,
}

Numbers = float | list[float]


class Entry(BaseModel):
    """One check as the file has it."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    id: str
    says: str
    source: str
    quantity: str
    given: dict[str, Any] = {}
    along: dict[str, list[float]] = {}
    at: list[str] = []
    unit: str = "1"
    expected: Numbers
    relative: Numbers | None = None
    absolute: Numbers | None = None
    panel: str = ""
    label: str = ""
    note: str = ""
    differs: str = ""


class Check(NamedTuple):
    """One check; expected and tolerance hold a number each for every place, in `unit`, tolerances absolute.

    along : parameter of the quantity that takes the values `at`, or "" if `at` are mere labels
    panel, label : title of the diagram that draws it as a curve, or "", and its name there
    differs : why a number does not agree, or ""
    """

    group: str
    id: str
    says: str
    source: str
    quantity: str
    given: dict[str, Any]
    along: str
    at: tuple[str, ...]
    unit: str
    expected: tuple[float, ...]
    tolerance: tuple[float, ...]
    kind: str
    panel: str
    label: str
    note: str
    differs: str


def read(path: str | Path) -> list[Check]:
    """Return the checks of a file in their order.

    Raises
    ------
    BadFile : an entry is not a check; the message names file, group, entry and key.
    """
    content = yaml.safe_load(Path(path).read_text(encoding="utf-8"))
    checks: list[Check] = []
    for group, entries in content["groups"].items():
        for raw in entries:
            try:
                checks.append(_check(group, Entry.model_validate(raw), content["sources"]))
            except ValidationError as error:
                first = error.errors()[0]
                key = ".".join(str(part) for part in first["loc"])
                raise BadFile(f"{path}: {group}, {raw.get('id', raw)}: {key}: {first['msg']}") from None
            except ValueError as error:
                raise BadFile(f"{path}: {group}, {raw['id']}: {error}") from None
    names = [(check.group, check.id) for check in checks]
    twice = {name for name in names if names.count(name) > 1}
    if twice:
        raise BadFile(f"{path}: given more than once: {', '.join(map('.'.join, sorted(twice)))}; rename one")
    return checks


def _check(group: str, entry: Entry, sources: Mapping[str, str]) -> Check:
    if entry.source not in sources:
        raise BadFile(f"source {entry.source!r} is not listed; it may be {', '.join(sources)}")
    if entry.unit not in UNITS:
        raise BadFile(f"unit {entry.unit!r} is unknown; it may be {', '.join(UNITS)}")
    if entry.absolute is not None and entry.relative is None:
        kind, given = "absolute", entry.absolute
    elif entry.relative is not None and entry.absolute is None:
        kind, given = "relative", entry.relative
    else:
        raise BadFile("needs either relative or absolute, the tolerance")
    if len(entry.along) > 1 or (entry.along and entry.at):
        raise BadFile("along takes one parameter, and no labels beside it")
    along, values = next(iter(entry.along.items()), ("", entry.at))
    count = len(values) or np.size(entry.expected)
    expected = np.broadcast_to(entry.expected, count) if np.size(entry.expected) == 1 else np.array(entry.expected)
    allowed = np.broadcast_to(given, count) if np.size(given) == 1 else np.array(given)
    if not len(expected) == len(allowed) == count:
        raise BadFile(f"{len(expected)} expected numbers and {len(allowed)} tolerances for {count} places")
    scale = np.abs(expected) if kind == "relative" else 1.0
    places = tuple(value if isinstance(value, str) else f"{value:.12g}" for value in values) or ("",) * count
    return Check(
        group=group,
        id=entry.id,
        says=entry.says,
        source=sources[entry.source],
        quantity=entry.quantity,
        given=entry.given,
        along=along,
        at=places,
        unit=entry.unit,
        expected=tuple(map(float, expected)),
        tolerance=tuple(map(float, allowed * scale)),
        kind=kind,
        panel=entry.panel,
        label=entry.label,
        note=entry.note,
        differs=entry.differs,
    )


def titles(path: str | Path) -> dict[str, str]:
    """Return the title of every group."""
    return yaml.safe_load(Path(path).read_text(encoding="utf-8"))["titles"]
