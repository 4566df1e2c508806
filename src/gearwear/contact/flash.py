"""Flash temperature of the tooth contact."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from gearwear.contact.film import film_thickness
from gearwear.contact.friction import elastohydrodynamic_friction, friction_coefficient
from gearwear.contact.hertz import contact_modulus, hertz_half_width, hertz_peak_pressure


class ContactHeat(NamedTuple):
    """What heats the contact, shape (n,) each: K, 1, 1, m, N/m."""

    flash_temperature: np.ndarray
    friction_coefficient: np.ndarray
    film_ratio: np.ndarray
    hertz_half_width: np.ndarray
    load_per_width: np.ndarray


def flash_temperature(
    coefficient: float | np.ndarray,
    friction: np.ndarray,
    load_per_width: np.ndarray,
    surface_speed: np.ndarray,
    half_width: np.ndarray,
    effusivity: np.ndarray,
) -> np.ndarray:
    """Return the flash temperature of a line contact (K), shape (n,): Blok (1937).

    T_f = u f F' |v_p - v_g| / ((sqrt(g rho c v)_p + sqrt(g rho c v)_g) sqrt(B_H)).

    Parameters
    ----------
    coefficient : u, 0.83 for a parabolic flux and the Hertz HALF width.
    friction : coefficient of friction, (n,).
    load_per_width : F', N/m, (n,).
    surface_speed : v, m/s, (2, n).
    half_width : B_H, m, (n,).
    effusivity : sqrt(g rho c) of pinion and gear, J/(m2 K s^0.5), (2,).
    """
    speed = np.maximum(surface_speed, 0.0)
    carried_off = (effusivity[:, None] * np.sqrt(speed)).sum(axis=0) * np.sqrt(half_width)
    released = coefficient * friction * load_per_width * np.abs(speed[0] - speed[1])
    return np.divide(released, carried_off, out=np.zeros_like(released), where=carried_off > 0)


def contact_heat(
    load_per_width: np.ndarray,
    surface_speed: np.ndarray,
    radius: np.ndarray,
    modulus: np.ndarray,
    poisson_ratio: np.ndarray,
    effusivity: np.ndarray,
    viscosity: float,
    lubricant: dict[str, Any],
    friction: dict[str, Any],
    flash_coefficient: float,
    friction_factor: float = 1.0,
) -> ContactHeat:
    """Return flash temperature and friction along the path.

    Parameters
    ----------
    load_per_width : N/m of the pair, (n,).
    surface_speed : m/s, (2, n).
    radius : effective radius of curvature, m, (n,).
    modulus, poisson_ratio, effusivity : of pinion and gear, (2,).
    viscosity : Pa s.
    lubricant, friction : configuration sections.
    flash_coefficient : u.
    friction_factor : multiplies the coefficient of friction.
    """
    stiffness = contact_modulus(modulus, poisson_ratio)
    half_width = hertz_half_width(load_per_width, radius, stiffness)
    rolling = surface_speed.mean(axis=0)
    film = film_thickness(rolling, radius, load_per_width, stiffness, viscosity, lubricant["pressure_viscosity"])
    roughness = lubricant["composite_roughness"]
    full_film = elastohydrodynamic_friction(
        hertz_peak_pressure(load_per_width, radius, stiffness),
        (surface_speed[0] - surface_speed[1]) / rolling,
        rolling,
        viscosity,
        radius,
        roughness,
    )
    rubbing = friction_factor * friction_coefficient(film / roughness, full_film, **friction)
    flash = flash_temperature(flash_coefficient, rubbing, load_per_width, surface_speed, half_width, effusivity)
    return ContactHeat(flash, rubbing, film / roughness, half_width, load_per_width)
