"""Tooth contact temperature along the path of contact of the cold-shaped pair under the static load."""

from typing import TYPE_CHECKING

from gearwear.chain.temperature import temperature
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    contact = temperature(job.params.cfg, store.load(job.input.geometry))
    bulk, peak = job.params.cfg["case"]["bulk_temperature"], float(contact["flash_temperature"].max())
    stage.log.info("bulk temperature %g degC, flash temperature up to %.1f K", bulk, peak)
    flows = [float(contact[name]) for name in ("mesh_loss", "churning_loss", "convection")]
    stage.log.info("mesh loss %.4g W, churning loss %.4g W, heat given off %.4g W", *flows)
    store.save(contact, job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
