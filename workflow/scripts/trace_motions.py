"""One steady stretch of the motion at every point of a sweep, with its mesh force."""

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from gearwear.integrate.strobe import trace
from gearwear.io import store
from gearwear.oscillator.excitation import restoring_force, swept_oscillator
from gearwear.oscillator.excitation_variables import recorded
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

STEPS = 128  # points of an orbit per mesh period
LONGEST = 10  # mesh periods of an orbit, and of one that does not repeat


def main(job):
    cfg, sweep = job.params.cfg, job.wildcards.sweep
    dynamics, swept = cfg["dynamics"], cfg["sweeps"][sweep]
    source = recorded(store.load(job.input.excitation))
    points = store.load(job.input.sweep)
    phases = np.arange(STEPS) / STEPS
    orbits = np.full((3, points.sizes["point"], LONGEST * STEPS + 1), np.nan)
    for i in range(points.sizes["point"]):
        point = points.isel(point=i)
        start = [float(point[f"section_{name}"][-1]) for name in ("displacement", "velocity")]
        if np.isnan(start[0]):
            continue  # the motion was lost
        oscillator = swept_oscillator(source, sweep, float(point[sweep]), dynamics, swept)
        periods = min(int(point["period"]) or LONGEST, LONGEST)
        reached = int(point["transient_periods"]) + points.sizes["sample"]
        motion = trace(oscillator, start, phases, periods + 1, reached, dynamics["tolerance"])
        force = restoring_force(oscillator, phases, motion[0]) / source.force_parameter
        for orbit, run in zip(orbits[:, i], (*motion, force), strict=True):
            orbit[: periods * STEPS + 1] = run.ravel()[: periods * STEPS + 1]
    stage.log.info("%d motions of %s traced", points.sizes["point"], sweep)
    names = ("orbit_displacement", "orbit_velocity", "orbit_force")
    table = {name: (("point", "time"), orbit) for name, orbit in zip(names, orbits, strict=True)}
    if np.isfinite(source.natural_frequency):
        table["natural_frequency"] = source.natural_frequency
    time = {"orbit_period": ("time", np.arange(LONGEST * STEPS + 1) / STEPS)}
    store.save(xr.Dataset(table, {sweep: points[sweep]} | time), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
