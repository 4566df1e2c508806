"""Dimensions of the gear pair, the path of contact and the grids of the mesh."""

from __future__ import annotations

from typing import Any

import xarray as xr

from gearwear.geometry.contact_path import contact_path
from gearwear.geometry.involute import GEARS, disc_mass, equivalent_mass, gear_pair
from gearwear.geometry.record import dataset
from gearwear.mesh.foundation import fit_warnings


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
    bodies = {"mass": ("gear", disc_mass(pair, density)), "moment_of_inertia": ("gear", moments)}
    return dataset(pair, mesh).assign(bodies | {"equivalent_mass": mass})


def beyond_fits(pair: xr.Dataset) -> list[str]:
    """Return a sentence for every fit of the gear bodies that the pair, as `geometry` gives it, lies outside of."""
    found = []
    for i, name in enumerate(GEARS):
        root, bore, angle = (float(pair[key][i]) for key in ("root_radius", "bore_radius", "rack_root_angle"))
        found += fit_warnings(root / bore, angle, name)
    return found
