"""Amplitude spectrum of a motion that repeats after several mesh periods."""

from __future__ import annotations

import numpy as np

from gearwear.oscillator.harmonics import harmonics


def spectrum(
    values: np.ndarray, mesh_phase: np.ndarray, weight: np.ndarray, highest: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return orders of the mesh frequency, multiples of 1/periods up to `highest`, and their amplitudes.

    The amplitudes are those of cosines. Of a motion that never repeats only the mesh harmonics are amplitudes in that
    sense; between them stand the lines of the stretch given, which fall with its length.

    Parameters
    ----------
    values : at the mesh phases of every period, (periods, m).
    mesh_phase, weight : nodes and weights of a quadrature over one mesh period, (m,), such as the midpoints and widths
        of its cells.
    highest : order up to which the quadrature is good.
    """
    periods = len(values)
    time = (np.arange(periods)[:, None] + mesh_phase).ravel() / periods
    weights = np.tile(weight, periods) / periods
    swings = values.ravel() - values.ravel() @ weights  # a large mean would leak into every order
    amplitudes, _ = harmonics(swings, time, weights, highest * periods)
    return np.arange(1, highest * periods + 1) / periods, amplitudes
