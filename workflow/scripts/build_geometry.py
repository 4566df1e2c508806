"""Dimensions of the gear pair, the path of contact and the grids of the mesh."""

from typing import TYPE_CHECKING

from gearwear.chain.geometry import geometry
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    pair = geometry(job.params.cfg)
    ratio, mass = float(pair["contact_ratio"]), float(pair["equivalent_mass"])
    stage.log.info("contact ratio %.4f, equivalent mass %.4f kg", ratio, mass)
    store.save(pair, job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
