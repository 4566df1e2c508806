"""Force and speeds of the running mesh."""

from __future__ import annotations

import numpy as np
import xarray as xr


def mesh_force(geometry: xr.Dataset, pinion_torque: float) -> float:
    """Return the static mesh force (N): torque of the pinion (N m) over its base radius."""
    return pinion_torque / float(geometry["base_radius"][0])


def angular_speed(geometry: xr.Dataset, pinion_speed: float) -> np.ndarray:
    """Return the angular speeds of pinion and gear (rad/s), shape (2,), from the pinion's in rpm."""
    pinion = 2 * np.pi * pinion_speed / 60
    teeth = geometry["teeth"].values
    return pinion * np.array([1.0, teeth[0] / teeth[1]])


def curvature(geometry: xr.Dataset) -> tuple[np.ndarray, np.ndarray]:
    """Return the radii of curvature of both flanks (m, (2, n)) and the effective one, R1 R2/(R1 + R2) (m, (n,))."""
    path = geometry["path"].values
    radii = np.stack([path, float(geometry["line_of_action"]) - path])
    return radii, radii.prod(axis=0) / radii.sum(axis=0)


def surface_speed(geometry: xr.Dataset, pinion_speed: float) -> np.ndarray:
    """Return the speeds of both flanks through the contact (m/s), shape (2, n), at a pinion speed in rpm."""
    return angular_speed(geometry, pinion_speed)[:, None] * curvature(geometry)[0]
