"""Hertz line contact and lubricant film."""

from __future__ import annotations

import numpy as np


def contact_modulus(modulus: np.ndarray, poisson_ratio: np.ndarray) -> float:
    """Return E' = 2 / sum((1 - nu^2)/E) (Pa), the modulus of every dimensionless group of lubrication."""
    return 2 / float(((1 - poisson_ratio**2) / modulus).sum())


def hertz_half_width(load_per_width, radius, contact_modulus):
    """Return the half width of a Hertz line contact, sqrt(8 F' R / (pi E')) (m)."""
    return np.sqrt(8 * load_per_width * radius / (np.pi * contact_modulus))


def hertz_peak_pressure(load_per_width, radius, contact_modulus):
    """Return the largest Hertz pressure, sqrt(F' E' / (2 pi R)) (Pa)."""
    return np.sqrt(load_per_width * contact_modulus / (2 * np.pi * radius))


def film_thickness(rolling_speed, radius, load_per_width, contact_modulus, viscosity, pressure_viscosity):
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


def dynamic_viscosity(temperature: float, lubricant: dict) -> float:
    """Return the dynamic viscosity (Pa s) of the oil at `temperature` (degC).

    `fixed` gives the value of the configuration; `vogel` the law eta = A exp(B/(T + 95)) (Vogel 1921) through the
    values at 40 and 100 degC.
    """
    hot = lubricant["dynamic_viscosity"]
    if lubricant["viscosity_law"] == "fixed":
        return hot
    steepness = np.log(lubricant["dynamic_viscosity_40"] / hot) / (1 / 135 - 1 / 195)
    return float(hot * np.exp(steepness * (1 / (temperature + 95) - 1 / 195)))
