"""Half backlash of the worn, hot, loaded pair."""

from typing import TYPE_CHECKING

from gearwear.chain.backlash import backlash
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    names = ("geometry", "deformation", "wear", "transmission_error")
    geometry, *others = (store.load(job.input[name]) for name in names)
    clearance = backlash(job.params.cfg, geometry, *others)
    mean = clearance["backlash"].values @ geometry["mesh_phase_width"].values
    stage.log.info("mean half backlash %.3f um", 1e6 * mean)
    store.save(clearance, job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
