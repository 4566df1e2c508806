"""What is measured of a member: the mesh, the wear and the route to chaos of the cases `without` and `with`."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.attractors.chain import carried
from gearwear.attractors.record import columns
from gearwear.attractors.settling import Settling, settle_many
from gearwear.chain.geometry import geometry
from gearwear.chain.last_state import last_state
from gearwear.dynamics.excitation import Excitation, excitation, rest_state
from gearwear.geometry.involute import GEARS
from gearwear.onsets import route
from gearwear.onsets.shifts import CASES
from gearwear.orbits import record
from gearwear.orbits.branches import explore
from gearwear.orbits.continuation import Limits
from gearwear.orbits.return_map import COARSEST, return_maps
from gearwear.orbits.seeds import seeds
from gearwear.plumbing.stage import worded

_NUMBERS = ("mean_stiffness", "stiffness_ripple", "relative_mean_error", "mean_half_backlash")
_EVENTS = {"first_doubling": 0, "chaos_onset": -1}  # place among the events of a route


def measures(config: dict[str, Any]) -> xr.Dataset:
    """Return the measures of one member.

    Parameters
    ----------
    config : the slice `measures`.

    Returns
    -------
    dataset along `case`; a case that cannot be computed has nan and the reason as its `hindrance`.
    """
    found = []
    for case in CASES:
        try:
            pair = geometry(config)
            reference = last_state(config, pair, config["dynamics"]["reference_case"])
            found.append(_of(config, pair, last_state(config, pair, case, reference), reference))
        except ValueError as error:
            if not worded(error):
                raise
            found.append(_nothing(str(error)))
    return xr.concat(found, dim="case").assign_coords(case=np.array(CASES, dtype=object), gear=list(GEARS))


def _of(config: dict[str, Any], pair: xr.Dataset, state: xr.Dataset, reference: xr.Dataset) -> xr.Dataset:
    torque, dynamics = config["operation"]["pinion_torque"], config["dynamics"]
    source = excitation(pair, state, reference, torque, dynamics)
    first = excitation(pair, state, reference, torque, dynamics | {"harmonics": 1})
    values = {
        "mean_stiffness": first.mean_stiffness,
        "stiffness_ripple": first.stiffness.amplitudes[0],
        "relative_mean_error": first.relative_mean_error,
        "mean_half_backlash": first.clearance.mean * first.length,
        "deepest_wear": ("gear", state["wear_depth"].values.max(axis=1)),
        "hindrance": "",
    }
    events = _route(config, source)
    for name, place in _EVENTS.items():
        values |= {name: events[place].value, f"{name}_remark": events[place].remark}
    return xr.Dataset(values)


def _nothing(reason: str) -> xr.Dataset:
    values = dict.fromkeys((*_NUMBERS, *_EVENTS), np.nan) | dict.fromkeys([f"{name}_remark" for name in _EVENTS], "")
    return xr.Dataset(values | {"deepest_wear": ("gear", np.full(len(GEARS), np.nan)), "hindrance": reason})


def _route(config: dict[str, Any], source: Excitation):
    """Return the events along the mesh frequency; of the branches, only those of period 1 are followed."""
    dynamics, swept = config["dynamics"], config["sweeps"]["mesh_frequency"]
    settling, order = Settling(**config["settling"]), config["sweeps"]["order"]
    sweep = _sweep(source, dynamics, settling, np.linspace(swept["first"], swept["last"], swept["points"]), order)
    limits = Limits(
        swept["first"],
        swept["last"],
        config["branches"]["largest_step"],
        most_nodes=config["branches"]["most_nodes"],
    )
    names = (route.SWEEP, "motion_class", "transient_periods", "section_displacement", "section_velocity")
    maps = return_maps(lambda value: source.oscillator(dynamics, value), min(dynamics["tolerance"], COARSEST))
    branches = explore(maps, seeds(*(sweep[name].values for name in names), 1), limits, 1)
    state = route.State(source, dynamics, settling, xr.Dataset(record.columns(branches, 1, route.SWEEP)))
    return route.along(state, sweep, order, config["onsets"]["refinement"])


def _sweep(
    source: Excitation, dynamics: dict[str, Any], settling: Settling, values: np.ndarray, order: str
) -> xr.Dataset:
    oscillators = [source.oscillator(dynamics, float(value)) for value in values]

    def rest(oscillator):
        return rest_state(source, oscillator, dynamics)

    if order == "restart":
        starts = np.array([rest(oscillator) for oscillator in oscillators])
        motions = settle_many(oscillators, starts, settling, dynamics["tolerance"])
    else:
        along = slice(None, None, -1 if order == "down" else 1)
        motions = carried(oscillators[along], rest, settling, dynamics["tolerance"])[along]
    return xr.Dataset(
        columns(motions, settling.sampled_periods, source.force_parameter), {route.SWEEP: ("point", values)}
    )
