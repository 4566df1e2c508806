"""Wear of both flanks by one block of running cycles under the mesh force of the cycle before."""

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from gearwear.geometry.involute import GEARS, each
from gearwear.geometry.kinematics import curvature, mesh_force, surface_speed
from gearwear.heat.modulus import hot_modulus
from gearwear.mesh.sharing import share, springs_of
from gearwear.plumbing import stage, store
from gearwear.wear.archard import overshoot, wear_per_revolution
from gearwear.wear.film import contact_modulus, dynamic_viscosity

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

COARSE, UNSTABLE = 0.45, 0.9  # depth of one block over elastic deflection, see gearwear.wear.archard.overshoot


def main(job):
    cfg, geometry, worn = job.params.cfg, store.load(job.input.geometry), store.load(job.input.wear)
    wear, bulk = cfg["wear"], cfg["case"]["bulk_temperature"]
    springs = springs_of(geometry, store.load(job.input.mesh_stiffness))
    transmission = store.load(job.input.transmission_error)
    removed = transmission["sharing_error"].values
    force = store.load(job.input.response)["mesh_force_path"].values
    if wear["force"] == "quasi_static":
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
        wear["law"],
        wear["coefficient"],
        wear["pressure"],
    ).mean(axis=1)
    if wear["gear_cycles"] == "tooth_ratio":
        increment[1] *= float(geometry["teeth"][0] / geometry["teeth"][1])
    taken = wear["cycles_per_update"] * increment
    ratio = overshoot(taken.sum(axis=0), transmission["elastic_deflection"].values)
    if ratio > UNSTABLE:
        raise ValueError(
            f"wear.cycles_per_update: {wear['cycles_per_update']:g} revolutions take off {ratio:.2f} of the elastic "
            f"deflection at one place, the steps overshoot above {UNSTABLE}; give at most "
            f"{wear['cycles_per_update'] * COARSE / ratio:.2g} (and running_cycles as whole multiples of it)"
        )
    if ratio > COARSE:
        stage.announce(f"warning: one block of cycles takes off {ratio:.2f} of the elastic deflection at one place")
    depth = worn["wear_depth"].values + taken
    stage.log.info("deepest wear of the pinion %.3f um, of the gear %.3f um", *1e6 * depth.max(axis=1))
    along = ("gear", "path")
    values = {
        "wear_depth": (along, depth),
        "wear_per_revolution": (along, increment),
        "running_cycles": float(worn["running_cycles"]) + wear["cycles_per_update"],
    }
    store.save(xr.Dataset(values, {"path": geometry["path"], "gear": geometry["gear"]}), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
