"""Branches of periodic orbits, stable and unstable, over the range of a sweep."""

from typing import TYPE_CHECKING

import xarray as xr

from gearwear.io import store
from gearwear.orbits.branch_variables import columns
from gearwear.orbits.branches import explore
from gearwear.orbits.continuation import Limits
from gearwear.orbits.return_map import COARSEST, return_maps
from gearwear.orbits.seeds import seeds_along
from gearwear.oscillator.excitation import swept_oscillator
from gearwear.oscillator.excitation_variables import recorded
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    cfg, sweep = job.params.cfg, job.wildcards.sweep
    dynamics, swept, branching = cfg["dynamics"], cfg["sweeps"][sweep], cfg["branches"]
    source = recorded(store.load(job.input.excitation))

    def oscillator_at(value):
        return swept_oscillator(source, sweep, value, dynamics, swept)

    found = [
        seed
        for settled in map(store.load, job.input.sweeps)
        for seed in seeds_along(settled, sweep, branching["largest_period"])
        if oscillator_at(seed.value).torque.repeats_after(seed.period)
    ]
    limits = Limits(swept["first"], swept["last"], branching["largest_step"], most_nodes=branching["most_nodes"])
    maps = return_maps(oscillator_at, min(dynamics["tolerance"], COARSEST))
    branches = explore(maps, found, limits, branching["largest_period"])
    for branch in branches:
        stage.log.info("period %d: from %s to %s", branch.period, branch.start.words, branch.end.words)
    store.save(xr.Dataset(columns(branches, branching["largest_period"], sweep)).set_coords(sweep), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
