"""Onsets of period doublings and of chaos along the mesh frequency sweep of one case."""

from typing import TYPE_CHECKING

import xarray as xr

from gearwear.attractors.settling import Settling
from gearwear.dynamics.excitation import excitation
from gearwear.onsets import route
from gearwear.onsets.codes import EVENTS
from gearwear.onsets.record import columns
from gearwear.plumbing import stage, store

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    cfg, geometry = job.params.cfg, store.load(job.input.geometry)
    dynamics = cfg["dynamics"]
    source = excitation(geometry, *store.mesh_states(job.input), cfg["operation"]["pinion_torque"], dynamics)
    state = route.State(source, dynamics, Settling(**cfg["settling"]), store.load(job.input.branches))
    events = route.along(state, store.load(job.input.sweep), cfg["sweeps"]["order"], cfg["onsets"]["refinement"])
    for name, event in zip(EVENTS, events, strict=True):
        stage.log.info("%s: %.6f, %s", name, event.value, event.remark)
    store.save(xr.Dataset(columns([events])).set_coords("event"), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
