"""Dimensions of the gear pair, the path of contact and the grids of the mesh."""

from __future__ import annotations

from typing import Any

import xarray as xr

from gearwear.geometry.contact_path import contact_path
from gearwear.geometry.deviations import spacing, tip_relief
from gearwear.geometry.involute import GEARS, disc_mass, equivalent_mass, gear_pair
from gearwear.geometry.record import dataset


def geometry(cfg: dict[str, Any]) -> xr.Dataset:
    """Return the pair and its grids.

    Parameters
    ----------
    cfg : the slice `geometry`.
    """
    settings = dict(cfg["gear_pair"])
    inertia = settings.pop("inertia")
    density = {name: cfg["material"][name]["density"] for name in GEARS}
    pair = gear_pair(**settings)
    mesh = contact_path(pair, cfg["grid"]["mesh_cells"])
    moments, mass = equivalent_mass(pair, density, inertia)
    made = dict(cfg["micro_geometry"])
    relief = tip_relief(mesh, made.pop("tip_relief"))
    values = {
        "mass": ("gear", disc_mass(pair, density)),
        "moment_of_inertia": ("gear", moments),
        "equivalent_mass": mass,
        "tip_relief": (("gear", "path"), relief),
        "spacing": ("path", spacing(mesh, pair.base_pitch, **made)),
    }
    return dataset(pair, mesh).assign(values)
