"""Figure of a study: classes of motion over the speed, a panel for every combination of the other axes."""

from typing import TYPE_CHECKING

from gearwear.figures import studies
from gearwear.figures.sheet import DOUBLE, sheet
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    study = store.load(job.input.study)
    with sheet(job, DOUBLE, studies.height(study, job.params.cfg["axes"])) as figure:
        studies.draw(figure, study, job.params.cfg)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
