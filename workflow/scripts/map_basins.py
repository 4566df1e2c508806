"""Basins of attraction at chosen values of a sweep: attractors, their shares, and which state leads to which."""

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from gearwear.errors import ConfigError
from gearwear.io import store
from gearwear.motions.basin_variables import basin_columns
from gearwear.motions.basins import basins, cell_centres
from gearwear.motions.settling import Settling
from gearwear.oscillator.excitation import swept_oscillator
from gearwear.oscillator.excitation_variables import recorded
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    cfg, sweep = job.params.cfg, job.wildcards.sweep
    dynamics, swept, wanted = cfg["dynamics"], cfg["sweeps"][sweep], cfg["basins"]
    source = recorded(store.load(job.input.excitation))
    case = job.wildcards.case
    values = np.array(wanted["points"][sweep][case])
    if not values.size:
        raise ConfigError(f"basins.points.{sweep}.{case}: an empty list; give at least one value")
    displacement, velocity = (
        cell_centres(wanted[name]["first"], wanted[name]["last"], wanted["resolution"])
        for name in ("displacement", "velocity")
    )
    states = np.stack(np.meshgrid(displacement, velocity, indexing="ij"), axis=-1).reshape(-1, 2)
    settling, found = Settling(**cfg["settling"]), []
    for value in values:
        oscillator = swept_oscillator(source, sweep, float(value), dynamics, swept)
        found.append(basins(oscillator, states, settling, dynamics["tolerance"]))
        stage.log.info("%s %g: shares %s", sweep, value, ", ".join(f"{share:.3f}" for share in found[-1].shares))
    shape = len(displacement), len(velocity)
    table = basin_columns(found, shape, settling.sampled_periods, source.force_parameter)
    table["initial_displacement"] = ("displacement_cell", displacement)
    table["initial_velocity"] = ("velocity_cell", velocity)
    names = (sweep, "initial_displacement", "initial_velocity")
    store.save(xr.Dataset(table | {sweep: ("point", values)}).set_coords(names), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
