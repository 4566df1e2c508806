"""Lubricated contact, wear of one passage, and wear that builds up on a mesh of simple stiffness."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from gearwear.contact.film import film_thickness
from gearwear.contact.hertz import contact_modulus, hertz_half_width, hertz_peak_pressure
from gearwear.geometry.kinematics import curvature, surface_speed
from gearwear.mesh.sharing import Springs, share
from gearwear.validation.pairs import geometry_of
from gearwear.wear.archard import boundary_wear_coefficient, film_factor, wear_per_revolution

STEEL = contact_modulus(np.full(2, 206e9), np.full(2, 0.3))
_REVOLUTIONS, _VISCOSITY, _ROUGHNESS = 2.1e9, 0.0094, 0.5e-6


def contact(
    radii: np.ndarray,
    load_per_width: float,
    speed: float,
    ratio: float,
    viscosity: float,
    pressure_viscosity: float,
    roughness: float,
) -> dict[str, np.ndarray]:
    """Return everything about one contact of steel flanks (SI units).

    Parameters
    ----------
    radii : of curvature of both flanks, m.
    load_per_width : N/m.
    speed : of the pinion, rpm; ratio : speed of the gear over that.
    viscosity : Pa s; pressure_viscosity : 1/Pa; roughness : composite rms, m.
    """
    radii = np.array(radii)
    radius = radii.prod() / radii.sum()
    own = 2 * np.pi * speed / 60 * np.array([1.0, ratio]) * radii
    rolling = own.mean()
    half_width = hertz_half_width(load_per_width, radius, STEEL)
    film = film_thickness(rolling, radius, load_per_width, STEEL, viscosity, pressure_viscosity)
    boundary = boundary_wear_coefficient(load_per_width, radius, STEEL, pressure_viscosity, roughness)
    lubricant = {"pressure_viscosity": pressure_viscosity, "composite_roughness": roughness}
    depth = wear_per_revolution(
        np.array([load_per_width]),
        own[:, None],
        np.array([radius]),
        1.0,
        STEEL,
        viscosity,
        lubricant,
        "janakiraman",
        0.0,
        "mean",
    )
    return {
        "contact_modulus": STEEL,
        "radius": radius,
        "half_width": half_width,
        "peak_pressure": hertz_peak_pressure(load_per_width, radius, STEEL),
        "mean_pressure": load_per_width / (2 * half_width),
        "speeds": np.array([*own, rolling]),
        "sliding": 2 * half_width * abs(1 - own[::-1] / own),
        "groups": np.array(
            [
                viscosity * rolling / (STEEL * radius),
                pressure_viscosity * STEEL,
                load_per_width / (STEEL * radius),
                roughness / radius,
            ]
        ),
        "film": film,
        "film_ratio": film / roughness,
        "wear_coefficient": boundary * film_factor(film / roughness),
        "depth": depth[:, 0],
    }


class Worn(NamedTuple):
    """A mesh after many revolutions.

    depth : m, (2, n); path, pitch_point : m; error_ratio : mean loaded error over that of the unworn mesh;
    film_ratio, wear_coefficient (m2/N) : of the unworn mesh, (n,)
    """

    depth: np.ndarray
    path: np.ndarray
    pitch_point: float
    error_ratio: float
    film_ratio: np.ndarray
    wear_coefficient: np.ndarray


def worn_mesh(
    pair: dict[str, Any],
    torque: float,
    pressure_viscosity: float = 2.1e-8,
    constant: float | None = None,
    blocks: int = 21,
    mesh_cells: int = 120,
) -> Worn:
    """Wear a mesh under its static force, pairs of k = 14 N/(um mm) B (1 - 0.35 xi^2), xi = -1 to 1 along the path.

    2.1e9 revolutions of the pinion at 3000 rpm, 9.4 mPa s, 0.5 um, 206 GPa; z_p/z_g passages of a gear tooth each.

    Parameters
    ----------
    pair : as for `geometry_of`.
    torque : of the pinion, N m.
    pressure_viscosity : 1/Pa, for the wear coefficient of load and film.
    constant : wear coefficient (m2/N) instead of that.
    blocks : between which the flanks are updated.
    """
    geometry = geometry_of(**pair, mesh_cells=mesh_cells)
    path, width = geometry["path"].values, float(geometry["face_width"])
    middle = (path[0] + path[-1]) / 2
    own = 14e9 * width * (1 - 0.35 * ((path - middle) / (path[-1] - middle)) ** 2)
    springs = Springs(own, np.zeros_like(path), geometry["partner"].values)
    force = torque / float(geometry["base_radius"][0])
    lubricant = {"pressure_viscosity": pressure_viscosity, "composite_roughness": _ROUGHNESS}
    law = ("janakiraman", 0.0) if constant is None else ("constant", constant)
    speed, radius = surface_speed(geometry, 3000.0), curvature(geometry)[1]
    passages = np.array([1.0, float(geometry["teeth"][0] / geometry["teeth"][1])])[:, None]
    depth, errors = np.zeros((2, len(path))), []
    entering, weight = geometry["entering"].values, geometry["mesh_phase_width"].values
    first = force * share(springs, np.zeros_like(path), force).load_share / width
    for _ in range(blocks):
        shared = share(springs, depth.sum(axis=0), force)
        errors.append(shared.approach[entering] @ weight)
        step = wear_per_revolution(
            force * shared.load_share, speed, radius, width, STEEL, _VISCOSITY, lubricant, *law, "mean"
        )
        depth = depth + _REVOLUTIONS / blocks * passages * step
    errors.append(share(springs, depth.sum(axis=0), force).approach[entering] @ weight)
    film = film_thickness(speed.mean(axis=0), radius, first, STEEL, _VISCOSITY, pressure_viscosity) / _ROUGHNESS
    boundary = boundary_wear_coefficient(first, radius, STEEL, pressure_viscosity, _ROUGHNESS)
    return Worn(depth, path, float(geometry["pitch_point"]), errors[-1] / errors[0], film, film_factor(film) * boundary)


def contact_value(name: str, given: dict[str, Any]) -> np.ndarray:
    """Return one of the numbers of `contact`."""
    return contact(**given)[name]


def film_factors(film_ratio: float) -> float:
    """Return the part of the wear coefficient that is left under a film."""
    return float(film_factor(film_ratio))


def coefficient(pressure_viscosity: float, roughness: float, load_per_width: float) -> float:
    """Return the boundary wear coefficient (m2/N) of a contact of 10 mm radius."""
    return float(boundary_wear_coefficient(load_per_width, 10e-3, STEEL, pressure_viscosity, roughness))


def exponent(of: str) -> float:
    """Return the power with which the boundary wear coefficient grows with radius, modulus or load."""
    given = {"load": 2e5, "radius": 6e-3, "modulus": STEEL}

    def at(factor: float) -> float:
        load, radius, modulus = (given | {of: factor * given[of]}).values()
        return float(boundary_wear_coefficient(load, radius, modulus, 2e-8, 0.5e-6))

    return float(np.log(at(2.0) / at(1.0)) / np.log(2.0))


def deepest(**mesh: Any) -> list[Any]:
    """Return the deepest wear (m): pinion dedendum and addendum, gear addendum and dedendum."""
    worn = worn_mesh(**mesh)
    before = worn.path < worn.pitch_point
    return [worn.depth[gear][part].max() for gear in (0, 1) for part in (before, ~before)]


def deepest_of_all(**mesh: Any) -> float:
    """Return the deepest wear anywhere (m)."""
    return worn_mesh(**mesh).depth.max()


def error_ratio(**mesh: Any) -> float:
    """Return the mean loaded transmission error, worn over unworn."""
    return worn_mesh(**mesh).error_ratio


def range_of(name: str, **mesh: Any) -> tuple[Any, Any]:
    """Return least and largest value along the path of the unworn mesh."""
    values = getattr(worn_mesh(**mesh), name)
    return values.min(), values.max()


def overshoot_at_start(finest: int, **mesh: Any) -> float:
    """Return the wear at the start of contact over that of the finest blocks."""
    return worn_mesh(**mesh).depth[0, 0] / worn_mesh(**mesh | {"blocks": finest}).depth[0, 0]


QUANTITIES = {
    "contact_value": contact_value,
    "film_factors": film_factors,
    "coefficient": coefficient,
    "exponent": exponent,
    "deepest": deepest,
    "deepest_of_all": deepest_of_all,
    "error_ratio": error_ratio,
    "range_of": range_of,
    "overshoot_at_start": overshoot_at_start,
}
