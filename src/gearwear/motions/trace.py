"""Orbits traced in time: phase portraits, and the steady motion at every point of a sweep with its mesh force."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr

from gearwear.integrate.strobe import trace
from gearwear.motions.motion_variables import columns, end_of
from gearwear.motions.settling import Settling
from gearwear.motions.sweep import settle_from_rest
from gearwear.oscillator.excitation import SweptOscillator, restoring_force
from gearwear.oscillator.oscillator import Oscillator

STEPS = 128  # points of an orbit per mesh period
PHASES = np.arange(STEPS) / STEPS
LONGEST_PORTRAIT = 80  # mesh periods of a portrait whose motion does not repeat
LONGEST_MOTION = 10  # mesh periods of a motion of a sweep, at most


def portraits(swept: SweptOscillator, values: np.ndarray, settling: Settling) -> xr.Dataset:
    """Return phase portraits: the motions settled from rest at values of a swept quantity, each over one period.

    A motion that does not repeat is traced over LONGEST_PORTRAIT mesh periods. A motion that was lost has no orbit.

    Parameters
    ----------
    swept : oscillator by the swept quantity.
    values : (points,) of the swept quantity.

    Returns
    -------
    xarray.Dataset
        The variables of motion_variables.columns along `point`; `orbit_displacement` and `orbit_velocity` along
        (`point`, `time`), over b0 and the velocity unit, NaN after their end; `orbit_period`, time in mesh periods.
    """
    oscillators = [swept.at(value) for value in values]
    motions = settle_from_rest(swept.source, oscillators, swept.dynamics, settling)
    orbits = _unknown(2, len(values), LONGEST_PORTRAIT)
    for i, (oscillator, motion) in enumerate(zip(oscillators, motions, strict=True)):
        reached = motion.transient_periods + settling.sampled_periods
        periods = motion.period or LONGEST_PORTRAIT
        _trace(orbits[:, i], oscillator, end_of(motion), periods, reached, swept.dynamics["tolerance"])
    table = columns(motions, settling.sampled_periods, swept.source.force_parameter)
    return _dataset(table, ("displacement", "velocity"), orbits, swept.quantity, values).reset_coords("orbit_period")


def steady_motions(swept: SweptOscillator, sweep: xr.Dataset) -> xr.Dataset:
    """Return the steady motion at every point of a sweep, over one period but LONGEST_MOTION mesh periods at most.

    Parameters
    ----------
    swept : oscillator by the swept quantity.
    sweep : over that quantity, as sweep.sweep returns it.

    Returns
    -------
    xarray.Dataset
        `orbit_displacement`, `orbit_velocity` and `orbit_force` along (`point`, `time`), the force over the mean
        force; `orbit_period`, time in mesh periods; `natural_frequency` where it is known, rad/s.
    """
    values, source = sweep[swept.quantity].values, swept.source
    ends = np.stack([sweep[f"section_{name}"].values[:, -1] for name in ("displacement", "velocity")], axis=-1)
    reached = sweep["transient_periods"].values + sweep.sizes["sample"]
    orbits = _unknown(3, len(values), LONGEST_MOTION)
    for i, (value, period) in enumerate(zip(values, sweep["period"].values, strict=True)):
        periods, oscillator = min(int(period) or LONGEST_MOTION, LONGEST_MOTION), swept.at(value)
        _trace(orbits[:, i], oscillator, ends[i], periods, int(reached[i]), swept.dynamics["tolerance"])
    orbits[2] /= source.force_parameter
    known = {"natural_frequency": source.natural_frequency} if np.isfinite(source.natural_frequency) else {}
    return _dataset(known, ("displacement", "velocity", "force"), orbits, swept.quantity, values)


def _trace(
    orbits: np.ndarray,
    oscillator: Oscillator,
    state: Sequence[float] | np.ndarray,
    periods: int,
    first_period: int,
    tolerance: float,
) -> Any:
    """Write displacement, velocity and, in a third row, the mesh force of a motion over some mesh periods.

    Nothing is written for a state that is not finite.
    """
    if np.isnan(state[0]):
        return
    displacement, velocity = trace(oscillator, state, PHASES, periods + 1, first_period, tolerance)
    force = [restoring_force(oscillator, PHASES, displacement)] if len(orbits) > 2 else []
    for orbit, run in zip(orbits, (displacement, velocity, *force), strict=True):
        orbit[: periods * STEPS + 1] = run.ravel()[: periods * STEPS + 1]


def _unknown(kinds: int, points: int, longest: int) -> np.ndarray:
    return np.full((kinds, points, longest * STEPS + 1), np.nan)


def _dataset(
    table: dict[str, Any], kinds: tuple[str, ...], orbits: np.ndarray, quantity: str, values: Any
) -> xr.Dataset:
    table |= {f"orbit_{kind}": (("point", "time"), orbit) for kind, orbit in zip(kinds, orbits, strict=True)}
    time = np.arange(orbits.shape[-1]) / STEPS
    return xr.Dataset(table, {quantity: ("point", np.asarray(values, dtype=float)), "orbit_period": ("time", time)})
