"""Motion classes over the mesh frequency, computed from rest or carried on from a neighbour."""

from __future__ import annotations

from typing import Any

import numpy as np

from gearwear.integrate.strobe import AUTOMATIC, GROWTH
from gearwear.motions.settling import Settling, settle_many
from gearwear.motions.start import rest_state
from gearwear.motions.sweep import carried
from gearwear.oscillator.excitation import Excitation


def from_rest(
    source: Excitation,
    dynamics: dict[str, Any],
    settling: Settling,
    values: np.ndarray,
    tolerance: float | None = None,
    backend: str = AUTOMATIC,
) -> np.ndarray:
    """Return the motion classes at mesh frequencies, every motion from the start that `dynamics` gives.

    Parameters
    ----------
    source : excitation of the state of the pair.
    dynamics : the section of that name.
    values : (points,) mesh frequencies over the natural one.
    tolerance : of the integrator; that of `dynamics` if None.
    backend : as in motion.strobe.
    """
    if not len(values):
        return np.zeros(0, dtype=int)
    accuracy = dynamics["tolerance"] if tolerance is None else tolerance
    oscillators = [source.oscillator(dynamics, float(value)) for value in values]
    starts = np.array([rest_state(source, oscillator, dynamics) for oscillator in oscillators])
    motions = settle_many(oscillators, starts, settling, accuracy, GROWTH, backend)
    return np.array([motion.motion_class for motion in motions])


def carried_on(
    source: Excitation,
    dynamics: dict[str, Any],
    settling: Settling,
    values: np.ndarray,
    state: tuple[float, float],
    order: str,
) -> np.ndarray:
    """Return the same for motions each from where its neighbour ended; the first one, in the order, from `state`.

    Parameters
    ----------
    values : (points,) mesh frequencies, ascending.
    order : up or down.
    """
    along = slice(None, None, -1 if order == "down" else 1)
    oscillators = [source.oscillator(dynamics, float(value)) for value in values[along]]
    motions = carried(oscillators, lambda _: state, settling, dynamics["tolerance"])
    return np.array([motion.motion_class for motion in motions], dtype=int)[along]
