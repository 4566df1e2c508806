"""The gears, and the mesh and the worn flanks at every wear cycle, for other programs."""

from typing import TYPE_CHECKING

from gearwear.chain.handover import handover
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

PARTS = ("wear", "mesh_stiffness", "transmission_error", "backlash", "response")


def main(job):
    cycles = zip(*(job.input[part] for part in PARTS), strict=True)
    states = [store.together(map(store.load, paths)) for paths in cycles]
    stage.log.info("%d wear cycles handed over", len(states))
    store.save(handover(job.params.cfg, store.load(job.input.geometry), states), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
