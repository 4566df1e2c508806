"""One part of a sweep: the settled motion at its points."""

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr
from gearwear.dynamics.attractors import settle
from gearwear.dynamics.evidence import columns

from gearwear.dynamics.excitation import excitation, swept_oscillator
from gearwear.dynamics.parts import indices
from gearwear.plumbing import stage, store

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    cfg, geometry, sweep = job.params.cfg, store.load(job.input.geometry), job.wildcards.sweep
    dynamics, swept, order = cfg["dynamics"], cfg["sweeps"][sweep], cfg["sweeps"]["start"]
    state, reference = store.mesh_states(job.input)
    source = excitation(geometry, state, reference, cfg["operation"]["pinion_torque"], dynamics)
    values = np.linspace(swept["first"], swept["last"], swept["points"])
    own = indices(swept["points"], job.wildcards.scatteritem, order)
    rest = (dynamics["start"]["displacement"], dynamics["start"]["velocity"])
    motions, begin = [], rest
    for i in own:
        oscillator = swept_oscillator(source, sweep, float(values[i]), dynamics, swept)
        motions.append(settle(oscillator, begin, tolerance=dynamics["tolerance"], **cfg["settling"]))
        begin = rest if order == "restart" else motions[-1].state
    stage.log.info("%d points of %s swept", len(own), sweep)
    table = columns(motions, cfg["settling"]["sampled_periods"], source.force_parameter)
    store.save(xr.Dataset(table, {sweep: ("point", values[own])}), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
