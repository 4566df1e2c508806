"""The versions of the packages that a run was made with."""

from typing import TYPE_CHECKING

from gearwear.io import tables
from gearwear.run import job

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    tables.write(job, "versions", ("package", "version"), sorted(job.params.cfg.items()))


if __name__ == "__main__":
    with job.logged(snakemake, __file__):
        main(snakemake)
