"""A dataset as flat tables for programs that read no netCDF, and the dictionary of their columns."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import pandas as pd
import xarray as xr

from gearwear.io.variables import Variable, variable_of

# Dimensions of the rows of the tables that hand a case over, slowest first.
TABLES = {
    "mesh": ("wear_cycle", "mesh_phase"),
    "wear": ("wear_cycle", "path"),
    "states": ("wear_cycle",),
    "gears": ("gear",),
}


class Column(NamedTuple):
    """Heading `name [unit]`, or the name alone of a plain number, its entry in the table of fields, and its values."""

    heading: str
    field: Variable
    values: xr.DataArray


def columns(dataset: xr.Dataset, table: str) -> list[Column]:
    """Return the columns of a table: its dimensions, coordinates along one of them, and what depends on all.

    A quantity of both gears gives one column a gear, but in the table of gears, where they are the rows. There stands
    what belongs to the pair as well.
    """
    dims = TABLES[table]
    others = [name for name in (*dataset.coords, *dataset.data_vars) if name not in dims]
    names = [*dims, *(name for name in others if _belongs(dataset[name], dims))]
    return [column for name in map(str, names) for column in _columns(dataset[name], name, dims)]


def rows(found: list[Column], table: str) -> Iterator[tuple[Any, ...]]:
    """Return the rows of the table with these columns."""
    data = xr.Dataset({str(place): column.values.reset_coords(drop=True) for place, column in enumerate(found)})
    frame: pd.DataFrame = data.to_dataframe(dim_order=list(TABLES[table]))
    return frame.itertuples(index=False, name=None)


def dictionary(dataset: xr.Dataset) -> list[tuple[str, str, str, str]]:
    """Return file, column, unit and meaning of every column of every table."""
    return [
        (f"{table}.csv", column.heading, column.field.units or "-", column.field.long_name)
        for table in TABLES
        for column in columns(dataset, table)
    ]


def _belongs(values: xr.DataArray, dims: tuple[str, ...]) -> bool:
    if dims == ("gear",):
        return values.dims in (dims, ())
    own = [dim for dim in values.dims if dim != "gear"]
    return set(own) == set(dims) or (len(own) == 1 and own[0] in dims and values.name in values.coords)


def _columns(values: xr.DataArray, name: str, dims: tuple[str, ...]) -> Iterator[Column]:
    field = variable_of(name, tuple(map(str, values.dims)))
    unit = f" [{field.units}]" if field.units not in ("", "1") else ""
    if "gear" not in values.dims or "gear" in dims:
        yield Column(f"{name}{unit}", field, values)
        return
    for gear in values["gear"].values:
        yield Column(f"{name}_{gear}{unit}", field, values.sel(gear=gear, drop=True))
