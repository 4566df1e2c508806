"""A sweep as one chain: every point starts where the motion of its neighbour ended."""

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from gearwear.io import store
from gearwear.motions.motion_variables import columns
from gearwear.motions.settling import Settling
from gearwear.motions.start import rest_state
from gearwear.motions.sweep import carried
from gearwear.oscillator.excitation import swept_oscillator
from gearwear.oscillator.excitation_variables import recorded
from gearwear.run import stage

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
