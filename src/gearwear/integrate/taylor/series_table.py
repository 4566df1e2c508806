"""The mesh period of a translational oscillator cut into cells, with the power series of what drives it over each."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwear.integrate.affine.affine_table import cut_cells
from gearwear.integrate.taylor.power_series import TERMS, waves
from gearwear.integrate.taylor.series_step import cell_maps
from gearwear.oscillator.translational import TranslationalOscillator

LARGEST_TURN = 1.4  # of cell length times the fastest rate: degree 20 then leaves 1e-16


class SeriesTable(NamedTuple):
    """The mesh period cut into cells, none of which reaches across a break of a table or a phase to be visited.

    starts : (cells,) mesh phase
    lengths : (cells,) dimensionless time
    series : (cells, 3, TERMS) of k, F and b over a cell, its time from 0 to 1
    torque : (cells, harmonics, 2, TERMS) cosine and sine parts of the external torque in mesh period 0
    kicks : (cells, 2 n) jumps of the state at the end of a cell
    maps : of series_step.cell_maps
    """

    starts: np.ndarray
    lengths: np.ndarray
    series: np.ndarray
    torque: np.ndarray
    kicks: np.ndarray
    maps: np.ndarray


def series_table(oscillator: TranslationalOscillator, phases: tuple[float, ...] = ()) -> SeriesTable:
    """Return the table of an oscillator, with cell edges at the mesh phases given (increasing, within [0, 1])."""
    constants, harmonics, whole = oscillator.coefficients
    frequency, _, force, clearance, ratio = constants
    whole = cut_cells(whole, phases, oscillator.period)
    length = (whole[:, 1] - whole[:, 0]) * oscillator.period
    parts = np.maximum(1, np.ceil(length * _fastest_rate(oscillator) / LARGEST_TURN - 1e-9)).astype(int)
    source = np.repeat(np.arange(len(whole)), parts)
    place = np.arange(parts.sum()) - np.repeat(np.cumsum(parts) - parts, parts)
    lengths = (length / parts)[source]
    starts = whole[source, 0] + place * ((whole[:, 1] - whole[:, 0]) / parts)[source]
    series = np.zeros((len(source), 3, TERMS))
    series[:, 0, 0] = whole[source, 2] + whole[source, 3] * place * lengths
    series[:, 0, 1] = whole[source, 3] * lengths
    series[:, 1, 0], series[:, 2, 0] = force, clearance
    torque = np.zeros((len(source), len(oscillator.torque.amplitudes), 2, TERMS))
    order = np.arange(1, len(harmonics) + 1)
    for cell, (start, long) in enumerate(zip(starts, lengths, strict=True)):
        amplitudes = harmonics[:, ::2] - 1j * harmonics[:, 1::2]
        turned = np.exp(2j * np.pi * order * start)[:, None] * waves(frequency * long, len(order))
        series[cell] += (amplitudes[:, :3].T @ turned).real
        for j in range(torque.shape[1]):
            phase = np.exp(2j * np.pi * (j + 1) * ratio * start)
            wave = amplitudes[j, 3] * phase * waves(ratio * frequency * long, j + 1)[j]
            torque[cell, j] = wave.real, wave.imag
    kicks = whole[source, 4:] * (place == parts[source] - 1)[:, None]
    maps = cell_maps(*oscillator.linear_part, lengths, series)
    return SeriesTable(starts, lengths, series, torque, kicks, maps)


def _fastest_rate(oscillator: TranslationalOscillator) -> float:
    """Sum of the fastest forcing and the fastest free vibration, with its damping: what the series must follow."""
    _, harmonics, cells = oscillator.coefficients
    damping, stiffness, pull = oscillator.linear_part
    ends = cells[:, 2] + cells[:, 3] * (cells[:, 1] - cells[:, 0]) * oscillator.period
    stiffest = max(cells[:, 2].max(), ends.max()) + np.hypot(harmonics[:, 0], harmonics[:, 1]).sum()
    kinds = np.repeat([1.0, 1.0, 1.0, oscillator.torque.frequency_ratio], 2)
    orders = np.arange(1, len(harmonics) + 1)[:, None] * kinds
    fastest = np.max(orders * (harmonics != 0.0), initial=0.0) * oscillator.frequency
    free = stiffness + stiffest * np.outer(pull, np.eye(len(pull))[0])
    return fastest + np.sqrt(np.abs(np.linalg.eigvals(free)).max()) + np.abs(np.linalg.eigvals(damping)).max()
