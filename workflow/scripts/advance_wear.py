"""Wear of both flanks by one block of running cycles under the mesh force of the cycle before."""

from typing import TYPE_CHECKING

from gearwear.chain.wear import share_of_deflection, worn
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    cfg = job.params.cfg
    names = ("geometry", "wear", "mesh_stiffness", "transmission_error", "response")
    geometry, wear, mesh_stiffness, transmission_error, response = (store.load(job.input[name]) for name in names)
    flanks = worn(cfg, geometry, wear, mesh_stiffness, transmission_error, response)
    increment, cycles = flanks["wear_per_revolution"].values, cfg["wear"]["cycles_per_update"]
    ratio = share_of_deflection(increment, cycles, transmission_error)
    stage.log.info("one block of cycles takes off %.2f of the elastic deflection at one place", ratio)
    deepest = flanks["wear_depth"].values.max(axis=1)
    stage.log.info("deepest wear of the pinion %.3f um, of the gear %.3f um", *1e6 * deepest)
    store.save(flanks, job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
