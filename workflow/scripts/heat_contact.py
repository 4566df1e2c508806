"""Tooth contact temperature along the path of contact of the cold-shaped pair under the static load."""

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from gearwear.geometry.involute import GEARS, each
from gearwear.geometry.kinematics import curvature, mesh_force, surface_speed
from gearwear.heat.flash import contact_heat
from gearwear.heat.modulus import hot_modulus
from gearwear.mesh.sharing import Springs, share
from gearwear.mesh.stiffness import Flanks, pair_stiffness
from gearwear.plumbing import stage, store
from gearwear.wear.film import dynamic_viscosity

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

RAISED = {"friction": (1.1, 1, 1), "speed": (1, 1.1, 1), "load": (1, 1, 1.1)}


def main(job):
    cfg, geometry = job.params.cfg, store.load(job.input.geometry)
    material, bulk = cfg["material"], cfg["case"]["bulk_temperature"]
    modulus = hot_modulus(material, cfg["elasticity"], bulk)
    poisson = each({name: material[name]["poisson_ratio"] for name in GEARS})
    effusivity = each(
        {name: np.sqrt(m["thermal_conductivity"] * m["density"] * m["specific_heat"]) for name, m in material.items()}
    )
    pristine = Flanks(*np.zeros((2, 2, geometry.sizes["path"])))

    def heat(friction_factor=1.0, speed_factor=1.0, load_factor=1.0):
        force = load_factor * mesh_force(geometry, cfg["operation"]["pinion_torque"])
        pairs = pair_stiffness(geometry, modulus, poisson, pristine, cfg["mesh_stiffness"], force)
        springs = Springs(pairs.pair_stiffness, pairs.coupling, geometry["partner"].values)
        shared = share(springs, np.zeros(geometry.sizes["path"]), force)
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
    ratios = [heat(*factors)[1].flash_temperature.max() / peak if peak > 0 else 1.0 for factors in RAISED.values()]
    stage.log.info("bulk temperature %g degC, flash temperature up to %.1f K", bulk, peak)
    values = {name: ("path", value) for name, value in contact._asdict().items()}
    values["contact_temperature"] = ("path", bulk + contact.flash_temperature)
    values["surface_speed"] = (("gear", "path"), speed)
    values["flash_sensitivity"] = ("influence", np.array(ratios))
    coords = {"path": geometry["path"], "gear": geometry["gear"], "influence": list(RAISED)}
    store.save(xr.Dataset(values, coords), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
