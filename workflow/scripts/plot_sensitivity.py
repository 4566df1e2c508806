"""What every option and every open parameter changes, as tornado charts."""

from typing import TYPE_CHECKING

from gearwear.drawing import sensitivity
from gearwear.drawing.sheet import DOUBLE, sheet
from gearwear.plumbing import stage, store

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    table = store.load(job.input.measures)
    with sheet(job, DOUBLE, sensitivity.HEIGHT) as figure:
        sensitivity.draw(figure, table)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
