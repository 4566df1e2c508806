"""Excitations of the mesh in one state of the flanks: stiffness, static transmission error and backlash."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.contact.modulus import hot_modulus
from gearwear.geometry.deviations import lacking
from gearwear.geometry.involute import GEARS, each
from gearwear.geometry.kinematics import mesh_force
from gearwear.mesh.backlash import centre_distance_change, half_backlash, opened
from gearwear.mesh.sharing import transmission
from gearwear.mesh.stiffness import Flanks, pair_stiffness
from gearwear.mesh.stiffness import mesh_stiffness as over_the_mesh


def mesh_excitation(
    cfg: dict[str, Any], geometry: xr.Dataset, deformation: xr.Dataset, wear: xr.Dataset
) -> dict[str, xr.Dataset]:
    """Return mesh stiffness, static transmission error and backlash of the worn, hot pair, by these names.

    Parameters
    ----------
    cfg : the slice `mesh_excitation`.
    """
    stiffness = mesh_stiffness(cfg, geometry, deformation, wear)
    error = transmission_error(cfg, geometry, deformation, wear, stiffness)
    clearance = backlash(cfg, geometry, deformation, wear, error)
    return {"mesh_stiffness": stiffness, "transmission_error": error, "backlash": clearance}


def mesh_stiffness(cfg: dict[str, Any], geometry: xr.Dataset, deformation: xr.Dataset, wear: xr.Dataset) -> xr.Dataset:
    """Return the stiffness of the mesh and of the pair, with the compliances of its parts.

    Parameters
    ----------
    cfg : sections `mesh_stiffness`, `material`, `elasticity`, `operation` and `case`.
    """
    modulus = hot_modulus(cfg["material"], cfg["elasticity"], cfg["case"]["bulk_temperature"])
    poisson = each({name: cfg["material"][name]["poisson_ratio"] for name in GEARS})
    flanks = Flanks(wear["wear_depth"].values, deformation["thermal_growth"].values)
    force = mesh_force(geometry, cfg["operation"]["pinion_torque"])
    pairs = pair_stiffness(geometry, modulus, poisson, flanks, cfg["mesh_stiffness"], force)
    mesh = over_the_mesh(pairs, geometry["entering"].values, geometry["leaving"].values)
    values: dict[str, Any] = {
        "mesh_stiffness": ("mesh_phase", mesh),
        "pair_stiffness": ("path", pairs.pair_stiffness),
        "pair_coupling": ("path", pairs.coupling),
        "hertz_compliance": ("path", pairs.hertz),
        "youngs_modulus": ("gear", modulus),
    }
    for name in ("bending", "shear", "axial", "foundation"):
        values[f"{name}_compliance"] = (("gear", "path"), getattr(pairs, name))
    return xr.Dataset(values, {name: geometry[name] for name in ("path", "mesh_phase", "gear")})


def transmission_error(
    cfg: dict[str, Any], geometry: xr.Dataset, deformation: xr.Dataset, wear: xr.Dataset, mesh_stiffness: xr.Dataset
) -> xr.Dataset:
    """Return the transmission error, the load shares and the errors of the flanks behind them.

    Parameters
    ----------
    cfg : sections `transmission_error` and `operation`.
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
    cfg : sections `backlash`, `heat` and `case`.
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
