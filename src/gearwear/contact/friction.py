"""Coefficient of friction of the tooth contact from dry to full film."""

from __future__ import annotations

import numpy as np

# Xu, PhD thesis, Ohio State University (2005): b1 to b9, with pressure in GPa, speed in m/s, viscosity in mPa s,
# radius in m, roughness in um.
_B = (-8.916465, 1.03303, 1.036077, -0.354068, 2.812084, -0.100601, 0.752755, -0.390958, 0.620305)

_DRY_RATIO, _BOUNDARY_RATIO = 0.005, 0.05  # film ratios between which dry friction fades out
_FULL_FILM_RATIO = 2.0
_ROUGHEST = 2.0  # um; the regression grows doubly exponentially with the roughness


def elastohydrodynamic_friction(
    peak_pressure: np.ndarray,
    sliding_ratio: np.ndarray,
    rolling_speed: np.ndarray,
    viscosity: float | np.ndarray,
    radius: np.ndarray,
    roughness: float,
) -> np.ndarray:
    """Return the coefficient of friction of a full film: regression of Xu (2005), held beyond a roughness of 2 um.

    Parameters
    ----------
    peak_pressure : largest Hertz pressure, Pa.
    sliding_ratio : difference over mean of the surface speeds.
    rolling_speed : mean of the surface speeds, m/s.
    viscosity : dynamic, at the inlet, Pa s, above 1e-3.
    radius : effective radius of curvature, m.
    roughness : composite rms roughness, m.
    """
    pressure, slip = 1e-9 * peak_pressure, np.abs(sliding_ratio)
    inlet = 1e3 * viscosity
    strain = slip * pressure * np.log10(inlet)
    exponent = _B[0] + _B[3] * strain + _B[4] * np.exp(-strain) + _B[8] * np.exp(min(1e6 * roughness, _ROUGHEST))
    powers = pressure ** _B[1] * slip ** _B[2] * rolling_speed ** _B[5] * inlet ** _B[6] * radius ** _B[7]
    return np.exp(exponent) * powers


def friction_coefficient(
    film_ratio: np.ndarray, full_film: np.ndarray, law: str, dry: float, boundary: float
) -> np.ndarray:
    """Return the coefficient of friction at a film ratio (smallest film over composite roughness).

    Parameters
    ----------
    film_ratio : array.
    full_film : coefficient of the full film at the same places; a film rubs no harder than boundary contact.
    law : `load_sharing`, film and asperities share the load (Castro and Seabra 2007 with the function of Zhu and Hu
        2001) and dry friction sets in below film ratios of 0.05; `thresholds`, dry below 0.4, boundary to 1, mixed to
        3, full film above, joined smoothly.
    dry, boundary : coefficients of dry and of boundary contact.
    """
    film_ratio, full_film = np.asarray(film_ratio, dtype=float), np.minimum(full_film, boundary)
    if law == "load_sharing":
        share = _film_share(film_ratio)
        mixed = full_film * share**1.2 + boundary * (1 - share)
        low, high = np.log10(_DRY_RATIO), np.log10(_BOUNDARY_RATIO)
        wet = _smoothstep((np.log10(np.maximum(film_ratio, 1e-12)) - low) / (high - low))
        return (1 - wet) * dry + wet * mixed
    lubricated = _smoothstep((film_ratio - 0.2) / 0.2)
    filmed = _smoothstep((film_ratio - 1.0) / 2.0)
    return dry + (boundary - dry) * lubricated + (full_film - boundary) * filmed


def _film_share(film_ratio: np.ndarray) -> np.ndarray:
    """Return the part of the load that the film carries, 1 from a film ratio of 2 on."""

    def raw(ratio: float | np.ndarray) -> np.ndarray:
        return 1.21 * ratio**0.64 / (1 + 0.37 * ratio**1.26)

    share = raw(np.minimum(film_ratio, _FULL_FILM_RATIO)) / raw(_FULL_FILM_RATIO)
    return np.minimum(share, 1.0)


def _smoothstep(x: np.ndarray) -> np.ndarray:
    x = np.clip(x, 0.0, 1.0)
    return x * x * (3 - 2 * x)
