"""Load sharing and loaded static transmission error of the worn, hot pair."""

from typing import TYPE_CHECKING

from gearwear.chain.sharing import transmission_error
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    names = ("geometry", "deformation", "wear", "mesh_stiffness")
    geometry, *others = (store.load(job.input[name]) for name in names)
    mesh = transmission_error(job.params.cfg, geometry, *others)
    mean = mesh["transmission_error"].values @ geometry["mesh_phase_width"].values
    stage.log.info("mean transmission error %.3f um", 1e6 * mean)
    store.save(mesh, job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
