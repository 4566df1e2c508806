"""The route of a state to chaos along the mesh frequency, its sweeps and branches included, in one process."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.motions.settling import Settling
from gearwear.motions.sweep import sweep
from gearwear.onsets import route
from gearwear.onsets.doublings import Onset
from gearwear.orbits import branch_variables
from gearwear.orbits.continuation import Limits
from gearwear.orbits.seeds import branches_of_sweeps
from gearwear.oscillator.excitation import Excitation, SweptOscillator


def swept(config: dict[str, Any], source: Excitation, order: str) -> xr.Dataset:
    """Return the sweep of a state over the mesh frequency, as the stages write it.

    Parameters
    ----------
    config : the sections `dynamics`, `settling` and `sweeps.mesh_frequency`.
    source : excitation of the state.
    order : restart, up or down.
    """
    ends = config["sweeps"][route.SWEEP]
    values = np.linspace(ends["first"], ends["last"], ends["points"])
    along = SweptOscillator(source, route.SWEEP, config["dynamics"], ends)
    return sweep(along, values, Settling(**config["settling"]), order)


def events(config: dict[str, Any], source: Excitation, sweeps: list[xr.Dataset], largest_period: int) -> list[Onset]:
    """Return the events along the first of the sweeps, the places of the doublings on branches of orbits.

    Parameters
    ----------
    config : as of `swept`, with the sections `branches` and `onsets.refinement`.
    sweeps : of the state, the first in the order `sweeps.order`; the branches start from the orbits of all of them.
    largest_period : of the orbits that are followed; the doublings of longer ones are absent.
    """
    dynamics, ends, following = config["dynamics"], config["sweeps"][route.SWEEP], config["branches"]
    limits = Limits(ends["first"], ends["last"], following["largest_step"], most_nodes=following["most_nodes"])
    along = SweptOscillator(source, route.SWEEP, dynamics, ends)
    branches = branches_of_sweeps(along, sweeps, limits, largest_period)
    table = xr.Dataset(branch_variables.columns(branches, largest_period, route.SWEEP))
    state = route.State(source, dynamics, Settling(**config["settling"]), table)
    return route.along(state, sweeps[0], config["sweeps"]["order"], config["onsets"]["refinement"])
