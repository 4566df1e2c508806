"""Compliance of the gear body below the tooth."""

from __future__ import annotations

import numpy as np

# Sainsot, Velex and Duverger, J. Mech. Des. 126 (2004); coefficients as in Chaari et al., Eur. J. Mech. A 28 (2009).
# Rows L*, M*, P*, Q*; columns A to F of X = A/t^2 + B h^2 + C h/t + D/t + E h + F.
_COEFFICIENTS = np.array(
    [
        [-5.574e-5, -1.9986e-3, -2.3015e-4, 4.7702e-3, 0.0271, 6.8045],
        [60.111e-5, 28.100e-3, -83.431e-4, -9.9256e-3, 0.1624, 0.9086],
        [-50.952e-5, 185.50e-3, 0.0538e-4, 53.300e-3, 0.2895, 0.9236],
        [-6.2042e-5, 9.0889e-3, -4.0964e-4, 7.8297e-3, -0.1472, 0.6904],
    ]
)
RADIUS_RATIO_RANGE = (1.4, 7.0)  # root over bore radius, of the fit
ROOT_ANGLE_RANGE = (0.01, 0.12)  # rad, of the fit


def foundation_factors(root_over_bore: float, root_angle: float) -> np.ndarray:
    """Return L*, M*, P*, Q* (dimensionless) for a root-to-bore ratio and half tooth angle at the root (rad)."""
    h, t = root_over_bore, root_angle
    return _COEFFICIENTS @ np.array([1 / t**2, h**2, h / t, 1 / t, h, 1.0])


def foundation_compliance(
    load_angles: np.ndarray, base_radius: float, root_radius: float, bore_radius: float, root_angle: float
) -> np.ndarray:
    """Return the compliance of the body times E B (dimensionless), shape (n,).

    1/k_f = cos^2 a1 / (E B) {L* (u/S)^2 + M* u/S + P* (1 + Q* tan^2 a1)} with u = r_b/cos a1 - r_f from the root circle
    to the point where the line of action crosses the tooth axis and S = 2 r_f theta_f (Sainsot et al. 2004, Eq. 5).

    Parameters
    ----------
    load_angles : a1 (rad), shape (n,).
    base_radius, root_radius, bore_radius : m.
    root_angle : half tooth angle at the root circle (rad).
    """
    l_star, m_star, p_star, q_star = foundation_factors(root_radius / bore_radius, root_angle)
    depth = (base_radius / np.cos(load_angles) - root_radius) / (2 * root_radius * root_angle)
    bracket = l_star * depth**2 + m_star * depth + p_star * (1 + q_star * np.tan(load_angles) ** 2)
    return np.cos(load_angles) ** 2 * bracket
