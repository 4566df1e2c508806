"""Which speeds are safe: intervals of the classes of motion, and where a motion first leaves period 1 or contact."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import xarray as xr

from gearwear.codes.motion_class import class_name
from gearwear.motions.sequence import runs


class Limit(NamedTuple):
    """Up to where something holds: mesh frequency over the natural one, speed of the pinion (rpm), the whole sweep.

    Both nan where it holds nowhere.
    """

    ratio: float
    speed: float
    everywhere: bool


class Peak(NamedTuple):
    """The largest mesh force over the mean one, and where: ratio and speed (rpm)."""

    force: float
    ratio: float
    speed: float


def intervals(one: xr.Dataset, order: str) -> list[tuple[str, float, float, float, float]]:
    """Return class, first and last ratio, first and last speed (rpm) of every run of one class along the sweep.

    Parameters
    ----------
    one : outcome of a member.
    order : of the sweep.
    """
    ratio, speed = one["mesh_frequency"].values, one["pinion_speed"].values
    found = runs(one["motion_class"].sel(order=order).values)
    return [
        (class_name(code), float(ratio[a]), float(ratio[b]), float(speed[a]), float(speed[b])) for code, a, b in found
    ]


def period_one_limit(one: xr.Dataset) -> Limit:
    """Return up to where every motion has period 1, from rest and from both neighbours."""
    return _limit(one, (one["motion_class"].values == 1).all(axis=0))


def contact_limit(one: xr.Dataset) -> Limit:
    """Return up to where no motion loses contact, from rest and from both neighbours."""
    return _limit(one, (one["contact_loss_share"].values == 0).all(axis=0))


def peak(one: xr.Dataset) -> Peak:
    """Return the largest mesh force over the sweep in all its orders."""
    force = one["force_max"].values
    if not np.isfinite(force).any():
        return Peak(np.nan, np.nan, np.nan)
    point = int(np.nanargmax(force)) % force.shape[1]
    return Peak(
        float(np.nanmax(force)), *(float(one[name].values[point]) for name in ("mesh_frequency", "pinion_speed"))
    )


def _limit(one: xr.Dataset, holds: np.ndarray) -> Limit:
    last = len(holds) - 1 if holds.all() else int(np.argmin(holds)) - 1
    if last < 0:
        return Limit(np.nan, np.nan, False)
    ratio, speed = (float(one[name].values[last]) for name in ("mesh_frequency", "pinion_speed"))
    return Limit(ratio, speed, bool(holds.all()))
