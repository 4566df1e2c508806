"""Phase portraits and sections at the values of a sweep that the figures show."""

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from gearwear.integrate.strobe import trace
from gearwear.io import store
from gearwear.motions.motion_variables import columns, end_of
from gearwear.motions.settling import Settling, settle
from gearwear.motions.start import rest_state
from gearwear.oscillator.excitation import swept_oscillator
from gearwear.oscillator.excitation_variables import recorded
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

STEPS = 128  # points of an orbit per mesh period
LONGEST = 80  # mesh periods of an orbit that does not repeat


def main(job):
    cfg, sweep = job.params.cfg, job.wildcards.sweep
    dynamics, swept = cfg["dynamics"], cfg["sweeps"][sweep]
    source = recorded(store.load(job.input.excitation))
    values = np.array(cfg["portraits"][sweep][job.wildcards.case])
    settling = Settling(**cfg["settling"])
    phases = np.arange(STEPS) / STEPS
    orbits = np.full((2, len(values), LONGEST * STEPS + 1), np.nan)
    motions = []
    for i, value in enumerate(values):
        oscillator = swept_oscillator(source, sweep, float(value), dynamics, swept)
        motion = settle(oscillator, rest_state(source, oscillator, dynamics), settling, dynamics["tolerance"])
        motions.append(motion)
        periods = motion.period or LONGEST
        reached = motion.transient_periods + settling.sampled_periods
        if np.isnan(motion.displacement[-1]):
            continue  # the motion was lost; its panel stays without an orbit
        runs = trace(oscillator, end_of(motion), phases, periods + 1, reached, dynamics["tolerance"])
        for orbit, run in zip(orbits[:, i], runs, strict=True):
            orbit[: periods * STEPS + 1] = run.ravel()[: periods * STEPS + 1]
    stage.log.info("%d portraits of %s traced", len(values), sweep)
    table = columns(motions, settling.sampled_periods, source.force_parameter)
    table["orbit_displacement"] = (("point", "time"), orbits[0])
    table["orbit_velocity"] = (("point", "time"), orbits[1])
    table["orbit_period"] = ("time", np.arange(LONGEST * STEPS + 1) / STEPS)
    store.save(xr.Dataset(table, {sweep: ("point", values)}), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
