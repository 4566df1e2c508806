"""The wear history of a case, computed in one process."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from inspect import signature
from typing import Any

import numpy as np
import xarray as xr

from gearwear.chain.cycle import CYCLE
from gearwear.chain.deformation import deformation
from gearwear.chain.geometry import geometry
from gearwear.chain.mesh import mesh_excitation
from gearwear.chain.response import response
from gearwear.chain.temperature import temperature
from gearwear.chain.wear import unworn, wear
from gearwear.errors import Infeasible
from gearwear.io.store import together

_MESH = ("mesh_stiffness", "effective_stiffness", "transmission_error")
_KEPT = (*_MESH, "backlash", "initial_half_backlash", "wear_depth", "running_cycles")


def results_of(stage: Callable[..., Any], available: Mapping[str, Any]) -> dict[str, xr.Dataset]:
    """Return what a stage of the cycle makes, by the names in CYCLE.

    Parameters
    ----------
    available : the arguments of the stage, and others, by name.
    """
    made = stage(**{name: available[name] for name in signature(stage).parameters})
    return made if isinstance(made, dict) else {CYCLE[stage.__name__][0]: made}


def states(
    cfg: dict[str, Any], pair: xr.Dataset, updates: int, reference: xr.Dataset | None = None
) -> Iterator[xr.Dataset]:
    """Yield wear, mesh stiffness, transmission error and backlash of a case after every wear cycle, unworn first.

    Parameters
    ----------
    cfg : the sections that the stages read, and the entry `case`.
    pair : dataset of the geometry.
    updates : wear cycles after the unworn state.
    reference : the state of the pristine reference case; None for a case without wear cycles.

    Raises
    ------
    Infeasible : the settings lead to a state that cannot exist.
    """
    contact = cfg["heat"]["temperature_rise"] == "contact"
    grown = deformation(cfg, pair, temperature(cfg, pair) if contact else None)
    available: dict[str, Any] = {"cfg": cfg, "geometry": pair, "deformation": grown, "wear": unworn(pair)}
    available |= {"reference_stiffness": reference, "reference_error": reference}
    available |= results_of(mesh_excitation, available)
    yield _state(available)
    for _ in range(updates):
        if reference is None:
            raise Infeasible("wear needs the motion, and with it the state of the reference case; give it")
        for stage in (response, wear, mesh_excitation):
            available |= results_of(stage, available)
        yield _state(available)


def states_of_case(
    config: dict[str, Any], pair: xr.Dataset, case: str, reference: xr.Dataset | None = None
) -> Iterator[xr.Dataset]:
    """Yield the states of a case of the configuration, to its running cycles; see `states`."""
    settings = config["cases"][case]
    updates = round(settings["running_cycles"] / config["wear"]["cycles_per_update"])
    return states(config | {"case": settings}, pair, updates, reference)


def last_state(config: dict[str, Any], pair: xr.Dataset, case: str, reference: xr.Dataset | None = None) -> xr.Dataset:
    """Return the last of the states of a case."""
    *_, last = states_of_case(config, pair, case, reference)
    return last


def wear_history(cfg: dict[str, Any]) -> xr.Dataset:
    """Return the wear history of a case, as far as it goes.

    Parameters
    ----------
    cfg : `settings`, the slice `wear_history`, and `updates`, the wear cycles after the unworn state.

    Returns
    -------
    dataset with the variables of the geometry, those of the states along `wear_cycle`, and `hindrance`: why the next
    wear cycle is not feasible, empty for a whole history. A pair without any state has `hindrance` alone.
    """
    settings, updates = cfg["settings"], cfg["updates"]
    found: list[xr.Dataset] = []
    pair, reference, reason = xr.Dataset(), xr.Dataset(), ""
    try:
        pair = geometry(settings)
        pristine = settings["cases"][settings["dynamics"]["reference_case"]]
        (cold,) = states(settings | {"case": pristine}, pair, 0)
        reference = cold[list(_MESH)].rename({name: f"reference_{name}" for name in _MESH})
        for state in states(settings, pair, updates, cold):
            found.append(state[list(_KEPT)])
    except Infeasible as error:
        reason = str(error)
    if not found:
        return xr.Dataset({"hindrance": reason})
    return xr.merge([pair, reference, _along(found)], compat="no_conflicts").assign(hindrance=reason)


def state_at(history: xr.Dataset, update: int) -> tuple[xr.Dataset, xr.Dataset]:
    """Return the mesh after a wear cycle and that of the reference, as gearwear.oscillator.excitation takes them.

    Raises
    ------
    Infeasible : the history does not reach it.
    """
    if update >= history.sizes.get("wear_cycle", 0):
        raise Infeasible(history["hindrance"].item())
    return history.sel(wear_cycle=update), history[[f"reference_{name}" for name in _MESH]].rename(
        {f"reference_{name}": name for name in _MESH}
    )


def _state(available: Mapping[str, xr.Dataset]) -> xr.Dataset:
    return together(available[name] for name in ("wear", "mesh_stiffness", "transmission_error", "backlash"))


def _along(found: Iterable[xr.Dataset]) -> xr.Dataset:
    whole = xr.concat(found, dim="wear_cycle", data_vars="all")
    return whole.assign_coords(wear_cycle=np.arange(whole.sizes["wear_cycle"]))
