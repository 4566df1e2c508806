"""The job of a stage: calls the function of the rule's name with its inputs."""

from typing import TYPE_CHECKING

from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

stage.run(snakemake)
