"""The states of a case, its whole wear chain run in one process by the functions of the stages."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import xarray as xr

from gearwear.chain.backlash import backlash
from gearwear.chain.deformation import deformation
from gearwear.chain.pristine import unworn
from gearwear.chain.response import response
from gearwear.chain.sharing import transmission_error
from gearwear.chain.stiffness import mesh_stiffness
from gearwear.chain.temperature import temperature
from gearwear.chain.wear import worn
from gearwear.errors import Infeasible
from gearwear.io.store import together


def states(
    cfg: dict[str, Any], geometry: xr.Dataset, updates: int, reference: xr.Dataset | None = None
) -> Iterator[xr.Dataset]:
    """Yield wear, mesh stiffness, transmission error and backlash of a case after every wear cycle, unworn first.

    Parameters
    ----------
    cfg : the sections that the stages of the chain read, and the entry `case`.
    updates : wear cycles after the unworn state.
    reference : the same of the pristine reference case; None for a case without wear cycles.

    Raises
    ------
    Infeasible : the settings lead to a state that cannot be.
    """
    grown = deformation(cfg, geometry, temperature(cfg, geometry))

    def state_of(flanks):
        stiffness = mesh_stiffness(cfg, geometry, grown, flanks)
        shared = transmission_error(cfg, geometry, grown, flanks, stiffness)
        return flanks, stiffness, shared, backlash(cfg, geometry, grown, flanks, shared)

    state = state_of(unworn(geometry))
    yield together(state)
    for _ in range(updates):
        if reference is None:
            raise Infeasible("wear needs the motion, and with it the state of the reference case; give it")
        motion = response(cfg, geometry, together(state), reference)
        flanks, stiffness, shared, _ = state
        state = state_of(worn(cfg, geometry, flanks, stiffness, shared, motion))
        yield together(state)


def states_of_case(
    config: dict[str, Any], geometry: xr.Dataset, case: str, reference: xr.Dataset | None = None
) -> Iterator[xr.Dataset]:
    """Yield the states of a case of the configuration, to its running cycles; see `states`."""
    settings = config["cases"][case]
    updates = round(settings["running_cycles"] / config["wear"]["cycles_per_update"])
    return states(config | {"case": settings}, geometry, updates, reference)


def last_state(
    config: dict[str, Any], geometry: xr.Dataset, case: str, reference: xr.Dataset | None = None
) -> xr.Dataset:
    """Return the last of the states of a case."""
    *_, last = states_of_case(config, geometry, case, reference)
    return last
