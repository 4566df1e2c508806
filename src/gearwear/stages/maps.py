"""Stages of the maps: motions over the mesh frequency and a second parameter or a state of the pair."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.chain.history import state_at
from gearwear.errors import BadFile, ConfigError, Infeasible
from gearwear.io.store import together
from gearwear.motions import parameter_map
from gearwear.oscillator.excitation import excitation, swept_oscillator
from gearwear.run.stage import log


def map_tile(
    cfg: dict[str, Any],
    geometry: xr.Dataset,
    mesh_stiffness: xr.Dataset | list[xr.Dataset],
    transmission_error: xr.Dataset | list[xr.Dataset],
    backlash: xr.Dataset | list[xr.Dataset],
    reference_stiffness: xr.Dataset,
    reference_error: xr.Dataset,
    wear: list[xr.Dataset],
    map: str,
    part: slice,
) -> xr.Dataset:
    """Return some rows of the map over the transmission error or the backlash of one state, or over states of wear.

    Parameters
    ----------
    mesh_stiffness, transmission_error, backlash, wear : of the state that all rows share, or of every row.
    map : `ste`, `backlash` or `wear`.
    part : of the rows.
    """
    dynamics, torque = cfg["dynamics"], cfg["operation"]["pinion_torque"]
    frequencies = parameter_map.values(cfg["maps"]["mesh_frequency"])
    reference = together([reference_stiffness, reference_error])
    if map == "wear":
        rows = np.array([float(one["running_cycles"]) for one in wear])
    else:
        rows = parameter_map.values(cfg["maps"][map])
        rows = rows[part]

    def row(place: int, value: Any) -> Any:
        parts = (
            one if isinstance(one, xr.Dataset) else one[place] for one in (mesh_stiffness, transmission_error, backlash)
        )
        source = excitation(geometry, together(parts), reference, torque, dynamics)
        if map == "wear":
            return source, [source.oscillator(dynamics, one) for one in frequencies]
        swept = cfg.get("sweeps", {}).get(map, {})
        settings = [swept | {"mesh_frequency": one} for one in frequencies]
        return source, [swept_oscillator(source, map, value, dynamics, one) for one in settings]

    log.info("%d rows of the map over %s", len(rows), map)
    return parameter_map.tile(map, rows, frequencies, (row(*one) for one in enumerate(rows)), cfg)


def temperature_map_tile(cfg: dict[str, Any], histories: list[xr.Dataset], part: slice) -> xr.Dataset:
    """Return some rows of the map over the bulk temperature.

    Parameters
    ----------
    cfg : `map`, the slice `temperature_map_tile`, and `updates`, the wear cycles of the case.
    histories : wear history of every row.

    Raises
    ------
    ConfigError : the history of a row does not reach the last wear cycle.
    """
    settings = cfg["map"]
    dynamics, maps = settings["dynamics"], settings["maps"]
    frequencies, rows = parameter_map.values(maps["mesh_frequency"]), parameter_map.values(maps["temperature"])
    rows = rows[part]

    def row(history: Any, temperature: Any) -> Any:
        try:
            state, reference = state_at(history, cfg["updates"])
        except Infeasible as error:
            message = f"maps.temperature: {temperature:g} degC is not possible: {error}; take it out"
            raise ConfigError(message) from None
        source = excitation(history, state, reference, settings["operation"]["pinion_torque"], dynamics)
        return source, [source.oscillator(dynamics, one) for one in frequencies]

    log.info("%d rows of the map over the bulk temperature", len(rows))
    found = (row(*one) for one in zip(histories, rows, strict=True))
    return parameter_map.tile("temperature", rows, frequencies, found, settings)


def map(tiles: list[xr.Dataset], map: str) -> xr.Dataset:
    """Return a map from its tiles.

    Raises
    ------
    BadFile : two tiles hold the same row.
    """
    coordinate = parameter_map.COORDINATES[map]
    whole = xr.concat([tile for tile in tiles if tile.sizes["row"]], dim="row").sortby(coordinate)
    if (np.diff(whole[coordinate].values) <= 0).any():
        raise BadFile(f"{coordinate}: two tiles hold the same row; delete the folder of the tiles and start again")
    return whole
