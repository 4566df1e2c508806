"""The parts of a sweep as one file in the order of the swept quantity."""

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from gearwear.errors import BadFile
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    sweep = job.wildcards.sweep
    parts = [store.load(path) for path in job.input.parts]
    whole = xr.concat([part for part in parts if part.sizes["point"]], dim="point").sortby(sweep)
    points = job.params.cfg["sweeps"][sweep]["points"]
    if whole.sizes["point"] != points or (np.diff(whole[sweep].values) <= 0).any():
        raise BadFile(
            f"{sweep}: the parts hold {whole.sizes['point']} points, {points} different ones are wanted; delete the "
            "folder of the parts and run the workflow again"
        )
    store.save(whole, job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
