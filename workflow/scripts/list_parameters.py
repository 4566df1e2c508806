"""Every value of the configuration that a run was made with."""

from typing import TYPE_CHECKING

from gearwear.plumbing import parameters, stage, tables

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    tables.write(job, "parameters", parameters.COLUMNS, parameters.rows(job.params.cfg))


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
