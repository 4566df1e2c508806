"""The measures of the study and of every variation of it as one table."""

from typing import TYPE_CHECKING

from gearwear.io import store, tables
from gearwear.run import stage
from gearwear.sensitivity import table

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    varied = job.params.cfg["varied"]
    compared = table.compared(store.load(job.input.study), [store.load(path) for path in job.input.members], varied)
    store.save(compared, job)
    rows = table.rows(compared)
    tables.write_rows(rows, job.output.table)
    for row in rows:
        if row["hindrance"] != table.NOTHING:
            stage.announce(f"{row['key']} {row['value']}: not possible: {row['hindrance']}")


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
