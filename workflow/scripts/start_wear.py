"""Pristine flanks: the wear depth before the first cycle."""

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from gearwear.plumbing import stage, store

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    geometry = store.load(job.input.geometry)
    none = np.zeros((geometry.sizes["gear"], geometry.sizes["path"]))
    values = {
        "wear_depth": (("gear", "path"), none),
        "wear_per_revolution": (("gear", "path"), none),
        "running_cycles": 0.0,
    }
    store.save(xr.Dataset(values, {"path": geometry["path"], "gear": geometry["gear"]}), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
