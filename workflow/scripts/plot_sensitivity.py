"""What every option and every open parameter changes, as tornado charts."""

from typing import TYPE_CHECKING

from gearwear.figures import sensitivity
from gearwear.figures.sheet import DOUBLE, sheet
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    table = store.load(job.input.measures)
    with sheet(job, DOUBLE, sensitivity.HEIGHT) as figure:
        sensitivity.draw(figure, table)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
