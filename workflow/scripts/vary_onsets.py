"""The onsets of one case computed in other ways: orders, start, settling, step and integrator."""

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from gearwear.codes.onset_codes import ORDERS, VARIANTS
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
    dynamics, refinement = cfg["dynamics"], cfg["onsets"]["refinement"]
    source = recorded(store.load(job.input.excitation))
    state = route.State(source, dynamics, Settling(**cfg["settling"]), store.load(job.input.branches))
    sweeps = {order: store.load(path) for order, path in zip(ORDERS, job.input.sweeps, strict=True)}
    ways = {order: route.along(state, sweeps[order], order, refinement) for order in ORDERS}
    ways |= route.varied(state, sweeps["restart"], ways["restart"], refinement)
    for name, events in ways.items():
        stage.log.info("%s: %s", name, ", ".join(f"{event.seen:.6f}" for event in events))
    table = columns([ways[name] for name in VARIANTS]) | {"variant": ("variant", np.array(VARIANTS, dtype=object))}
    store.save(xr.Dataset(table).set_coords(["event", "variant"]), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
