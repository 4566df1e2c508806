"""Every value of the configuration that a run was made with, and where it comes from."""

from pathlib import Path
from typing import TYPE_CHECKING

from gearwear.config import listing, origins
from gearwear.io import tables
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    cfg = job.params.cfg
    files = [Path(file) for file in job.input.files]
    layers = [origins.file_layer(file.name, file.read_text(encoding="utf-8")) for file in files]
    layers.append(origins.command_line_layer(cfg["command_line"]))
    tables.write(job, "parameters", listing.COLUMNS, listing.rows(cfg["configuration"], layers))


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
