"""A sweep as one chain: every point starts where the motion of its neighbour ended."""

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from gearwear.attractors.chain import carried
from gearwear.attractors.record import columns
from gearwear.attractors.settling import Settling
from gearwear.dynamics.excitation import rest_state, swept_oscillator
from gearwear.dynamics.excitation_record import recorded
from gearwear.plumbing import stage, store

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    cfg, sweep = job.params.cfg, job.wildcards.sweep
    dynamics, swept = cfg["dynamics"], cfg["sweeps"][sweep]
    source = recorded(store.load(job.input.excitation))
    values = np.linspace(swept["first"], swept["last"], swept["points"])
    along = slice(None, None, -1 if job.wildcards.order == "down" else 1)
    oscillators = (swept_oscillator(source, sweep, float(value), dynamics, swept) for value in values[along])

    def rest(oscillator):
        return rest_state(source, oscillator, dynamics)

    settling = Settling(**cfg["settling"])
    motions = carried(oscillators, rest, settling, dynamics["tolerance"])[along]
    stage.log.info("%d points of %s swept %s", len(values), sweep, job.wildcards.order)
    table = columns(motions, settling.sampled_periods, source.force_parameter)
    store.save(xr.Dataset(table, {sweep: ("point", values)}), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
