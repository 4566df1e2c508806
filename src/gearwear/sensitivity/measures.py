"""What is measured of a member: the mesh, the wear and the route to chaos of the cases `without` and `with`."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.chain.geometry import geometry
from gearwear.chain.history import last_state
from gearwear.errors import Infeasible
from gearwear.geometry.involute import GEARS
from gearwear.onsets import route_to_chaos
from gearwear.onsets.shifts import CASES
from gearwear.oscillator.excitation import excitation
from gearwear.oscillator.periodic import sum_of_harmonics

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
        except Infeasible as error:
            found.append(_nothing(str(error)))
    return xr.concat(found, dim="case").assign_coords(case=np.array(CASES, dtype=object), gear=list(GEARS))


def _of(config: dict[str, Any], pair: xr.Dataset, state: xr.Dataset, reference: xr.Dataset) -> xr.Dataset:
    torque, dynamics = config["operation"]["pinion_torque"], config["dynamics"]
    source = excitation(pair, state, reference, torque, dynamics)
    first = excitation(pair, state, reference, torque, dynamics | {"harmonics": 1})
    values = {
        "mean_stiffness": first.mean_stiffness,
        "stiffness_ripple": sum_of_harmonics(first.stiffness).amplitudes[0],
        "relative_mean_error": first.relative_mean_error,
        "mean_half_backlash": first.clearance.mean * first.length,
        "deepest_wear": ("gear", state["wear_depth"].values.max(axis=1)),
        "hindrance": "",
    }
    events = route_to_chaos.events(config, source, [route_to_chaos.swept(config, source, config["sweeps"]["order"])], 1)
    for name, place in _EVENTS.items():
        values |= {name: events[place].value, f"{name}_remark": events[place].remark}
    return xr.Dataset(values)


def _nothing(reason: str) -> xr.Dataset:
    values = dict.fromkeys((*_NUMBERS, *_EVENTS), np.nan) | dict.fromkeys([f"{name}_remark" for name in _EVENTS], "")
    return xr.Dataset(values | {"deepest_wear": ("gear", np.full(len(GEARS), np.nan)), "hindrance": reason})
