"""Load sharing and loaded static transmission error of the worn, hot pair."""

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from gearwear.geometry.kinematics import mesh_force
from gearwear.mesh.sharing import transmission
from gearwear.plumbing import stage, store

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    cfg, geometry = job.params.cfg, store.load(job.input.geometry)
    wear, deformation = store.load(job.input.wear), store.load(job.input.deformation)
    mesh = transmission(
        geometry,
        store.load(job.input.mesh_stiffness),
        wear["wear_depth"].values,
        deformation["thermal_growth"].values,
        mesh_force(geometry, cfg["operation"]["pinion_torque"]),
        **cfg["transmission_error"],
    )
    error = mesh.transmission_error
    stage.log.info("mean transmission error %.3f um", 1e6 * error @ geometry["mesh_phase_width"].values)
    values = {
        "transmission_error": ("mesh_phase", error),
        "effective_stiffness": ("mesh_phase", mesh.effective_stiffness),
        "load_sharing_factor": (("mesh_phase", "pair"), mesh.load_sharing_factor),
        "load_share_path": ("path", mesh.load_share_path),
        "elastic_deflection": ("path", mesh.elastic_deflection),
        "profile_error": ("path", mesh.profile_error),
        "sharing_error": ("path", mesh.sharing_error),
    }
    coords = {"path": geometry["path"], "mesh_phase": geometry["mesh_phase"], "pair": np.array(["entering", "leaving"])}
    store.save(xr.Dataset(values, coords), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
