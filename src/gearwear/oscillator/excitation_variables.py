"""The excitation of one state as variables of a file, and back, to the last bit."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import xarray as xr

from gearwear.geometry.involute import GEARS
from gearwear.oscillator.excitation import Excitation
from gearwear.oscillator.periodic import Harmonics, PeriodicTable
from gearwear.oscillator.translational import Bearing

DIRECTIONS = ("along", "across")  # the line of centres

_SCALARS = {
    "initial_half_backlash": "length",
    "mean_stiffness": "mean_stiffness",
    "natural_frequency": "natural_frequency",
    "mean_force": "mean_force",
    "force_parameter": "force_parameter",
    "error_amplitude": "error_amplitude",
    "reference_error_amplitude": "reference_amplitude",
    "relative_mean_error": "relative_mean_error",
    "stiffest_phase": "stiffest_phase",
}
_MEANS = {"stiffness": 1.0, "error_shape": 0.0}  # of the sums of harmonics


def columns(source: Excitation) -> dict[str, Any]:
    """Return the variables of the file; numbers that the excitation does not have (nan) are left out.

    Stiffness and error are sums of harmonics (dimension `harmonic`) or tables (dimensions `cell` and `cell_edge`); a
    clearance that does not vary has no harmonics.
    """
    scalars = {name: getattr(source, attribute) for name, attribute in _SCALARS.items()}
    values: dict[str, Any] = {name: value for name, value in scalars.items() if not np.isnan(value)}
    values["mean_clearance"] = source.clearance.mean
    waves = {"stiffness": source.stiffness, "error_shape": source.shape, "clearance": source.clearance}
    for name, wave in waves.items():
        values |= _harmonics(name, wave) if isinstance(wave, Harmonics) else _table(name, wave)
    return values | _bearings(source.bearings)


def recorded(dataset: xr.Dataset) -> Excitation:
    """Return the excitation that `columns` wrote."""
    scalars: dict[str, Any] = {attribute: float(dataset.get(name, np.nan)) for name, attribute in _SCALARS.items()}
    stiffness, shape = (_wave(dataset, name, mean) for name, mean in _MEANS.items())
    clearance = _sum(dataset, "clearance", float(dataset["mean_clearance"]))
    source = Excitation(stiffness=stiffness, shape=shape, clearance=clearance, **scalars)
    return source._replace(bearings=_recorded_bearings(dataset)) if "bearing_mass" in dataset else source


def _bearings(bearings: Mapping[str, Any]) -> dict[str, Any]:
    if not bearings:
        return {}
    both = [bearings[name] for name in GEARS]
    return {
        "gear": ("gear", np.array(GEARS, dtype=object)),
        "bearing_direction": ("bearing_direction", np.array(DIRECTIONS, dtype=object)),
        "bearing_mass": ("gear", np.array([one.mass for one in both])),
        "bearing_stiffness": (("gear", "bearing_direction"), np.array([one.stiffness for one in both])),
        "bearing_damping_ratio": ("gear", np.array([one.damping_ratio for one in both])),
        "working_pressure_angle": bearings["pressure_angle"],
    }


def _recorded_bearings(dataset: xr.Dataset) -> dict[str, Bearing | float]:
    found: dict[str, Bearing | float] = {"pressure_angle": float(dataset["working_pressure_angle"])}
    for name in GEARS:
        one = dataset.sel(gear=name)
        mass, damping_ratio = float(one["bearing_mass"]), float(one["bearing_damping_ratio"])
        found[name] = Bearing(mass, tuple(one["bearing_stiffness"].values.tolist()), damping_ratio)
    return found


def _harmonics(name: str, wave: Harmonics) -> dict[str, Any]:
    if not wave.amplitudes:
        return {}
    return {
        f"{name}_amplitude": ("harmonic", np.array(wave.amplitudes)),
        f"{name}_phase": ("harmonic", np.array(wave.phases)),
        "harmonic": ("harmonic", np.arange(1.0, len(wave.amplitudes) + 1)),
    }


def _table(name: str, wave: PeriodicTable) -> dict[str, Any]:
    return {
        "cell_edge": ("cell_edge", np.array(wave.breaks)),
        f"{name}_at_cell_start": ("cell", np.array(wave.start)),
        f"{name}_at_cell_end": ("cell", np.array(wave.end)),
    }


def _wave(dataset: xr.Dataset, name: str, mean: float) -> Harmonics | PeriodicTable:
    if f"{name}_at_cell_start" in dataset:
        table = ("cell_edge", f"{name}_at_cell_start", f"{name}_at_cell_end")
        return PeriodicTable(*(tuple(dataset[one].values) for one in table))
    return _sum(dataset, name, mean)


def _sum(dataset: xr.Dataset, name: str, mean: float) -> Harmonics:
    if f"{name}_amplitude" in dataset:
        return Harmonics(mean, *(tuple(dataset[f"{name}_{part}"].values) for part in ("amplitude", "phase")))
    return Harmonics(mean)
