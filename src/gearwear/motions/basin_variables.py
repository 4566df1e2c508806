"""Basins at several points as variables: attractors with their shares and evidence, and a map of the cells."""

from __future__ import annotations

from typing import Any

import numpy as np

from gearwear.motions.basins import UNDECIDED, Basins
from gearwear.motions.motion_variables import columns


def basin_columns(found: list[Basins], shape: tuple[int, int], samples: int, force_parameter: float) -> dict:
    """Return the variables of basins at swept points, each as (dimensions, array).

    Attractors are padded to the largest number at any point: shares and evidence with NaN, whole numbers with 0.
    Their share has the standard error of as many independent draws as there are cells.

    Parameters
    ----------
    found : one a point.
    shape : number of cells in displacement and in velocity; a state varies in velocity first.
    samples, force_parameter : as in record.columns.
    """
    counts = [len(basins.attractors) for basins in found]
    places = (np.repeat(np.arange(len(found)), counts), np.concatenate([np.arange(count) for count in counts]))
    size = len(found), max(counts)

    def padded(values):
        missing = np.nan if values.dtype.kind == "f" else 0
        table = np.full((*size, *values.shape[1:]), missing, dtype=values.dtype)
        table[places] = values
        return table

    motions = [motion for basins in found for motion in basins.attractors]
    table: dict[str, Any] = {}
    for name, (dims, values) in columns(motions, samples, force_parameter).items():
        behind = dims[1:] if isinstance(dims, tuple) else ()
        table[name] = (("point", "attractor", *behind), padded(values))
    shares = padded(np.concatenate([basins.shares for basins in found]))
    cells = shape[0] * shape[1]
    index = np.array([basins.leads_to for basins in found], dtype=np.int32)
    table["share"] = (("point", "attractor"), shares)
    table["share_error"] = (("point", "attractor"), np.sqrt(shares * (1 - shares) / cells))
    table["escaped_share"] = (("point", "attractor"), padded(np.concatenate([basins.escaped for basins in found])))
    table["attractors"] = ("point", np.array(counts, dtype=np.int32))
    table["undecided_share"] = ("point", (index == UNDECIDED).mean(axis=1))
    table["basin"] = (("point", "displacement_cell", "velocity_cell"), index.reshape(len(found), *shape))
    return table
