"""Onsets of period doublings and of chaos along the mesh frequency sweep of one case."""

from typing import TYPE_CHECKING

import xarray as xr

from gearwear.codes.onset_codes import EVENTS
from gearwear.io import store
from gearwear.motions.settling import Settling
from gearwear.onsets import route
from gearwear.onsets.onset_variables import columns
from gearwear.oscillator.excitation_variables import recorded
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    cfg = job.params.cfg
    dynamics = cfg["dynamics"]
    source = recorded(store.load(job.input.excitation))
    state = route.State(source, dynamics, Settling(**cfg["settling"]), store.load(job.input.branches))
    events = route.along(state, store.load(job.input.sweep), cfg["sweeps"]["order"], cfg["onsets"]["refinement"])
    for name, event in zip(EVENTS, events, strict=True):
        stage.log.info("%s: %.6f, %s", name, event.value, event.remark)
    store.save(xr.Dataset(columns([events])).set_coords("event"), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
