"""Stiffness of tooth pair and mesh, and its parts."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import xarray as xr

from gearwear.geometry.kinematics import curvature
from gearwear.mesh.cantilever import load_angle
from gearwear.mesh.foundation import foundation_factors
from gearwear.mesh.sharing import Springs, share
from gearwear.mesh.stiffness import Flanks, PairStiffness, mesh_stiffness, pair_stiffness
from gearwear.oscillator.harmonics import harmonics, mean_over_mesh
from gearwear.validation.pairs import geometry_of, standard_pair

_SETTINGS = {
    "fillet_angle": "rack",
    "hertz": "linear",
    "profile_changes": "paper",
    "pairs": "plain",
    "foundation_coupling": 0.0,
}


def pairs_of(geometry: xr.Dataset, modulus: float = 206e9, cantilever: str = "base") -> PairStiffness:
    """Return the stiffness of unworn, cold pairs of one steel, Poisson's ratio 0.3."""
    unchanged = Flanks(*np.zeros((2, 2, geometry.sizes["path"])))
    settings = _SETTINGS | {"cantilever": cantilever}
    return pair_stiffness(geometry, np.full(2, modulus), np.full(2, 0.3), unchanged, settings)


def mesh_of(geometry: xr.Dataset, modulus: float = 206e9, cantilever: str = "base") -> np.ndarray:
    """Return the mesh stiffness of such pairs (N/m, (m,))."""
    found = pairs_of(geometry, modulus, cantilever)
    return mesh_stiffness(found, geometry["entering"].values, geometry["leaving"].values)


def _at_pitch_point(geometry: xr.Dataset) -> int:
    return int(np.argmin(abs(geometry["path"].values - float(geometry["pitch_point"]))))


def load_angles(pair: dict[str, Any]) -> np.ndarray:
    """Return the load angle at the pitch point (rad), pinion and gear."""
    geometry = geometry_of(**pair)
    radii = curvature(geometry)[0][:, _at_pitch_point(geometry)]
    return load_angle(radii, geometry["base_radius"].values, geometry["base_half_angle"].values)


def body_factors(pair: dict[str, Any], gear: int) -> np.ndarray:
    """Return L*, M*, P*, Q* of a gear."""
    geometry = geometry_of(**pair)
    ratio = float(geometry["root_radius"][gear] / geometry["bore_radius"][gear])
    return foundation_factors(ratio, float(geometry["rack_root_angle"][gear]))


def component(pair: dict[str, Any], modulus: float, part: str, cantilever: str = "base") -> np.ndarray:
    """Return the stiffness of a part at the pitch point (N/m): pinion and gear, one value for the contact."""
    geometry = geometry_of(**pair)
    compliance = getattr(pairs_of(geometry, modulus, cantilever), part)
    return 1 / compliance[..., _at_pitch_point(geometry)]


def pair_at_marks(pair: dict[str, Any], modulus: float) -> np.ndarray:
    """Return the pair stiffness at start of contact, pitch point and end of contact (N/m)."""
    geometry = geometry_of(**pair)
    return pairs_of(geometry, modulus).pair_stiffness[[0, _at_pitch_point(geometry), -1]]


def mesh_mean(pair: dict[str, Any], modulus: float, cantilever: str = "base") -> float:
    """Return the mean mesh stiffness (N/m)."""
    geometry = geometry_of(**pair)
    return float(mean_over_mesh(mesh_of(geometry, modulus, cantilever), geometry["mesh_phase_width"].values))


def mesh_range(pair: dict[str, Any], modulus: float) -> tuple[Any, Any]:
    """Return the least and largest mesh stiffness (N/m)."""
    k = mesh_of(geometry_of(**pair), modulus)
    return k.min(), k.max()


def _first_harmonic(pair: dict[str, Any], modulus: float) -> tuple[float, float]:
    geometry = geometry_of(**pair)
    phase, width = geometry["mesh_phase"].values, geometry["mesh_phase_width"].values
    amplitude, angle = harmonics(mesh_of(geometry, modulus), phase, width, 1)
    return float(amplitude[0]), float(angle[0])


def mesh_amplitude(pair: dict[str, Any], modulus: float) -> float:
    """Return the amplitude of the first harmonic of the mesh stiffness (N/m)."""
    return _first_harmonic(pair, modulus)[0]


def mesh_angle(pair: dict[str, Any], modulus: float) -> float:
    """Return the phase of the first harmonic (rad), zero at pair entry."""
    return _first_harmonic(pair, modulus)[1]


def amplitude_over_rectangle(pair: dict[str, Any], modulus: float) -> float:
    """Return the first harmonic over that of the rectangular wave of the mean stiffness of either zone."""
    geometry = geometry_of(**pair)
    k, width = mesh_of(geometry, modulus), geometry["mesh_phase_width"].values
    double = geometry["leaving"].values >= 0
    step = k[double] @ width[double] / width[double].sum() - k[~double] @ width[~double] / width[~double].sum()
    rectangle = 2 / math.pi * step * math.sin(math.pi * (float(geometry["contact_ratio"]) - 1))
    return mesh_amplitude(pair, modulus) / rectangle


def share_at_start(pair: dict[str, Any], modulus: float) -> float:
    """Return the part of the force on the entering pair at the start of contact."""
    geometry = geometry_of(**pair)
    springs = pairs_of(geometry, modulus)
    nodes = Springs(springs.pair_stiffness, springs.coupling, geometry["partner"].values)
    return float(share(nodes, np.zeros(geometry.sizes["path"]), 1000.0).load_share[0])


def equal_gears_angle(teeth: int, root_over_bore: float = 3.0) -> float:
    """Return the phase of the first harmonic of two equal gears less -pi (contact ratio - 1) (rad)."""
    geometry = standard_pair((teeth, teeth), root_over_bore)
    phase, width = geometry["mesh_phase"].values, geometry["mesh_phase_width"].values
    angle = harmonics(mesh_of(geometry), phase, width, 1)[1][0]
    return float(angle) + math.pi * (float(geometry["contact_ratio"]) - 1)


def scaled(
    pair: dict[str, Any], modulus: float, lengths: float = 1.0, width: float = 1.0, stiffer: float = 1.0
) -> float:
    """Return the mean mesh stiffness of a pair with lengths, face width and modulus multiplied, over its own."""
    changed = pair | {
        "module": lengths * pair["module"],
        "bore_radius": [lengths * bore for bore in pair["bore_radius"]],
        "face_width": width * pair["face_width"],
    }
    return mesh_mean(changed, stiffer * modulus) / mesh_mean(pair, modulus)


def base_over_root(pair: dict[str, Any]) -> float:
    """Return the pair stiffness at the pitch point clamped at the base circle over that clamped at the root."""
    geometry = geometry_of(**pair)
    node = _at_pitch_point(geometry)
    base, root = (pairs_of(geometry, cantilever=clamp).pair_stiffness[node] for clamp in ("base", "root"))
    return base / root


QUANTITIES = {
    "load_angles": load_angles,
    "body_factors": body_factors,
    "component": component,
    "pair_at_marks": pair_at_marks,
    "mesh_mean": mesh_mean,
    "mesh_range": mesh_range,
    "mesh_amplitude": mesh_amplitude,
    "mesh_angle": mesh_angle,
    "amplitude_over_rectangle": amplitude_over_rectangle,
    "share_at_start": share_at_start,
    "equal_gears_angle": equal_gears_angle,
    "scaled": scaled,
    "base_over_root": base_over_root,
}
