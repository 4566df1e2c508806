"""Several wear cycles in one job."""

import gc
from typing import TYPE_CHECKING

gc.set_threshold(100_000)  # what imports make is no garbage; to search it takes a tenth of a short job

from gearwear.run import stage  # noqa: E402

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

stage.run_block(snakemake)
gc.freeze()  # the process ends here
