"""What the program finds for checks, and the verdict on every number."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from gearwear.errors import BadFile
from gearwear.validation.checks import UNITS, Check

AGREES, DIFFERS = "agrees", "differs"
COLUMNS = (
    "group",
    "check",
    "says",
    "at",
    "unit",
    "source",
    "expected",
    "found",
    "tolerance",
    "kind",
    "verdict",
    "note",
)


class Outcome(NamedTuple):
    """A check and the numbers found, in its unit."""

    check: Check
    found: tuple[float, ...]

    @property
    def agreements(self) -> tuple[bool, ...]:
        """Whether each number is as near to the expected one as its source allows."""
        triples = zip(self.found, self.check.expected, self.check.tolerance, strict=True)
        return tuple(abs(found - expected) <= tolerance for found, expected, tolerance in triples)

    @property
    def verdict(self) -> str:
        """`agrees` if every number does."""
        return AGREES if all(self.agreements) else DIFFERS


def compute(check: Check, quantities: Mapping[str, Callable[..., Any]]) -> Outcome:
    """Return what the program finds.

    Raises
    ------
    BadFile : the group has no such quantity, or it gives another count of numbers than expected.
    """
    if check.quantity not in quantities:
        raise BadFile(
            f"{check.group}, {check.id}: quantity {check.quantity!r} is unknown; it may be {', '.join(quantities)}"
        )
    function = quantities[check.quantity]
    if check.along:
        found = np.array([function(**check.given, **{check.along: float(value)}) for value in check.at])
    else:
        found = np.atleast_1d(function(**check.given))
    if found.shape != (len(check.expected),):
        raise BadFile(f"{check.group}, {check.id}: {found.shape} numbers found, {len(check.expected)} expected")
    return Outcome(check, tuple(map(float, found / UNITS[check.unit])))


def rows(outcomes: Iterable[Outcome]) -> list[dict[str, str]]:
    """Return one row of texts a number, under COLUMNS."""
    table = []
    for outcome in outcomes:
        check = outcome.check
        fixed = {"group": check.group, "check": check.id, "says": check.says, "unit": check.unit}
        fixed |= {
            "source": check.source,
            "kind": check.kind,
            "note": " ".join(filter(None, (check.note, check.differs))),
        }
        numbers = zip(check.at, check.expected, outcome.found, check.tolerance, outcome.agreements, strict=True)
        for at, expected, found, tolerance, agrees in numbers:
            values = {
                "at": at,
                "expected": f"{expected:.15g}",
                "found": f"{found:.15g}",
                "tolerance": f"{tolerance:.6g}",
            }
            verdict = {"verdict": AGREES if agrees else DIFFERS}
            table.append({name: (fixed | values | verdict)[name] for name in COLUMNS})
    return table


def read_rows(path: str | Path) -> list[dict[str, str]]:
    """Return the rows of a file that io.tables wrote."""
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def merged(checks: Iterable[Check], table: Iterable[Mapping[str, str]]) -> list[Outcome]:
    """Return the outcomes of the checks that have rows, in the order of the checks."""
    found: dict[tuple[str, str], list[float]] = {}
    for row in table:
        found.setdefault((row["group"], row["check"]), []).append(float(row["found"]))
    known = [check for check in checks if (check.group, check.id) in found]
    return [Outcome(check, tuple(found[check.group, check.id])) for check in known]


def summary(found: list[Outcome]) -> str:
    """Return the count of the verdicts, such as "212 of 221 checks agree, 480 of 496 numbers"."""
    numbers = [agrees for outcome in found for agrees in outcome.agreements]
    checks = [outcome.verdict == AGREES for outcome in found]
    return f"{sum(checks)} of {len(checks)} checks agree, {sum(numbers)} of {len(numbers)} numbers"
