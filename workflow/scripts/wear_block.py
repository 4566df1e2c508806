"""Several wear cycles in one job."""

from typing import TYPE_CHECKING

from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

stage.run_block(snakemake)
