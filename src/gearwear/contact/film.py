"""Thickness of the lubricant film."""

from __future__ import annotations

import numpy as np


def film_thickness(
    rolling_speed: np.ndarray,
    radius: np.ndarray,
    load_per_width: float | np.ndarray,
    contact_modulus: float | np.ndarray,
    viscosity: float | np.ndarray,
    pressure_viscosity: float | np.ndarray,
) -> np.ndarray:
    """Return the smallest film thickness (m) by Hamrock and Dowson, J. Lubr. Technol. 99 (1977), infinite ellipticity.

    h = 3.63 R U^0.68 G^0.49 L^-0.073 with U = eta u/(E' R), G = alpha E', L = F'/(E' R). A contact without load has no
    smallest film: the load is bounded below so that the result stays finite.

    Parameters
    ----------
    rolling_speed : mean surface speed, m/s.
    radius : effective radius of curvature, m.
    load_per_width : N/m.
    contact_modulus : E', Pa.
    viscosity : Pa s; pressure_viscosity : 1/Pa.
    """
    speed = viscosity * rolling_speed / (contact_modulus * radius)
    load = np.maximum(load_per_width / (contact_modulus * radius), 1e-12)
    return 3.63 * radius * speed**0.68 * (pressure_viscosity * contact_modulus) ** 0.49 * load**-0.073
