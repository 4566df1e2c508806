"""Tooth contact temperature along the path of contact of the cold-shaped pair under the static load."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.contact.flash import contact_heat
from gearwear.contact.modulus import hot_modulus
from gearwear.contact.oil import dynamic_viscosity
from gearwear.geometry.deviations import lacking
from gearwear.geometry.involute import GEARS, each
from gearwear.geometry.kinematics import curvature, mesh_force, surface_speed
from gearwear.heat.balance import heat_flows
from gearwear.mesh.sharing import Springs, share
from gearwear.mesh.stiffness import Flanks, pair_stiffness

_RAISED = {"friction": (1.1, 1, 1), "speed": (1, 1.1, 1), "load": (1, 1, 1.1)}


def temperature(cfg: dict[str, Any], geometry: xr.Dataset) -> xr.Dataset:
    """Return contact and flash temperature, friction and film, what the largest flash temperature depends on, and the
    heat flows at the bulk temperature.

    Parameters
    ----------
    cfg : the slice `temperature`.
    """
    material, bulk = cfg["material"], cfg["case"]["bulk_temperature"]
    modulus = hot_modulus(material, cfg["elasticity"], bulk)
    poisson = each({name: material[name]["poisson_ratio"] for name in GEARS})
    effusivity = each(
        {name: np.sqrt(m["thermal_conductivity"] * m["density"] * m["specific_heat"]) for name, m in material.items()}
    )
    pristine = Flanks(*np.zeros((2, 2, geometry.sizes["path"])))

    def heat(
        friction_factor: float = 1.0, speed_factor: float = 1.0, load_factor: float = 1.0
    ) -> tuple[np.ndarray, Any]:
        force = load_factor * mesh_force(geometry, cfg["operation"]["pinion_torque"])
        pairs = pair_stiffness(geometry, modulus, poisson, pristine, cfg["mesh_stiffness"], force)
        springs = Springs(pairs.pair_stiffness, pairs.coupling, geometry["partner"].values)
        shared = share(springs, lacking(geometry), force)
        speed = surface_speed(geometry, speed_factor * cfg["operation"]["pinion_speed"])
        return speed, contact_heat(
            shared.load_share * force / float(geometry["face_width"]),
            speed,
            curvature(geometry)[1],
            modulus,
            poisson,
            effusivity,
            dynamic_viscosity(bulk, cfg["lubricant"]),
            cfg["lubricant"],
            cfg["friction"],
            cfg["heat"]["flash_coefficient"] * cfg["case"]["flash"],
            friction_factor,
        )

    speed, contact = heat()
    peak = contact.flash_temperature.max()
    ratios = [heat(*factors)[1].flash_temperature.max() / peak if peak > 0 else 1.0 for factors in _RAISED.values()]
    flows = heat_flows(geometry, bulk, cfg["operation"], cfg["lubricant"], cfg["heat_balance"])
    values: dict[str, Any] = {name: ("path", value) for name, value in contact._asdict().items()} | flows._asdict()
    values["contact_temperature"] = ("path", bulk + contact.flash_temperature)
    values["surface_speed"] = (("gear", "path"), speed)
    values["flash_sensitivity"] = ("influence", np.array(ratios))
    return xr.Dataset(values, {"path": geometry["path"], "gear": geometry["gear"], "influence": list(_RAISED)})
