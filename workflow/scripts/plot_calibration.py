"""The trade-off between the three sweeps, and which claims the good candidates agree with."""

from typing import TYPE_CHECKING

from gearwear.figures import calibration
from gearwear.figures.sheet import DOUBLE, sheet
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    found = store.load(job.input.calibration)
    with sheet(job, DOUBLE, calibration.HEIGHT) as figure:
        calibration.draw(figure, found)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
