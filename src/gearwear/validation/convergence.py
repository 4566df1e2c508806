"""How results move as grids, blocks and tolerances are made finer."""

from __future__ import annotations

from typing import Any

import numpy as np

from gearwear.geometry.kinematics import curvature
from gearwear.integrate.status import STATES
from gearwear.integrate.strobe import GENERAL, strobe
from gearwear.mesh.cantilever import load_angle, tooth_compliance
from gearwear.oscillator.harmonics import harmonics, mean_over_mesh
from gearwear.validation.oscillator import oscillator_of
from gearwear.validation.pairs import geometry_of
from gearwear.validation.stiffness import mesh_of
from gearwear.validation.wear import worn_mesh

_FINEST_RULE, _FINEST_GRID = 96, 960


def gauss_points(pair: dict[str, Any], points: float) -> float:
    """Return the largest relative error of any tooth compliance along the path, clamped at the root circle."""
    geometry = geometry_of(**pair)
    errors = []
    for i in range(2):
        base, half = float(geometry["base_radius"][i]), float(geometry["base_half_angle"][i])
        angles = load_angle(curvature(geometry)[0][i], base, half)
        clamp = float(geometry["root_radius"][i]) / base
        coarse, fine = (
            tooth_compliance(angles, half, 0.3, root_ratio=clamp, points=int(n)) for n in (points, _FINEST_RULE)
        )
        errors += [np.abs(one / other - 1)[other > 0].max() for one, other in zip(coarse, fine, strict=True)]
    return max(errors)


def _mesh(pair: dict[str, Any], cells: float) -> Any:
    geometry = geometry_of(**pair, mesh_cells=int(cells))
    k, width = mesh_of(geometry), geometry["mesh_phase_width"].values
    amplitude, angle = harmonics(k, geometry["mesh_phase"].values, width, 1)
    return mean_over_mesh(k, width), amplitude[0], angle[0]


def mesh_cells_mean(pair: dict[str, Any], cells: float) -> float:
    """Return the relative error of the mean mesh stiffness on a grid of mesh phases."""
    return abs(_mesh(pair, cells)[0] / _mesh(pair, _FINEST_GRID)[0] - 1)


def mesh_cells_amplitude(pair: dict[str, Any], cells: float) -> float:
    """Return the relative error of the first harmonic of the mesh stiffness."""
    return abs(_mesh(pair, cells)[1] / _mesh(pair, _FINEST_GRID)[1] - 1)


def path_cells(pair: dict[str, Any], torque: float, cells: float) -> float:
    """Return the relative error of the mean transmission error of a worn mesh on a grid of the path."""
    coarse, fine = (worn_mesh(pair, torque, mesh_cells=int(n)).error_ratio for n in (cells, _FINEST_GRID))
    return abs(coarse / fine - 1)


def wear_blocks(pair: dict[str, Any], torque: float, blocks: float, finest: int = 700, **law: Any) -> float:
    """Return the relative error of the deepest wear of 2.1e9 revolutions in some blocks of constant increment."""
    coarse, fine = (worn_mesh(pair, torque, blocks=int(n), **law).depth.max() for n in (blocks, finest))
    return coarse / fine - 1


def tolerance(system: dict[str, Any], frequency: float, tolerance: float) -> float:
    """Return how far the general integrator is from the affine map after 20 periods from rest."""
    oscillator = oscillator_of(frequency, **system)
    exact = strobe(oscillator, (0.0, 0.0), 20, detail=STATES).states
    general = strobe(oscillator, (0.0, 0.0), 20, tolerance=tolerance, detail=STATES, backend=GENERAL).states
    return float(np.abs(general - exact).max())


QUANTITIES = {
    "gauss_points": gauss_points,
    "mesh_cells_mean": mesh_cells_mean,
    "mesh_cells_amplitude": mesh_cells_amplitude,
    "path_cells": path_cells,
    "wear_blocks": wear_blocks,
    "tolerance": tolerance,
}
