"""Half backlash of the worn, hot, loaded pair."""

from typing import TYPE_CHECKING

import xarray as xr

from gearwear.mesh.backlash import half_backlash
from gearwear.plumbing import stage, store

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    settings, geometry = job.params.cfg["backlash"], store.load(job.input.geometry)
    wear, deformation = store.load(job.input.wear), store.load(job.input.deformation)
    clearance = half_backlash(
        settings["half_backlash"],
        store.load(job.input.transmission_error)["elastic_deflection"].values,
        wear["wear_depth"].values,
        deformation["thermal_growth"].values,
        float(geometry["working_pressure_angle"]),
        settings["projection"],
    )
    over_mesh = clearance[geometry["entering"].values]
    stage.log.info("mean half backlash %.3f um", 1e6 * over_mesh @ geometry["mesh_phase_width"].values)
    values = {
        "backlash": ("mesh_phase", over_mesh),
        "backlash_path": ("path", clearance),
        "initial_half_backlash": settings["half_backlash"],
    }
    store.save(xr.Dataset(values, {name: geometry[name] for name in ("path", "mesh_phase")}), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
