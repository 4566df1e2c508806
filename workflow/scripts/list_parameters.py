"""Every value of the configuration that a run was made with."""

import csv
from typing import TYPE_CHECKING

from gearwear.plumbing import parameters, stage, store

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    with store.atomic(job.output[0]) as temporary, open(temporary, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(parameters.COLUMNS)
        writer.writerows(parameters.rows(job.params.cfg))


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
