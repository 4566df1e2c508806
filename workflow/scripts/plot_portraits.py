"""Figures 13, 14, 16, 18: phase portraits and sections at single values of a sweep."""

from typing import TYPE_CHECKING

from gearwear.figures import portraits
from gearwear.figures.sheet import DOUBLE, sheet
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    drawn = store.load(job.input.portraits)
    with sheet(job, DOUBLE, portraits.height(drawn.sizes["point"])) as figure:
        portraits.draw(figure, drawn, job.params.cfg)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
