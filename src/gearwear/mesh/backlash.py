"""Half backlash along the path of one pair."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from gearwear.errors import Infeasible
from gearwear.geometry.involute import involute


def half_backlash(
    initial: float,
    deflection: np.ndarray,
    removed: np.ndarray,
    growth: np.ndarray,
    working_pressure_angle: float,
    projection: str,
    opening: float = 0.0,
) -> np.ndarray:
    """Return the half clearance b of the backlash function along the path (m), shape (n,).

    2 b = 2 b0 + (delta + H - Delta) cos 2 alpha: deflection of the drive flanks and what is removed from them open the
    gap, growth of the four flanks closes it; the projection on the back side after Shi, Gou and Zhu, Mech. Mach. Theory
    134 (2019).

    Parameters
    ----------
    initial : b0 (m), half of the initial backlash.
    deflection : elastic deflection of the pair (m), shape (n,).
    removed, growth : wear and relief, and growth, per flank (m), shape (2, n).
    working_pressure_angle : rad.
    projection : `shi`, factor cos 2 alpha; `exact`, factor 1, the fixed-shaft kinematics.
    opening : half the gap that a change of the centre distance opens (m), see `opened`.

    Raises
    ------
    Infeasible : the teeth jam, b is not positive somewhere.
    """
    factor = math.cos(2 * working_pressure_angle) if projection == "shi" else 1.0
    change = deflection + removed.sum(axis=0) - 2 * growth.sum(axis=0)
    clearance = initial + opening + factor * change / 2
    if clearance.min() <= 0:
        raise Infeasible(
            f"the teeth jam: the half backlash falls to {1e6 * clearance.min():.3f} um, it must stay above 0 um; the "
            f"growth of the four flanks takes up to {2e6 * growth.sum(axis=0).max():.3f} um of the total gap: increase "
            f"backlash.half_backlash ({1e6 * initial:g} um) or lower the bulk temperature{_closed(opening)}"
        )
    return clearance


def centre_distance_change(centre_distance: float, rise: float, mounting: float, housing: dict[str, Any]) -> float:
    """Return how far the shafts move apart by mounting and by heat of the housing (m).

    Parameters
    ----------
    centre_distance : m.
    rise : of the bulk temperature above that without growth, K.
    mounting : m.
    housing : `thermal_expansion` (1/K) and `temperature_rise`, over that of the gears.
    """
    return mounting + housing["thermal_expansion"] * housing["temperature_rise"] * rise * centre_distance


def opened(change: float, centre_distance: float, base_radius: np.ndarray) -> float:
    """Return the half gap (m, along the line of action) that a change of the centre distance opens.

    delta b = (r_bp + r_bg) (inv alpha_2 - inv alpha_1), cos alpha_i = (r_bp + r_bg)/a_i: exact for involutes (ISO
    21771); to first order delta a sin alpha.

    Parameters
    ----------
    change : of the centre distance, m.
    centre_distance : m, before the change.
    base_radius : of pinion and gear, m, shape (2,).

    Raises
    ------
    Infeasible : the base circles would run into each other.
    """
    base = float(np.sum(base_radius))
    if centre_distance + change <= base:
        raise Infeasible(
            f"backlash.centre_distance_change: with {1e6 * change:g} um the centre distance is not above the sum of "
            f"the base radii, {1e3 * base:.4f} mm; give more than {1e6 * (base - centre_distance):.0f} um"
        )
    before, after = (involute(math.acos(base / a)) for a in (centre_distance, centre_distance + change))
    return float(base * (after - before))


def _closed(opening: float) -> str:
    if opening >= 0:
        return ""
    return f", or raise backlash.centre_distance_change, which takes {-2e6 * opening:.3f} um of the total gap"
