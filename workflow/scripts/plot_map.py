"""Maps of the motion class and the largest Lyapunov exponent over the mesh frequency and another parameter."""

from typing import TYPE_CHECKING

from gearwear.figures import maps
from gearwear.figures.sheet import DOUBLE, sheet
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    drawn = store.load(job.input.map)
    with sheet(job, DOUBLE, maps.HEIGHT) as figure:
        maps.draw(figure, drawn, job.params.cfg)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
