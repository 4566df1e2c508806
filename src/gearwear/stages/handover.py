"""Stages that hand a case over to other programs."""

from __future__ import annotations

from typing import Any

import xarray as xr

from gearwear.chain.handover import handover
from gearwear.io import flat
from gearwear.io.store import together
from gearwear.io.tables import Table


def handover_dataset(
    cfg: dict[str, Any],
    geometry: xr.Dataset,
    wear: list[xr.Dataset],
    mesh_stiffness: list[xr.Dataset],
    transmission_error: list[xr.Dataset],
    backlash: list[xr.Dataset],
    response: list[xr.Dataset],
) -> xr.Dataset:
    """Return the gears, and the mesh and the worn flanks at every wear cycle."""
    cycles = zip(wear, mesh_stiffness, transmission_error, backlash, response, strict=True)
    return handover(cfg, geometry, [together(cycle) for cycle in cycles])


def handover_tables(dataset: xr.Dataset) -> dict[str, Table]:
    """Return the same as tables, with a `dictionary` of their columns."""
    found = {}
    for name in flat.TABLES:
        columns = flat.columns(dataset, name)
        found[name] = Table(tuple(column.heading for column in columns), list(flat.rows(columns, name)))
    return found | {"dictionary": Table(("file", "column", "unit", "meaning"), flat.dictionary(dataset))}
