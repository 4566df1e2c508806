"""The onsets of one member of the ensemble: its wear chains and its route to chaos, computed in one process."""

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from gearwear.chain.geometry import geometry
from gearwear.chain.states import last_state
from gearwear.codes.onset_codes import ORDERS
from gearwear.io import store
from gearwear.onsets import route_to_chaos
from gearwear.onsets.onset_variables import columns
from gearwear.onsets.shifts import CASES
from gearwear.oscillator.excitation import excitation
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    cfg = job.params.cfg
    pair, dynamics, order = geometry(cfg), cfg["dynamics"], cfg["sweeps"]["order"]
    reference = last_state(cfg, pair, dynamics["reference_case"])
    found = []
    for case in CASES:
        state = last_state(cfg, pair, case, reference)
        source = excitation(pair, state, reference, cfg["operation"]["pinion_torque"], dynamics)
        sweeps = [route_to_chaos.swept(cfg, source, one) for one in sorted(ORDERS, key=lambda one: one != order)]
        events = route_to_chaos.events(cfg, source, sweeps, cfg["branches"]["largest_period"])
        stage.log.info("case %s: %s", case, ", ".join(f"{event.value:.6f}" for event in events))
        found.append(xr.Dataset(columns([events])).set_coords("event"))
    store.save(xr.concat(found, dim="case").assign_coords(case=np.array(CASES, dtype=object)), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
