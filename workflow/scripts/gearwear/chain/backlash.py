"""Half backlash of the worn, hot, loaded pair."""

from __future__ import annotations

from typing import Any

import xarray as xr

from gearwear.mesh.backlash import half_backlash


def backlash(
    cfg: dict[str, Any],
    geometry: xr.Dataset,
    deformation: xr.Dataset,
    wear: xr.Dataset,
    transmission_error: xr.Dataset,
) -> xr.Dataset:
    """Return the half clearance along the path of a pair and over the mesh phase.

    Parameters
    ----------
    cfg : the slice `backlash`.
    """
    settings = cfg["backlash"]
    clearance = half_backlash(
        settings["half_backlash"],
        transmission_error["elastic_deflection"].values,
        wear["wear_depth"].values + geometry["tip_relief"].values,
        deformation["thermal_growth"].values,
        float(geometry["working_pressure_angle"]),
        settings["projection"],
    )
    values = {
        "backlash": ("mesh_phase", clearance[geometry["entering"].values]),
        "backlash_path": ("path", clearance),
        "initial_half_backlash": settings["half_backlash"],
    }
    return xr.Dataset(values, {name: geometry[name] for name in ("path", "mesh_phase")})
