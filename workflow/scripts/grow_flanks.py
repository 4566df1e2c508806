"""Thermal growth of the four flanks at the bulk temperature, or at the contact temperature."""

from typing import TYPE_CHECKING

from gearwear.chain.deformation import deformation
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    grown = deformation(job.params.cfg, store.load(job.input.geometry), store.load(job.input.temperature))
    mean = float(grown["thermal_growth"].sum("gear").mean())
    stage.log.info("the four flanks grow by %.2f um on average", 2e6 * mean)
    store.save(grown, job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
