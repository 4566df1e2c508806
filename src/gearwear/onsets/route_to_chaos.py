"""The route of a state to chaos along the mesh frequency, its sweeps and branches included, in one process."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.motions.motion_variables import columns
from gearwear.motions.settling import Settling, settle_many
from gearwear.motions.start import rest_state
from gearwear.motions.sweep import carried
from gearwear.onsets import route
from gearwear.onsets.doublings import Onset
from gearwear.orbits import branch_variables
from gearwear.orbits.branches import explore
from gearwear.orbits.continuation import Limits
from gearwear.orbits.return_map import COARSEST, return_maps
from gearwear.orbits.seeds import seeds_along
from gearwear.oscillator.excitation import Excitation


def swept(config: dict[str, Any], source: Excitation, order: str) -> xr.Dataset:
    """Return the sweep of a state over the mesh frequency, as the stages write it.

    Parameters
    ----------
    config : the sections `dynamics`, `settling` and `sweeps.mesh_frequency`.
    source : excitation of the state.
    order : restart, up or down.
    """
    dynamics, ends, settling = config["dynamics"], config["sweeps"]["mesh_frequency"], Settling(**config["settling"])
    values = np.linspace(ends["first"], ends["last"], ends["points"])
    oscillators = [source.oscillator(dynamics, float(value)) for value in values]

    def rest(oscillator):
        return rest_state(source, oscillator, dynamics)

    if order == "restart":
        starts = np.array([rest(oscillator) for oscillator in oscillators])
        motions = settle_many(oscillators, starts, settling, dynamics["tolerance"])
    else:
        along = slice(None, None, -1 if order == "down" else 1)
        motions = carried(oscillators[along], rest, settling, dynamics["tolerance"])[along]
    table = columns(motions, settling.sampled_periods, source.force_parameter)
    return xr.Dataset(table, {route.SWEEP: ("point", values)})


def events(config: dict[str, Any], source: Excitation, sweeps: list[xr.Dataset], largest_period: int) -> list[Onset]:
    """Return the events along the first of the sweeps, the places of the doublings on branches of orbits.

    Parameters
    ----------
    config : as of `swept`, with the sections `branches` and `onsets.refinement`.
    sweeps : of the state, the first in the order `sweeps.order`; the branches start from the orbits of all of them.
    largest_period : of the orbits that are followed; the doublings of longer ones are absent.
    """
    dynamics, ends, following = config["dynamics"], config["sweeps"]["mesh_frequency"], config["branches"]
    found = [
        seed
        for sweep in sweeps
        for seed in seeds_along(sweep, route.SWEEP, largest_period)
        if source.oscillator(dynamics, seed.value).torque.repeats_after(seed.period)
    ]
    limits = Limits(ends["first"], ends["last"], following["largest_step"], most_nodes=following["most_nodes"])
    maps = return_maps(lambda value: source.oscillator(dynamics, value), min(dynamics["tolerance"], COARSEST))
    branches = explore(maps, found, limits, largest_period)
    table = xr.Dataset(branch_variables.columns(branches, largest_period, route.SWEEP))
    state = route.State(source, dynamics, Settling(**config["settling"]), table)
    return route.along(state, sweeps[0], config["sweeps"]["order"], config["onsets"]["refinement"])
