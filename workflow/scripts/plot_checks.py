"""Figure: one group of checks, found against expected."""

from typing import TYPE_CHECKING

from gearwear.figures import validation
from gearwear.figures.sheet import DOUBLE, sheet
from gearwear.run import stage
from gearwear.validation import outcomes
from gearwear.validation.checks import read

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    drawn = outcomes.merged(read(job.input.checks), outcomes.read_rows(job.input.found))
    with sheet(job, DOUBLE, validation.height(drawn), layout=None) as figure:
        validation.draw(figure, drawn)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
