"""Dynamic wear of the flanks: Archard's law with a film-dependent coefficient."""

from __future__ import annotations

from typing import Any

import numpy as np

from gearwear.contact.film import film_thickness
from gearwear.contact.hertz import hertz_half_width


def boundary_wear_coefficient(
    load_per_width: float | np.ndarray,
    radius: float | np.ndarray,
    contact_modulus: float | np.ndarray,
    pressure_viscosity: float | np.ndarray,
    roughness: float | np.ndarray,
) -> np.ndarray:
    """Return the wear coefficient of boundary lubrication (m2/N).

    k = 3.981e29/E' L^1.219 G^-7.377 S^1.589 with L = F'/(E' R), G = alpha E', S = R_rms/R: Janakiraman, Li and
    Kahraman, J. Tribol. 136 (2014) 031602.
    """
    load = load_per_width / (contact_modulus * radius)
    return (
        3.981e29
        / contact_modulus
        * load**1.219
        * (pressure_viscosity * contact_modulus) ** -7.377
        * (roughness / radius) ** 1.589
    )


def film_factor(film_ratio: float | np.ndarray) -> np.ndarray:
    """Return the part of the boundary wear coefficient that is left under a film (0 to 1).

    1 below a film ratio of 1/2, (2/7)(4 - ratio) up to 4, 0 above: Ding and Kahraman, J. Sound Vib. 307 (2007).
    """
    return np.clip(2 / 7 * (4 - np.asarray(film_ratio, dtype=float)), 0.0, 1.0)


def overshoot(removed: np.ndarray, deflection: np.ndarray) -> float:
    """Return the largest ratio of the depth that one block of cycles takes off a pair to its elastic deflection.

    Wear unloads a pair: with dh ~ F^2.2 and F ~ k (S - E) an explicit block is monotone below a ratio of about 0.45 and
    stable below 0.9 (Euler's rule on the linearised law).

    Parameters
    ----------
    removed : depth taken off both flanks, m, (n,); deflection : of the pair under the static load, m, (n,).
    """
    loaded = deflection > 0
    return float((removed[loaded] / deflection[loaded]).max())


def wear_per_revolution(
    load: np.ndarray,
    surface_speed: np.ndarray,
    radius: np.ndarray,
    face_width: float,
    contact_modulus: float,
    viscosity: float,
    lubricant: dict[str, Any],
    law: str,
    coefficient: float,
    pressure: str,
) -> np.ndarray:
    """Return the depth that one passage of the contact takes off each flank (m), shape (2, ...).

    dh_p = 2 a_H k p |1 - u_g/u_p| and, for the gear, |1 - u_p/u_g|: Flodin and Andersson, Wear 207 (1997).

    Parameters
    ----------
    load : N on the pair, shape (..., n), zero or positive.
    surface_speed : of pinion and gear flank at the contact, m/s, shape (2, n).
    radius : effective radius of curvature, m, shape (n,).
    face_width : m; contact_modulus : E', Pa; viscosity : Pa s.
    lubricant : the section `lubricant`.
    law : `janakiraman`, load- and film-dependent; `constant`, `coefficient` (m2/N) everywhere.
    pressure : `mean` over the contact width, the exact integral of one passage, or `peak`, 4/pi times that.
    """
    per_width = load / face_width
    if law == "constant":
        wear_coefficient = coefficient
    else:
        film = film_thickness(
            surface_speed.mean(axis=0), radius, per_width, contact_modulus, viscosity, lubricant["pressure_viscosity"]
        )
        roughness = lubricant["composite_roughness"]
        wear_coefficient = film_factor(film / roughness) * boundary_wear_coefficient(
            per_width, radius, contact_modulus, lubricant["pressure_viscosity"], roughness
        )
    half_width = hertz_half_width(per_width, radius, contact_modulus)
    mean_pressure = np.divide(per_width, 2 * half_width, out=np.zeros_like(per_width), where=half_width > 0)
    passage = 2 * half_width * wear_coefficient * mean_pressure * (4 / np.pi if pressure == "peak" else 1.0)
    own = surface_speed.reshape(2, *(1,) * (passage.ndim - 1), -1)
    return passage * np.abs(1 - own[::-1] / own)
