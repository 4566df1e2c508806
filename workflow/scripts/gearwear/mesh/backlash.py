"""Half backlash along the path of one pair."""

from __future__ import annotations

import math

import numpy as np


def half_backlash(
    initial: float,
    deflection: np.ndarray,
    wear: np.ndarray,
    growth: np.ndarray,
    working_pressure_angle: float,
    projection: str,
) -> np.ndarray:
    """Return the half clearance b of the backlash function along the path (m), shape (n,).

    2 b = 2 b0 + (delta + H - Delta) cos 2 alpha: deflection and wear of the drive flanks open the gap, growth of the
    four flanks closes it; the projection on the back side after Shi, Gou and Zhu, Mech. Mach. Theory 134 (2019).

    Parameters
    ----------
    initial : b0 (m), half of the initial backlash.
    deflection : elastic deflection of the pair (m), shape (n,).
    wear, growth : wear depth and growth per flank (m), shape (2, n).
    working_pressure_angle : rad.
    projection : `shi`, factor cos 2 alpha; `exact`, factor 1, the fixed-shaft kinematics.

    Raises
    ------
    ValueError : the teeth jam, b is not positive somewhere.
    """
    factor = math.cos(2 * working_pressure_angle) if projection == "shi" else 1.0
    change = deflection + wear.sum(axis=0) - 2 * growth.sum(axis=0)
    clearance = initial + factor * change / 2
    if clearance.min() <= 0:
        raise ValueError(
            f"the teeth jam: the half backlash falls to {1e6 * clearance.min():.3f} um, it must stay above 0 um; the "
            f"growth of the four flanks takes up to {2e6 * growth.sum(axis=0).max():.3f} um of the total gap: increase "
            f"backlash.half_backlash ({1e6 * initial:g} um) or lower the bulk temperature"
        )
    return clearance
