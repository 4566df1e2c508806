"""Thermal growth of the flanks."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwear.geometry.involute import involute


class Growth(NamedTuple):
    """Thermal deformation of one gear, m, shape (n,) along the flank but for the base circle."""

    growth: np.ndarray
    involute_error: np.ndarray
    base_circle_growth: float


def base_circle_growth(
    shaft_rise: float, rim_rise: float, bore_radius: float, base_radius: float, thermal_expansion: float, hub: str
) -> float:
    """Return the radial growth of the base circle (m) of a disc with steady conduction from bore to base circle.

    Thermo-elastic solution in plane stress (Timoshenko and Goodier, Theory of Elasticity, ch. 13).

    Parameters
    ----------
    shaft_rise, rim_rise : temperature rise at the bore and at the base circle, K.
    bore_radius, base_radius : m.
    thermal_expansion : 1/K.
    hub : `free_bore`, bore free to move, u = l r_b (mean rise over the area); `solid_shaft`, a shaft of the same
        material and of the temperature of the bore fills it.
    """
    inner, outer = bore_radius**2, base_radius**2
    step = (rim_rise - shaft_rise) / (2 * np.log(base_radius / bore_radius))
    # mean of the temperature over the ring, from T = T_s + (T_b - T_s) ln(r/r_s)/ln(r_b/r_s)
    ring_mean = (rim_rise * outer - shaft_rise * inner) / (outer - inner) - step
    if hub == "free_bore":
        return thermal_expansion * base_radius * ring_mean
    return thermal_expansion / base_radius * (shaft_rise * inner + ring_mean * (outer - inner))


def flank_growth(
    radius_of_curvature: np.ndarray,
    base_radius: float,
    base_half_angle: float,
    rise: np.ndarray | float,
    rim_growth: float,
    thermal_expansion: float,
    mode: str,
) -> Growth:
    """Return how far a flank grows along the line of action by heat.

    The hot tooth is compared with the involute of the grown base circle (docs/model.md, thermal growth).

    Parameters
    ----------
    radius_of_curvature : of the flank at the contact, m, (n,).
    base_radius : m; base_half_angle : half tooth angle on the base circle, rad.
    rise : temperature rise of the tooth, K, (n,) or scalar.
    rim_growth : radial growth of the base circle, m.
    thermal_expansion : 1/K.
    mode : `paper`, the polar angle shrinks by l dT psi; `consistent`, the grown arc stands on the grown radius;
        `eulerian`, the shift of the flank seen at a fixed radius by a mate on fixed centres.
    """
    roll = radius_of_curvature / base_radius
    pressure = np.arctan(roll)
    radius = base_radius / np.cos(pressure)
    half = base_half_angle - involute(pressure)
    strain = thermal_expansion * np.asarray(rise)
    radial = rim_growth + strain * (radius - base_radius)
    swollen = (1 + strain) * radius / (radius + radial) - 1
    turn = half * (strain if mode == "paper" else swollen)
    hot_base = base_radius + rim_growth
    hot_pressure = np.arccos(hot_base / (radius + radial))
    error = hot_base * (involute(pressure) - turn - involute(hot_pressure))
    if mode == "eulerian":
        # at a fixed radius: half angle of the hot tooth there less the cold one, on the base circle
        shift = base_radius * (turn + np.tan(pressure) * radial / radius)
        return Growth(shift, error, rim_growth)
    thicker = 2 * radius * half * rim_growth / base_radius
    return Growth(thicker * np.cos(pressure) / 2 - error, error, rim_growth)
