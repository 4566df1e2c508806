"""Seeds of branches among the settled motions of sweeps, and the branches that they lead to."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import xarray as xr

from gearwear.codes.motion_class import LARGEST_PERIOD
from gearwear.orbits.branches import Branch, Seed, explore
from gearwear.orbits.continuation import Limits
from gearwear.orbits.return_map import COARSEST, return_maps
from gearwear.oscillator.excitation import SweptOscillator


def seeds(
    values: Any,
    motion_class: np.ndarray,
    transient_periods: np.ndarray,
    displacement: np.ndarray,
    velocity: np.ndarray,
    largest_period: int,
) -> list[Seed]:
    """Return a seed at every point of a sweep whose motion is periodic, so that no attractor is without its branch.

    The state is one at a whole number of periods of the orbit after the start, so that
    an external torque of another frequency has its phase of mesh period 0 there.

    Parameters
    ----------
    values : (points,) of the swept quantity.
    motion_class : (points,) codes; that of a periodic motion is its period.
    transient_periods : (points,) mesh periods before the section.
    displacement, velocity : (points, samples) the section.
    largest_period : longest period taken.
    """
    found = []
    for i, period in enumerate(np.asarray(motion_class, dtype=int)):
        if not 1 <= period <= min(largest_period, LARGEST_PERIOD):
            continue
        over = (int(transient_periods[i]) + np.shape(displacement)[1]) % period
        state = (float(displacement[i][-1 - over]), float(velocity[i][-1 - over]))
        found.append(Seed(float(values[i]), state, int(period)))
    return found


def seeds_along(sweep: xr.Dataset, swept: str, largest_period: int) -> list[Seed]:
    """Return the seeds of a sweep as its stage writes it; `swept` names the quantity along it."""
    names = "motion_class", "transient_periods", "section_displacement", "section_velocity"
    motion_class, transient_periods, displacement, velocity = (sweep[name].values for name in names)
    return seeds(sweep[swept].values, motion_class, transient_periods, displacement, velocity, largest_period)


def branches_of_sweeps(
    swept: SweptOscillator, sweeps: Iterable[xr.Dataset], limits: Limits, largest_period: int
) -> list[Branch]:
    """Return the branches that the periodic motions of sweeps lie on, with those that their doublings give rise to.

    Parameters
    ----------
    swept : oscillator by the swept quantity.
    sweeps : over that quantity, as sweep.sweep returns them.
    limits : how far and how finely branches are followed.
    largest_period : longest period of an orbit, in mesh periods.
    """
    found = [
        seed
        for along in sweeps
        for seed in seeds_along(along, swept.quantity, largest_period)
        if swept.at(seed.value).torque.repeats_after(seed.period)
    ]
    maps = return_maps(swept.at, min(swept.dynamics["tolerance"], COARSEST))
    return explore(maps, found, limits, largest_period)
