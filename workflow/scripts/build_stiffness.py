"""Stiffness of a tooth pair along its path and of the mesh over its phase, hot and worn."""

from typing import TYPE_CHECKING

import xarray as xr

from gearwear.geometry.involute import GEARS, each
from gearwear.geometry.kinematics import mesh_force
from gearwear.heat.modulus import hot_modulus
from gearwear.mesh.stiffness import Flanks, mesh_stiffness, pair_stiffness
from gearwear.plumbing import stage, store

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    cfg, geometry = job.params.cfg, store.load(job.input.geometry)
    wear, deformation = store.load(job.input.wear), store.load(job.input.deformation)
    modulus = hot_modulus(cfg["material"], cfg["elasticity"], cfg["case"]["bulk_temperature"])
    poisson = each({name: cfg["material"][name]["poisson_ratio"] for name in GEARS})
    flanks = Flanks(wear["wear_depth"].values, deformation["thermal_growth"].values)
    force = mesh_force(geometry, cfg["operation"]["pinion_torque"]) if "operation" in cfg else 0.0
    pairs = pair_stiffness(geometry, modulus, poisson, flanks, cfg["mesh_stiffness"], force)
    mesh = mesh_stiffness(pairs, geometry["entering"].values, geometry["leaving"].values)
    stage.log.info("mean mesh stiffness %.5g N/m", mesh @ geometry["mesh_phase_width"].values)
    values = {
        "mesh_stiffness": ("mesh_phase", mesh),
        "pair_stiffness": ("path", pairs.pair_stiffness),
        "pair_coupling": ("path", pairs.coupling),
        "hertz_compliance": ("path", pairs.hertz),
        "youngs_modulus": ("gear", modulus),
    }
    for name in ("bending", "shear", "axial", "foundation"):
        values[f"{name}_compliance"] = (("gear", "path"), getattr(pairs, name))
    coords = {name: geometry[name] for name in ("path", "mesh_phase", "gear")}
    store.save(xr.Dataset(values, coords), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
