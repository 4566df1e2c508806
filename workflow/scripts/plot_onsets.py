"""The shift of every onset: numerical error, ensemble, and the parameters one at a time."""

from typing import TYPE_CHECKING

from gearwear.figures import onsets
from gearwear.figures.sheet import DOUBLE, sheet
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    table = store.load(job.input.shifts)
    with sheet(job, DOUBLE, onsets.HEIGHT) as figure:
        onsets.draw(figure, table)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
