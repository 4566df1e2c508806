"""Wear of both flanks, one wear cycle after another."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.contact.hertz import contact_modulus
from gearwear.contact.modulus import hot_modulus
from gearwear.contact.oil import dynamic_viscosity
from gearwear.errors import Infeasible
from gearwear.geometry.involute import GEARS, each
from gearwear.geometry.kinematics import curvature, mesh_force, surface_speed
from gearwear.mesh.sharing import share, springs_of
from gearwear.wear.archard import overshoot, wear_per_revolution

COARSE, _UNSTABLE = 0.45, 0.9  # depth of one block over elastic deflection, see gearwear.wear.archard.overshoot


def unworn(geometry: xr.Dataset) -> xr.Dataset:
    """Return the flanks without wear."""
    none = np.zeros((geometry.sizes["gear"], geometry.sizes["path"]))
    values = {
        "wear_depth": (("gear", "path"), none),
        "wear_per_revolution": (("gear", "path"), none),
        "running_cycles": 0.0,
    }
    return xr.Dataset(values, {"path": geometry["path"], "gear": geometry["gear"]})


def wear(
    cfg: dict[str, Any],
    geometry: xr.Dataset,
    wear: xr.Dataset,
    mesh_stiffness: xr.Dataset,
    transmission_error: xr.Dataset,
    response: xr.Dataset,
) -> xr.Dataset:
    """Return the flanks after one more block, worn under the mesh force of the state before it.

    Parameters
    ----------
    cfg : the slice `wear`.

    Raises
    ------
    Infeasible : the block is too long for the steps to be stable.
    """
    settings, bulk = cfg["wear"], cfg["case"]["bulk_temperature"]
    cycles = settings["cycles_per_update"]
    springs = springs_of(geometry, mesh_stiffness)
    removed = transmission_error["sharing_error"].values
    force = response["mesh_force_path"].values
    if settings["force"] == "quasi_static":
        force = np.full((1, len(removed)), mesh_force(geometry, cfg["operation"]["pinion_torque"]))
    load = np.stack([np.maximum(one, 0) * share(springs, removed, one).load_share for one in force])
    poisson = each({name: cfg["material"][name]["poisson_ratio"] for name in GEARS})
    increment = wear_per_revolution(
        load,
        surface_speed(geometry, cfg["operation"]["pinion_speed"]),
        curvature(geometry)[1],
        float(geometry["face_width"]),
        contact_modulus(hot_modulus(cfg["material"], cfg["elasticity"], bulk), poisson),
        dynamic_viscosity(bulk, cfg["lubricant"]),
        cfg["lubricant"],
        settings["law"],
        settings["coefficient"],
        settings["pressure"],
    ).mean(axis=1)
    if settings["gear_cycles"] == "tooth_ratio":
        increment[1] *= float(geometry["teeth"][0] / geometry["teeth"][1])
    ratio = share_of_deflection(increment, cycles, transmission_error)
    if ratio > _UNSTABLE:
        raise Infeasible(
            f"wear.cycles_per_update: {cycles:g} revolutions take off {ratio:.2f} of the elastic "
            f"deflection at one place, the steps overshoot above {_UNSTABLE}; give at most "
            f"{cycles * COARSE / ratio:.2g} (and running_cycles as whole multiples of it)"
        )
    along = ("gear", "path")
    values = {
        "wear_depth": (along, wear["wear_depth"].values + cycles * increment),
        "wear_per_revolution": (along, increment),
        "running_cycles": float(wear["running_cycles"]) + cycles,
    }
    return xr.Dataset(values, {"path": geometry["path"], "gear": geometry["gear"]})


def share_of_deflection(increment: np.ndarray, cycles: float, transmission_error: xr.Dataset) -> float:
    """Return the greatest share of the elastic deflection that one block takes off.

    Parameters
    ----------
    increment : wear depth per revolution of the pinion (m), shape (2, n).
    cycles : revolutions of the pinion in a block.
    """
    return overshoot(cycles * increment.sum(axis=0), transmission_error["elastic_deflection"].values)
