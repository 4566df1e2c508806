"""The job of a figure: calls the draw function in `params.draw` with the inputs of the rule."""

from typing import TYPE_CHECKING

from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

stage.run_figure(snakemake)
