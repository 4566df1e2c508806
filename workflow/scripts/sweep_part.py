"""One part of a sweep whose points all start from rest: the settled motion at each."""

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from gearwear.io import store
from gearwear.motions.motion_variables import columns
from gearwear.motions.settling import Settling, settle_many
from gearwear.motions.start import rest_state
from gearwear.oscillator.excitation import swept_oscillator
from gearwear.oscillator.excitation_variables import recorded
from gearwear.run import stage
from gearwear.run.parts import indices

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    cfg, sweep = job.params.cfg, job.wildcards.sweep
    dynamics, swept = cfg["dynamics"], cfg["sweeps"][sweep]
    source = recorded(store.load(job.input.excitation))
    values = np.linspace(swept["first"], swept["last"], swept["points"])
    own = indices(swept["points"], job.wildcards.scatteritem)
    settling = Settling(**cfg["settling"])
    oscillators = [swept_oscillator(source, sweep, float(values[i]), dynamics, swept) for i in own]
    begins = [rest_state(source, oscillator, dynamics) for oscillator in oscillators]
    motions = settle_many(oscillators, begins, settling, dynamics["tolerance"])
    stage.log.info("%d points of %s swept", len(own), sweep)
    table = columns(motions, settling.sampled_periods, source.force_parameter)
    store.save(xr.Dataset(table, {sweep: ("point", values[own])}), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
