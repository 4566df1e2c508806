"""Figure 6: wear depth of both flanks along the path of contact."""

from typing import TYPE_CHECKING

from gearwear.drawing import flanks
from gearwear.drawing.sheet import DOUBLE, sheet
from gearwear.plumbing import stage, store

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    geometry = store.load(job.input.geometry)
    depths = [store.load(path)["wear_depth"] for path in job.input.wear]
    with sheet(job, DOUBLE, 68) as figure:
        flanks.draw(figure, geometry, depths, job.params.cfg["states"], "Wear depth (µm)")


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
