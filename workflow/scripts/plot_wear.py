"""Figure 6: wear depth of both flanks along the path of contact."""

from typing import TYPE_CHECKING

from gearwear.figures import flanks
from gearwear.figures.sheet import DOUBLE, sheet
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    geometry, drawn = store.load(job.input.geometry), job.params.cfg["states"]
    depths = [store.load(path)["wear_depth"] for path in job.input.wear]
    with sheet(job, DOUBLE, 105) as figure:
        flanks.draw(figure, geometry, depths, drawn, "Wear depth (µm)", enlarged=True)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
