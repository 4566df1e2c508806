"""The tiles of a map as one file."""

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from gearwear.errors import BadFile
from gearwear.io import store
from gearwear.motions import parameter_map
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    coordinate = parameter_map.COORDINATES[job.wildcards.map]
    tiles = [store.load(path) for path in job.input.tiles]
    whole = xr.concat([tile for tile in tiles if tile.sizes["row"]], dim="row").sortby(coordinate)
    if (np.diff(whole[coordinate].values) <= 0).any():
        raise BadFile(f"{coordinate}: two tiles hold the same row; delete the folder of the tiles and start again")
    store.save(whole, job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
