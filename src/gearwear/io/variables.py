"""The table of every variable in the result files, `variables.csv`: units, name, dimensions, flags."""

from __future__ import annotations

import csv
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import NamedTuple

from gearwear.errors import BadFile

TABLE = Path(__file__).with_suffix(".csv")
_LINED_UP = ("wear_cycle", "member")  # axes along which whole states or outcomes are lined up
_SWEPT = "swept "


class Variable(NamedTuple):
    """Entry of the table: units ("" for flags and text), name, allowed dimensions, CF flags, may hold nan."""

    units: str
    long_name: str
    dims: tuple[tuple[str, ...], ...]
    flags: dict[str, int] | None
    may_be_missing: bool


@cache
def variables() -> dict[str, Variable]:
    """Return the table; the name of a swept coordinate that is also a quantity of the mesh begins with `swept `."""
    with open(TABLE, encoding="utf-8", newline="") as file:
        return {
            row["variable"]: Variable(
                row["units"],
                row["long_name"],
                tuple(tuple(dims.split()) for dims in row["dimensions"].split("|")),
                _flags(row["flags"]),
                bool(row["may_be_missing"]),
            )
            for row in csv.DictReader(file)
        }


def variable_of(name: str, dims: tuple[str, ...]) -> Variable:
    """Return the entry of a variable with these dimensions.

    Wear cycles, members of a study and the keys of its grid, which are axes by their dotted names, may come before the
    dimensions of the entry.

    Raises
    ------
    BadFile : no such variable, or other dimensions than the table allows.
    """
    own = dims
    while True:
        for variable in (variables().get(_SWEPT + name), variables().get(name)):
            if variable is not None and own in variable.dims:
                return variable
        if not own or not (own[0] in _LINED_UP or "." in own[0]):
            break
        own = own[1:]
    if name not in variables():
        raise BadFile(f"{name}: no such variable in the table of variables")
    raise BadFile(f"{name}: dimensions {dims}, expected one of {variables()[name].dims}")


def is_key(name: str) -> bool:
    """Return whether a variable is a key of the configuration as an axis; units and name are its own attributes."""
    return "." in name


def _flags(source: str) -> dict[str, int] | None:
    """Return the flags of `module:NAME` in gearwear.codes; by name, so that no code digest holds them all."""
    module, _, name = source.partition(":")
    return getattr(import_module(f"gearwear.codes.{module}"), name) if source else None
