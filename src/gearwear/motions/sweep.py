"""Sweeps: the settled motion at every value of a parameter, from rest or by continuation."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np
import xarray as xr

from gearwear.codes.onset_codes import ORDERS
from gearwear.integrate.status import RECORDS
from gearwear.integrate.strobe import AUTOMATIC
from gearwear.motions.motion_variables import columns, end_of
from gearwear.motions.settling import Attractor, Settling, settle, settle_many
from gearwear.motions.start import rest_state
from gearwear.oscillator.excitation import Excitation, SweptOscillator
from gearwear.oscillator.oscillator import Oscillator

RESTART, UP, DOWN = ORDERS
_AT_ONCE = 512  # motions whose histories are in memory together


def sweep(swept: SweptOscillator, values: np.ndarray, settling: Settling, direction: str = RESTART) -> xr.Dataset:
    """Return the settled motions over a swept quantity.

    Parameters
    ----------
    swept : oscillator by the swept quantity.
    values : (points,) of the swept quantity, ascending.
    direction : RESTART, every motion starts from rest; UP or DOWN, with continuation from the first or the last value.

    Returns
    -------
    xarray.Dataset
        The variables of motion_variables.columns along `point`, with the values, in their order.
    """
    oscillators = [swept.at(value) for value in values]
    if direction == RESTART:
        motions = settle_from_rest(swept.source, oscillators, swept.dynamics, settling)
    else:

        def rest(oscillator: Any) -> Any:
            return rest_state(swept.source, oscillator, swept.dynamics)

        motions = settle_by_continuation(oscillators, rest, settling, swept.dynamics["tolerance"], direction)
    table = columns(motions, settling.sampled_periods, swept.source.force_parameter)
    return xr.Dataset(table, {swept.quantity: ("point", np.asarray(values, dtype=float))})


def settle_from_rest(
    source: Excitation,
    oscillators: Sequence[Oscillator],
    dynamics: dict[str, Any],
    settling: Settling,
    *,
    tolerance: float | None = None,
    detail: int = RECORDS,
    backend: str = AUTOMATIC,
) -> list[Attractor]:
    """Return the motion that each oscillator settles to from rest.

    Parameters
    ----------
    source : excitation that the oscillators have in common.
    dynamics : the section of that name; it gives the start, see start.rest_state.
    tolerance : of the integrator; that of `dynamics` if None.
    detail, backend : as in settling.settle_many.
    """
    accuracy = dynamics["tolerance"] if tolerance is None else tolerance
    motions: list[Attractor] = []
    for first in range(0, len(oscillators), _AT_ONCE):
        part = list(oscillators[first : first + _AT_ONCE])
        starts = np.array([rest_state(source, oscillator, dynamics) for oscillator in part])
        motions += settle_many(part, starts, settling, accuracy, detail, backend)
    return motions


def settle_by_continuation(
    oscillators: Iterable[Oscillator],
    rest: Callable[[Oscillator], tuple[float, ...]],
    settling: Settling,
    tolerance: float = 1e-10,
    direction: str = UP,
) -> list[Attractor]:
    """Return the motion of each oscillator, started from the final state of the one before it.

    The first motion starts from rest, and so does one after a motion without a finite final state.

    Parameters
    ----------
    oscillators : in ascending order of the parameter.
    rest : state at mesh phase 0 from which an oscillator starts at rest.
    settling, tolerance : as in settling.settle.
    direction : UP, or DOWN to begin with the last oscillator; the motions are returned in the order of the oscillators.
    """
    ordered = list(oscillators)[:: -1 if direction == DOWN else 1]
    motions: list[Attractor] = []
    state = None
    for oscillator in ordered:
        motion = settle(oscillator, rest(oscillator) if state is None else state, settling, tolerance)
        motions.append(motion)
        state = end_of(motion) if np.isfinite(end_of(motion)).all() else None
    return motions[:: -1 if direction == DOWN else 1]
