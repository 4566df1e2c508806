"""Fourier coefficients over one mesh period."""

from __future__ import annotations

import numpy as np


def mean_over_mesh(values: np.ndarray, width: np.ndarray) -> float:
    """Return the mean over one mesh period of values given on cells of the given widths (sum of widths 1)."""
    return float(values @ width)


def harmonics(
    values: np.ndarray, mesh_phase: np.ndarray, width: np.ndarray, count: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return amplitudes and phases of y = mean + sum_j A_j cos(2 pi j tau + phi_j), shape (count,) each.

    Parameters
    ----------
    values : y at the midpoints of the cells, (m,).
    mesh_phase, width : midpoints and widths of the cells, (m,); jumps of y stand on cell edges.
    count : number of harmonics, from the first on.
    """
    orders = np.arange(1, count + 1)[:, None]
    coefficients = (np.exp(-2j * np.pi * orders * mesh_phase) * (values * width)).sum(axis=1)
    return 2 * np.abs(coefficients), np.angle(coefficients)
