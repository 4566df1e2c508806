"""Basins at several points as variables: attractors with their shares and evidence, and a map of the cells."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.motions.basins import UNDECIDED, Basins, basins
from gearwear.motions.motion_variables import columns
from gearwear.motions.settling import Settling
from gearwear.oscillator.excitation import SweptOscillator


def basins_along(
    swept: SweptOscillator, values: np.ndarray, displacement: np.ndarray, velocity: np.ndarray, settling: Settling
) -> xr.Dataset:
    """Return the basins of attraction at values of a swept quantity, on a grid of initial states.

    Parameters
    ----------
    swept : oscillator by the swept quantity.
    values : (points,) of the swept quantity.
    displacement, velocity : (displacement_cell,) and (velocity_cell,), initial states at mesh phase 0.

    Returns
    -------
    xarray.Dataset
        The variables of basin_columns with the values and the initial states as coordinates.
    """
    states = np.stack(np.meshgrid(displacement, velocity, indexing="ij"), axis=-1).reshape(-1, 2)
    found = [basins(swept.at(value), states, settling, swept.dynamics["tolerance"]) for value in values]
    shape = len(displacement), len(velocity)
    table = basin_columns(found, shape, settling.sampled_periods, swept.source.force_parameter)
    return xr.Dataset(
        table,
        {
            "initial_displacement": ("displacement_cell", displacement),
            "initial_velocity": ("velocity_cell", velocity),
            swept.quantity: ("point", np.asarray(values, dtype=float)),
        },
    )


def basin_columns(found: list[Basins], shape: tuple[int, int], samples: int, force_parameter: float) -> dict[str, Any]:
    """Return the variables of basins at swept points, each as (dimensions, array).

    Attractors are padded to the largest number at any point: shares and evidence with NaN, whole numbers with 0.
    Their share has the standard error of as many independent draws as there are cells.

    Parameters
    ----------
    found : one a point.
    shape : number of cells in displacement and in velocity; a state varies in velocity first.
    samples, force_parameter : as in motion_variables.columns.
    """
    counts = [len(basins.attractors) for basins in found]
    places = (np.repeat(np.arange(len(found)), counts), np.concatenate([np.arange(count) for count in counts]))
    size = len(found), max(counts)

    def padded(values: Any) -> Any:
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
    index = np.array([basins.destination for basins in found], dtype=np.int32)
    table["share"] = (("point", "attractor"), shares)
    table["share_error"] = (("point", "attractor"), np.sqrt(shares * (1 - shares) / cells))
    table["escaped_share"] = (("point", "attractor"), padded(np.concatenate([basins.escaped for basins in found])))
    table["attractors"] = ("point", np.array(counts, dtype=np.int32))
    table["undecided_share"] = ("point", (index == UNDECIDED).mean(axis=1))
    table["basin"] = (("point", "displacement_cell", "velocity_cell"), index.reshape(len(found), *shape))
    return table
