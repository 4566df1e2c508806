"""The versions of the packages that a run was made with."""

from typing import TYPE_CHECKING

from gearwear.io import tables
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    tables.write(job, "versions", ("package", "version"), sorted(job.params.cfg.items()))


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
