"""Gear pairs given by a few numbers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import xarray as xr

from gearwear.geometry.contact_path import contact_path
from gearwear.geometry.involute import GEARS, gear_pair
from gearwear.geometry.record import dataset


def geometry_of(
    teeth: Sequence[float],
    module: float,
    face_width: float,
    bore_radius: Any,
    profile_shift: Any = (0.0, 0.0),
    addendum: Any = (1.0, 1.0),
    centre_distance: float | None = None,
    mesh_cells: int = 240,
) -> xr.Dataset:
    """Return the dataset of a pair cut by a 20 degree rack with a clearance of 0.25 modules; lengths in m.

    Of teeth, bore radius, profile shift and addendum coefficient there are two, of pinion and gear.
    """

    def both(values: Sequence[float]) -> dict[str, Any]:
        return dict(zip(GEARS, values, strict=True))

    pair = gear_pair(
        both(teeth),
        module,
        face_width,
        20.0,
        both(addendum),
        0.25,
        both(profile_shift),
        centre_distance,
        both(bore_radius),
    )
    return dataset(pair, contact_path(pair, mesh_cells))


def standard_pair(teeth: Sequence[float], root_over_bore: float, mesh_cells: int = 240) -> xr.Dataset:
    """Return an unshifted pair, 3 mm module, 20 mm wide, whose bores are root radius over `root_over_bore`."""
    bores = [(z - 2.5) * 1.5e-3 / root_over_bore for z in teeth]
    return geometry_of(teeth, 3e-3, 20e-3, bores, mesh_cells=mesh_cells)
