"""Stiffness of a tooth pair along its path and of the mesh over its phase, hot and worn."""

from typing import TYPE_CHECKING

from gearwear.chain.stiffness import mesh_stiffness
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    geometry, deformation, wear = (store.load(job.input[name]) for name in ("geometry", "deformation", "wear"))
    mesh = mesh_stiffness(job.params.cfg, geometry, deformation, wear)
    mean = mesh["mesh_stiffness"].values @ geometry["mesh_phase_width"].values
    stage.log.info("mean mesh stiffness %.5g N/m", mean)
    store.save(mesh, job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
