"""What is handed over of a case as flat tables, with the dictionary of their columns."""

from typing import TYPE_CHECKING

from gearwear.io import flat, store, tables
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    dataset = store.load(job.input.dataset)
    for table in flat.TABLES:
        columns = flat.columns(dataset, table)
        tables.write_csv(job.output[table], [column.heading for column in columns], flat.rows(columns, table))
    tables.write_csv(job.output.dictionary, ("file", "column", "unit", "meaning"), flat.dictionary(dataset))


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
