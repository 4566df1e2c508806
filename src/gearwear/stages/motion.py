"""Stages of the oscillator: excitation, sweeps, branches, portraits, motions, basins."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.errors import BadFile, ConfigError
from gearwear.io.store import together
from gearwear.motions.basin_variables import basins_along
from gearwear.motions.basins import cell_centres
from gearwear.motions.settling import Settling
from gearwear.motions.sweep import DOWN, RESTART, UP
from gearwear.motions.sweep import sweep as swept_motions
from gearwear.motions.trace import portraits as settled_portraits
from gearwear.motions.trace import steady_motions
from gearwear.orbits.branch_variables import columns as branch_columns
from gearwear.orbits.continuation import Limits
from gearwear.orbits.seeds import branches_of_sweeps
from gearwear.oscillator.excitation import SweptOscillator
from gearwear.oscillator.excitation import excitation as excitation_of
from gearwear.oscillator.excitation_variables import columns, recorded
from gearwear.oscillator.prescribed import given_excitation


def excitation(
    cfg: dict[str, Any],
    geometry: xr.Dataset,
    mesh_stiffness: xr.Dataset,
    transmission_error: xr.Dataset,
    backlash: xr.Dataset,
    reference_stiffness: xr.Dataset,
    reference_error: xr.Dataset,
) -> xr.Dataset:
    """Return all that the oscillator takes from a state of the pair."""
    state = together([mesh_stiffness, transmission_error, backlash])
    reference = together([reference_stiffness, reference_error])
    source = excitation_of(geometry, state, reference, cfg["operation"]["pinion_torque"], cfg["dynamics"])
    return xr.Dataset(columns(source))


def prescribed_excitation(cfg: dict[str, Any], case: str) -> xr.Dataset:
    """Return the excitation of an oscillator that the configuration gives by its equation."""
    return xr.Dataset(columns(given_excitation(cfg["oscillators"][case])))


def sweep_part(cfg: dict[str, Any], excitation: xr.Dataset, sweep: str, part: slice) -> xr.Dataset:
    """Return a part of the points of a sweep from rest."""
    swept, settling = _swept(cfg, excitation, sweep)
    return swept_motions(swept, _values(swept)[part], settling)


def sweep(cfg: dict[str, Any], excitation: xr.Dataset, parts: list[xr.Dataset], sweep: str) -> dict[str, xr.Dataset]:
    """Return a sweep from rest (`restart`) and with continuation up and down.

    Parameters
    ----------
    parts : of the sweep from rest, where other jobs have computed it; empty to compute it here.

    Raises
    ------
    BadFile : the parts are not those of the sweep.
    """
    swept, settling = _swept(cfg, excitation, sweep)
    values = _values(swept)
    restart = _joined(parts, sweep, len(values)) if parts else swept_motions(swept, values, settling)
    return {RESTART: restart} | {way: swept_motions(swept, values, settling, way) for way in (UP, DOWN)}


def branches(cfg: dict[str, Any], excitation: xr.Dataset, sweeps: list[xr.Dataset], sweep: str) -> xr.Dataset:
    """Return the branches of periodic orbits that the motions of the sweeps lie on."""
    swept = _swept_oscillator(cfg, excitation, sweep)
    settings, ends = cfg["branches"], swept.settings
    limits = Limits(ends["first"], ends["last"], settings["largest_step"], most_nodes=settings["most_nodes"])
    found = branches_of_sweeps(swept, sweeps, limits, settings["largest_period"])
    return xr.Dataset(branch_columns(found, settings["largest_period"], sweep)).set_coords(sweep)


def portraits(cfg: dict[str, Any], excitation: xr.Dataset, sweep: str, case: str) -> xr.Dataset:
    """Return phase portraits at the values that the configuration lists."""
    swept, settling = _swept(cfg, excitation, sweep)
    return settled_portraits(swept, np.array(cfg["portraits"][sweep][case]), settling)


def motions(cfg: dict[str, Any], excitation: xr.Dataset, points: xr.Dataset, sweep: str) -> xr.Dataset:
    """Return the steady motion at every point of a sweep."""
    return steady_motions(_swept_oscillator(cfg, excitation, sweep), points)


def basins(cfg: dict[str, Any], excitation: xr.Dataset, sweep: str, case: str) -> xr.Dataset:
    """Return the basins of attraction at the values that the configuration lists.

    Raises
    ------
    ConfigError : the list is empty.
    """
    wanted = cfg["basins"]
    values = np.array(wanted["points"][sweep][case])
    if not values.size:
        raise ConfigError(f"basins.points.{sweep}.{case}: an empty list; give at least one value")
    displacement, velocity = (
        cell_centres(wanted[name]["first"], wanted[name]["last"], wanted["resolution"])
        for name in ("displacement", "velocity")
    )
    swept, settling = _swept(cfg, excitation, sweep)
    return basins_along(swept, values, displacement, velocity, settling)


def _swept_oscillator(cfg: dict[str, Any], excitation: xr.Dataset, sweep: str) -> SweptOscillator:
    return SweptOscillator(recorded(excitation), sweep, cfg["dynamics"], cfg["sweeps"][sweep])


def _swept(cfg: dict[str, Any], excitation: xr.Dataset, sweep: str) -> tuple[SweptOscillator, Settling]:
    return _swept_oscillator(cfg, excitation, sweep), Settling(**cfg["settling"])


def _values(swept: SweptOscillator) -> np.ndarray:
    return np.linspace(swept.settings["first"], swept.settings["last"], swept.settings["points"])


def _joined(parts: list[xr.Dataset], sweep: str, points: int) -> xr.Dataset:
    whole = xr.concat([part for part in parts if part.sizes["point"]], dim="point").sortby(sweep)
    if whole.sizes["point"] != points or (np.diff(whole[sweep].values) <= 0).any():
        raise BadFile(
            f"{sweep}: the parts hold {whole.sizes['point']} points, {points} different ones are wanted; delete the "
            "folder of the parts and run the workflow again"
        )
    return whole
