"""Stiffness of a tooth pair along its path and of the mesh over its phase, hot and worn."""

from __future__ import annotations

from typing import Any

import xarray as xr

from gearwear.contact.modulus import hot_modulus
from gearwear.geometry.involute import GEARS, each
from gearwear.geometry.kinematics import mesh_force
from gearwear.mesh.stiffness import Flanks, pair_stiffness
from gearwear.mesh.stiffness import mesh_stiffness as over_the_mesh


def mesh_stiffness(cfg: dict[str, Any], geometry: xr.Dataset, deformation: xr.Dataset, wear: xr.Dataset) -> xr.Dataset:
    """Return the stiffness of the mesh and of the pair, with the compliances of its parts.

    Parameters
    ----------
    cfg : the slice `mesh_stiffness`.
    """
    modulus = hot_modulus(cfg["material"], cfg["elasticity"], cfg["case"]["bulk_temperature"])
    poisson = each({name: cfg["material"][name]["poisson_ratio"] for name in GEARS})
    flanks = Flanks(wear["wear_depth"].values, deformation["thermal_growth"].values)
    force = mesh_force(geometry, cfg["operation"]["pinion_torque"]) if "operation" in cfg else 0.0
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
