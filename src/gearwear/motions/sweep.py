"""Settled motions one after another, each from where the one before ended."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np

from gearwear.motions.motion_variables import end_of
from gearwear.motions.settling import Attractor, Settling, settle
from gearwear.oscillator.oscillator import Oscillator


def carried(
    oscillators: Iterable[Oscillator],
    rest: Callable[[Oscillator], tuple[float, ...]],
    settling: Settling,
    tolerance: float = 1e-10,
) -> list[Attractor]:
    """Return the motion of every oscillator, in their order, as a slowly turned knob would show them.

    The first starts from rest, and so does one after a motion without a finite end.

    Parameters
    ----------
    rest : state at mesh phase 0 to start an oscillator from.
    settling, tolerance : as in settling.settle.
    """
    motions, begin = [], None
    for oscillator in oscillators:
        motion = settle(oscillator, rest(oscillator) if begin is None else begin, settling, tolerance)
        motions.append(motion)
        begin = end_of(motion) if np.isfinite(end_of(motion)).all() else None
    return motions
