"""Figure 7: thermal growth of one flank of either gear along the path of contact."""

from typing import TYPE_CHECKING

from gearwear.figures import flanks
from gearwear.figures.sheet import DOUBLE, sheet
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    geometry = store.load(job.input.geometry)
    growths = [store.load(path)["thermal_growth"] for path in job.input.deformation]
    with sheet(job, DOUBLE, 68) as figure:
        flanks.draw(figure, geometry, growths, job.params.cfg["states"], "Thermal growth of one flank (µm)")


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
