"""Pristine flanks: the wear depth before the first cycle."""

from typing import TYPE_CHECKING

from gearwear.chain.pristine import unworn
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    store.save(unworn(store.load(job.input.geometry)), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
