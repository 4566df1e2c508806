"""Amplitude spectrum of a motion that repeats after several mesh periods."""

from __future__ import annotations

import numpy as np

from gearwear.dynamics.harmonics import harmonics


def spectrum(
    values: np.ndarray, mesh_phase: np.ndarray, width: np.ndarray, highest: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return orders of the mesh frequency, multiples of 1/periods up to `highest`, and their amplitudes.

    The amplitudes are those of cosines. Of a motion that never repeats only the mesh harmonics are amplitudes in that
    sense; between them stand the lines of the stretch given, which fall with its length.

    Parameters
    ----------
    values : at the midpoints of the cells, (periods, m).
    mesh_phase, width : midpoints and widths of the cells of one mesh period, (m,).
    highest : order, at most a quarter of m or the cells are too wide for it.

    Raises
    ------
    ValueError : `highest` is beyond what the cells resolve.
    """
    periods, cells = values.shape
    if highest > cells / 4:
        raise ValueError(f"spectrum: order {highest:g} needs at least {4 * highest:g} cells a mesh period, not {cells}")
    time = (np.arange(periods)[:, None] + mesh_phase).ravel() / periods
    count = int(highest * periods)
    amplitudes, _ = harmonics(values.ravel(), time, np.tile(width, periods) / periods, count)
    return np.arange(1, count + 1) / periods, amplitudes
