"""Stiffness of a tooth pair along its path and of the mesh over its phase."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from gearwear.geometry.kinematics import curvature
from gearwear.mesh.cantilever import load_angle, tooth_compliance
from gearwear.mesh.foundation import foundation_compliance
from gearwear.mesh.sharing import Springs, share


class Flanks(NamedTuple):
    """What changes the profile, m along the line of action, shape (2, n) each, both zero or positive."""

    wear: np.ndarray
    growth: np.ndarray


class PairStiffness(NamedTuple):
    """Stiffness along the path; compliances in m/N, arrays of shape (n,) or (2, n)."""

    pair_stiffness: np.ndarray
    coupling: np.ndarray
    hertz: np.ndarray
    bending: np.ndarray
    shear: np.ndarray
    axial: np.ndarray
    foundation: np.ndarray


def pair_stiffness(
    geometry: xr.Dataset,
    modulus: np.ndarray,
    poisson_ratio: np.ndarray,
    flanks: Flanks,
    settings: dict[str, Any],
    force: float = 0.0,
) -> PairStiffness:
    """Return the stiffness of one tooth pair along the path of contact.

    Parameters
    ----------
    geometry : dataset of the geometry stage.
    modulus : Pa, shape (2,); poisson_ratio : shape (2,).
    flanks : wear and thermal growth.
    settings : the section `mesh_stiffness`.
    force : static mesh force (N), used by the load-dependent contact law `weber` only.

    Returns
    -------
    PairStiffness : N/m, and its parts; `coupling` is the compliance (m/N) by which a pair deflects under the load of
        the other pair through the common gear bodies, zero for `pairs: plain` and in single contact.
    """
    partner = geometry["partner"].values
    width = float(geometry["face_width"])
    radii, _ = curvature(geometry)
    root_angle = geometry[f"{settings['fillet_angle']}_root_angle"].values
    parts = {name: np.empty_like(radii) for name in ("bending", "shear", "axial", "foundation")}
    for i in range(2):
        base, half = float(geometry["base_radius"][i]), float(geometry["base_half_angle"][i])
        root, bore = float(geometry["root_radius"][i]), float(geometry["bore_radius"][i])
        angles = load_angle(radii[i], base, half)
        arm, section, breaks = _profile_changes(settings["profile_changes"], flanks, i, radii[i], angles, base, half)
        clamp = root / base if settings["cantilever"] == "root" else None
        tooth = tooth_compliance(angles, half, poisson_ratio[i], arm, section, clamp, breaks)
        body = foundation_compliance(angles, base, root, bore, root_angle[i])
        for name, value in (*tooth._asdict().items(), ("foundation", body)):
            parts[name][i] = value / (modulus[i] * width)
    elastic = sum(parts.values(), np.zeros_like(radii)).sum(axis=0)
    hertz = _linear_hertz(modulus, poisson_ratio, width) * np.ones(len(partner))
    coupling = np.zeros(len(partner))
    if settings["pairs"] == "coupled":
        both = partner >= 0
        own = parts["foundation"].sum(axis=0)
        coupling[both] = settings["foundation_coupling"] * np.sqrt(own[both] * own[partner[both]])
    if settings["hertz"] == "weber":
        springs = Springs(1 / (elastic + hertz), coupling, partner)
        load = force * share(springs, np.zeros(len(partner)), force).load_share
        hertz = _weber_hertz(geometry, radii, modulus, poisson_ratio, np.maximum(load, 1e-3 * force))
    return PairStiffness(1 / (elastic + hertz), coupling, hertz, **parts)


def mesh_stiffness(pairs: PairStiffness, entering: np.ndarray, leaving: np.ndarray) -> np.ndarray:
    """Return the stiffness of all pairs in contact at each mesh phase (N/m), shape (m,).

    Pairs act in parallel; with a common foundation K = (C11 + C22 - 2 C12)/(C11 C22 - C12^2).

    Parameters
    ----------
    entering, leaving : path nodes of the two pairs at each phase, `leaving` -1 in single contact.
    """
    own = 1 / pairs.pair_stiffness[entering]
    other = 1 / pairs.pair_stiffness[leaving]
    common = pairs.coupling[entering]
    double = (own + other - 2 * common) / (own * other - common**2)
    return np.where(leaving < 0, 1 / own, double)


def _profile_changes(
    mode: str,
    flanks: Flanks,
    i: int,
    curvature: np.ndarray,
    angles: np.ndarray,
    base: float,
    half: float,
) -> tuple[np.ndarray | None, Callable[[np.ndarray], np.ndarray] | None, tuple[float, ...]]:
    """Return D (n,), the function H(section angles) and the angles where it jumps: see docs/model.md."""
    if mode == "off":
        return None, None, ()
    wear, growth = flanks.wear[i], flanks.growth[i]
    order = np.arange(len(curvature)) if i == 0 else np.arange(len(curvature))[::-1]
    known = curvature[order] / base
    jumps = known[np.concatenate([[True], np.diff(known) == 0])]  # where wear begins and where the load steps

    def at_section(values: np.ndarray, section: np.ndarray, below: float | None) -> np.ndarray:
        return np.interp(half - section, known, values[order], left=below)

    if mode == "paper":
        arm = (-wear * np.cos(angles) + 2 * growth * np.cos(angles)) * np.sin(angles) / base
    else:
        arm = wear * np.cos(angles) * np.sin(angles) / (2 * base)

    def section_change(section: np.ndarray) -> np.ndarray:
        cos = np.cos(section)
        worn = at_section(wear, section, 0.0)  # no wear below the start of contact
        grown = at_section(growth, section, None)
        change = (-worn + 2 * grown) * cos / (2 * base)
        return change * cos if mode == "paper" else change

    return arm, section_change, tuple(half - jumps)


def _linear_hertz(modulus: np.ndarray, poisson_ratio: np.ndarray, width: float) -> float:
    """Contact compliance of a pair, 4 (1 - nu^2)/(pi E B) (m/N), mean of both gears: Yang and Sun (1985)."""
    return 4 / (np.pi * width) * float(np.mean((1 - poisson_ratio**2) / modulus))


def _weber_hertz(
    geometry: xr.Dataset, radii: np.ndarray, modulus: np.ndarray, poisson_ratio: np.ndarray, load: np.ndarray
) -> np.ndarray:
    """Contact compliance (m/N) under `load` (N): Weber (1949), line contact with the depths to the tooth axes.

    delta = 4 F (1 - nu^2)/(pi B E) [ln(2 sqrt(h1 h2)/a) - nu/(2 (1 - nu))].
    """
    width = float(geometry["face_width"])
    base, half = geometry["base_radius"].values[:, None], geometry["base_half_angle"].values[:, None]
    depth = radii - base * np.tan(load_angle(radii, base, half))
    softness = float(np.mean((1 - poisson_ratio**2) / modulus))
    reduced = radii.prod(axis=0) / radii.sum(axis=0)
    half_width = np.sqrt(8 * load * reduced * softness / (np.pi * width))
    nu = float(np.mean(poisson_ratio))
    bracket = np.log(2 * np.sqrt(depth.prod(axis=0)) / half_width) - nu / (2 * (1 - nu))
    return 4 * softness / (np.pi * width) * bracket
