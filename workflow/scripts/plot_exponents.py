"""Sections of all sweeps, coloured by the largest Lyapunov exponent."""

from typing import TYPE_CHECKING

from gearwear.figures import exponents
from gearwear.figures.sheet import DOUBLE, sheet
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    panels = job.params.cfg["panels"]
    sweeps = [store.load(path) for path in job.input.sweeps]
    with sheet(job, DOUBLE, 22 + 58 * -(-len(panels) // 2)) as figure:
        exponents.draw(figure, list(zip(sweeps, panels, strict=True)))


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
