"""Basins of attraction at the chosen values of a sweep."""

from typing import TYPE_CHECKING

from gearwear.figures import basins
from gearwear.figures.sheet import DOUBLE, sheet
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    mapped = store.load(job.input.basins)
    with sheet(job, DOUBLE, basins.height(mapped), layout=None) as figure:
        basins.draw(figure, mapped, job.params.cfg)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
