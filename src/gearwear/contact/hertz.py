"""Hertz line contact."""

from __future__ import annotations

import numpy as np


def contact_modulus(modulus: np.ndarray, poisson_ratio: np.ndarray) -> float:
    """Return E' = 2 / sum((1 - nu^2)/E) (Pa), the modulus of every dimensionless group of lubrication."""
    return 2 / float(((1 - poisson_ratio**2) / modulus).sum())


def hertz_half_width(
    load_per_width: float | np.ndarray, radius: np.ndarray, contact_modulus: float | np.ndarray
) -> np.ndarray:
    """Return the half width of a Hertz line contact, sqrt(8 F' R / (pi E')) (m)."""
    return np.sqrt(8 * load_per_width * radius / (np.pi * contact_modulus))


def hertz_peak_pressure(
    load_per_width: float | np.ndarray, radius: np.ndarray, contact_modulus: float | np.ndarray
) -> np.ndarray:
    """Return the largest Hertz pressure, sqrt(F' E' / (2 pi R)) (Pa)."""
    return np.sqrt(load_per_width * contact_modulus / (2 * np.pi * radius))
