"""Half backlash of the worn, hot, loaded pair."""

from __future__ import annotations

from typing import Any

import xarray as xr

from gearwear.mesh.backlash import centre_distance_change, half_backlash, opened


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
    settings, centre_distance = cfg["backlash"], float(geometry["centre_distance"])
    rise = cfg["case"]["bulk_temperature"] - cfg["heat"]["initial_temperature"]
    change = centre_distance_change(centre_distance, rise, settings["centre_distance_change"], settings["housing"])
    clearance = half_backlash(
        settings["half_backlash"],
        transmission_error["elastic_deflection"].values,
        wear["wear_depth"].values + geometry["tip_relief"].values,
        deformation["thermal_growth"].values,
        float(geometry["working_pressure_angle"]),
        settings["projection"],
        opened(change, centre_distance, geometry["base_radius"].values),
    )
    values = {
        "backlash": ("mesh_phase", clearance[geometry["entering"].values]),
        "backlash_path": ("path", clearance),
        "initial_half_backlash": settings["half_backlash"],
        "centre_distance_change": change,
    }
    return xr.Dataset(values, {name: geometry[name] for name in ("path", "mesh_phase")})
