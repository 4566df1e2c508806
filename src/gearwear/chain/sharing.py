"""Load sharing and loaded static transmission error of the worn, hot pair."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.geometry.deviations import lacking
from gearwear.geometry.kinematics import mesh_force
from gearwear.mesh.sharing import transmission


def transmission_error(
    cfg: dict[str, Any], geometry: xr.Dataset, deformation: xr.Dataset, wear: xr.Dataset, mesh_stiffness: xr.Dataset
) -> xr.Dataset:
    """Return the transmission error, the load shares and the errors of the flanks behind them.

    Parameters
    ----------
    cfg : the slice `transmission_error`.
    """
    mesh = transmission(
        geometry,
        mesh_stiffness,
        wear["wear_depth"].values,
        deformation["thermal_growth"].values,
        mesh_force(geometry, cfg["operation"]["pinion_torque"]),
        **cfg["transmission_error"],
        made=lacking(geometry),
    )
    values = {
        "transmission_error": ("mesh_phase", mesh.transmission_error),
        "effective_stiffness": ("mesh_phase", mesh.effective_stiffness),
        "load_sharing_factor": (("mesh_phase", "pair"), mesh.load_sharing_factor),
        "load_share_path": ("path", mesh.load_share_path),
        "elastic_deflection": ("path", mesh.elastic_deflection),
        "profile_error": ("path", mesh.profile_error),
        "sharing_error": ("path", mesh.sharing_error),
    }
    coords = {"path": geometry["path"], "mesh_phase": geometry["mesh_phase"], "pair": np.array(["entering", "leaving"])}
    return xr.Dataset(values, coords)
