"""A wear chain as one dataset: the pair, the mesh after every wear cycle, and the reference that scales it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import xarray as xr

from gearwear.chain.geometry import geometry
from gearwear.chain.states import states
from gearwear.errors import Infeasible

_MESH = ("mesh_stiffness", "effective_stiffness", "transmission_error")
_KEPT = (*_MESH, "backlash", "initial_half_backlash", "wear_depth", "running_cycles")


def record(config: dict[str, Any], updates: int) -> xr.Dataset:
    """Return the chain of a case, as far as it goes.

    Parameters
    ----------
    config : the slice `chain`.
    updates : wear cycles after the unworn state.

    Returns
    -------
    dataset with the variables of the geometry, those of the states along `wear_cycle`, and `hindrance`: why the next
    wear cycle cannot be, empty for a whole chain. A pair without any state has the hindrance alone.
    """
    found: list[xr.Dataset] = []
    pair, reference, hindrance = xr.Dataset(), xr.Dataset(), ""
    try:
        pair = geometry(config)
        pristine = config["cases"][config["dynamics"]["reference_case"]]
        (unworn,) = states(config | {"case": pristine}, pair, 0)
        reference = unworn[list(_MESH)].rename({name: f"reference_{name}" for name in _MESH})
        for state in states(config, pair, updates, unworn):
            found.append(state[list(_KEPT)])
    except Infeasible as error:
        hindrance = str(error)
    if not found:
        return xr.Dataset({"hindrance": hindrance})
    return xr.merge([pair, reference, _along(found)], compat="no_conflicts").assign(hindrance=hindrance)


def state_at(chain: xr.Dataset, update: int) -> tuple[xr.Dataset, xr.Dataset]:
    """Return the mesh after a wear cycle and that of the reference, as gearwear.oscillator.excitation takes them.

    Raises
    ------
    Infeasible : the chain does not reach it.
    """
    if update >= chain.sizes.get("wear_cycle", 0):
        raise Infeasible(chain["hindrance"].item())
    return chain.sel(wear_cycle=update), chain[[f"reference_{name}" for name in _MESH]].rename(
        {f"reference_{name}": name for name in _MESH}
    )


def _along(found: Iterable[xr.Dataset]) -> xr.Dataset:
    whole = xr.concat(found, dim="wear_cycle", data_vars="all")
    return whole.assign_coords(wear_cycle=np.arange(whole.sizes["wear_cycle"]))
