"""The mesh period of an oscillator cut into cells, with everything the affine map needs of each.

A cell holds, for free flight and for contact, the affine maps from its start to its end, from its start to its middle
and from its middle to its end, and the series of cell_series. No cell reaches across a break of a table or a phase that
is to be visited. A torque at another frequency that repeats after some mesh periods takes a table for each of them.
"""

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from gearwear.integrate.affine.cell_series import (
    R_CLEARANCE,
    R_FORCE,
    TERMS,
    P,
    Q,
    add_wave,
    fourth_derivative_bound,
    fundamental_series,
    product_series,
    values_at_ends,
)
from gearwear.integrate.compiled import njit, njit_noalloc
from gearwear.oscillator.oscillator import Oscillator

LONGEST_CELL = 0.5
LARGEST_TURN = 1.4  # of cell length times the fastest rate: degree 14 then leaves 1e-15
MOST_CELLS = 16384
MOST_PERIODS = 64  # after which an external torque must repeat

# A cell has three rows: free flight, contact and what both share. Columns of the shared row; from END_CLEARANCE on
# four: b and db/dt at the start and at the end of the cell.
FREE, CONTACT, COMMON, WIDTH = 0, 1, 2, 96
HALF_WIDTH, RATE, KICK_X, KICK_V, CLEARANCE_LOW, CLEARANCE_HIGH, END_CLEARANCE = 0, 1, 2, 3, 4, 5, 6
CLEARANCE_BEND, STIFFNESS_HIGH, FORCE_START, FRESH, FRICTION, START = 10, 11, 12, 13, 14, 15
STIFFNESS, CLEARANCE = 16, 32
# Columns of the row of a branch: its three maps, the bounds of its fourth derivative, its series.
STEP, INTO, OUT, BEND, WAVES = 0, 8, 16, 24, 32


class AffineTable(NamedTuple):
    """Cells of the mesh periods after which all forcing repeats.

    rows : (mesh periods, cells, 3, WIDTH)
    slack : (3,) bound of the quartic remainder over any cell, over |x|, |v| and 1 at its start
    """

    rows: np.ndarray
    slack: np.ndarray


def affine_table(oscillator: Oscillator, phases: tuple[float, ...] = ()) -> AffineTable | None:
    """Table of an oscillator, with cell edges at the mesh phases given (increasing, within [0, 1]).

    None for an oscillator that does not repeat after some mesh periods with a sensible number of cells.
    """
    coefficients, torque = oscillator.coefficients, oscillator.torque
    coefficients = coefficients._replace(constants=np.array(coefficients.constants, dtype=float))
    periods, counts = torque.mesh_periods(MOST_PERIODS), cell_counts(*coefficients)
    if not 0 < periods * counts.sum() <= MOST_CELLS:
        return None
    if phases:
        coefficients = coefficients._replace(cells=cut_cells(coefficients.cells, phases, oscillator.period))
        counts = cell_counts(*coefficients)
    rows, slack = np.zeros((periods, counts.sum(), 3, WIDTH)), np.zeros((periods, 3))
    for period in range(periods):
        if period > 0:
            later = replace(oscillator, torque=torque.seen_from(period * torque.frequency_ratio))
            coefficients = coefficients._replace(harmonics=later.coefficients.harmonics)
        fill_table(*coefficients, counts, np.empty(2 * TERMS), rows[period], slack[period])
    return AffineTable(rows, slack.max(axis=0))


def cut_cells(cells: np.ndarray, phases, period: float) -> np.ndarray:
    """Cells of Coefficients cut at further phases; the kick stays at the end of the last piece."""
    edges = np.union1d(np.append(cells[:, 0], 1.0), phases)
    source = np.searchsorted(cells[:, 0], edges[:-1], side="right") - 1
    pieces = cells[source].copy()
    pieces[:, 0], pieces[:, 1] = edges[:-1], edges[1:]
    pieces[:, 2] += pieces[:, 3] * (edges[:-1] - cells[source, 0]) * period
    pieces[:-1, 4:][source[:-1] == source[1:]] = 0.0
    return pieces


@njit
def cell_counts(constants, harmonics, cells):
    """(n,) number of equal parts of each cell of Coefficients; so short that fourteen powers suffice."""
    frequency, friction, ratio = constants[0], constants[1], constants[4]
    stiffest, fluctuation, fastest = 0.0, 0.0, 0.0
    for n in range(cells.shape[0]):
        end = cells[n, 2] + cells[n, 3] * (cells[n, 1] - cells[n, 0]) * 2.0 * math.pi / frequency
        stiffest = max(stiffest, max(cells[n, 2], end))
    for j in range(harmonics.shape[0]):
        fluctuation += math.hypot(harmonics[j, 0], harmonics[j, 1])
        for column in range(harmonics.shape[1]):
            if harmonics[j, column] != 0.0:
                fastest = max(fastest, (j + 1) * frequency if column < 6 else (j + 1) * ratio * frequency)
    rate = fastest + math.sqrt(stiffest + fluctuation) + friction
    longest = min(LONGEST_CELL, LARGEST_TURN / rate)
    counts = np.empty(cells.shape[0], np.int64)
    for n in range(cells.shape[0]):
        length = (cells[n, 1] - cells[n, 0]) * 2.0 * math.pi / frequency
        counts[n] = max(1, math.ceil(min(length / longest, 1e9) - 1e-9))
    return counts


@njit_noalloc
def fill_table(constants, harmonics, cells, counts, scratch, rows, slack):
    """Write the rows, as many as the sum of the counts of cell_counts, and the slack; scratch has 2 TERMS places."""
    frequency = constants[0]
    period = 2.0 * math.pi / frequency
    force, shift = scratch[:TERMS], scratch[TERMS:]
    scratch[:] = 0.0
    slack[:] = 0.0
    r = 0
    for n in range(cells.shape[0]):
        width = (cells[n, 1] - cells[n, 0]) / counts[n]
        for part in range(counts[n]):
            rows[r] = 0.0
            row = rows[r, COMMON]
            row[START] = cells[n, 0] + part * width
            middle = cells[n, 0] + (part + 0.5) * width
            since = (middle - cells[n, 0]) * period
            half = 0.5 * width * period
            row[HALF_WIDTH], row[RATE], row[FRICTION] = half, 1.0 / half, constants[1]
            if part == counts[n] - 1:
                row[KICK_X], row[KICK_V] = cells[n, 4], cells[n, 5]
            kicked = rows[r - 1, COMMON, KICK_X] != 0.0 or rows[r - 1, COMMON, KICK_V] != 0.0
            row[FRESH] = 1.0 if r == 0 or kicked else 0.0
            force[:] = 0.0
            row[STIFFNESS], row[STIFFNESS + 1] = cells[n, 2] + cells[n, 3] * since, cells[n, 3] * half
            force[0], row[CLEARANCE] = constants[2], constants[3]
            load_series(constants, harmonics, middle, half, row, force)
            finish_clearance(row)
            steady = row[CLEARANCE_BEND] == 0.0
            if not steady:
                product_series(row[STIFFNESS:], row[CLEARANCE:], shift)
            for place in (FREE, CONTACT):
                branch = rows[r, place]
                waves, stiffness = branch[WAVES : WAVES + 4 * TERMS], row[STIFFNESS:]
                contact, b = place == CONTACT, row[CLEARANCE]
                fundamental_series(waves, contact, half, constants[1], stiffness, force, shift, b, steady)
                finish_maps(branch, row[RATE], row[CLEARANCE_BEND], slack)
            row[FORCE_START] = values_at_ends(force, 0)[0]
            r += 1


@njit_noalloc
def load_series(constants, harmonics, middle, half, row, force):
    """Add the fluctuations of stiffness, force and clearance to their series about a mesh phase."""
    frequency, ratio = constants[0], constants[4]
    for j in range(harmonics.shape[0]):
        angle, turn = 2.0 * math.pi * (((j + 1) * middle) % 1.0), (j + 1) * frequency * half
        if harmonics[j, 0] != 0.0 or harmonics[j, 1] != 0.0:
            add_wave(row, STIFFNESS, harmonics[j, 0], harmonics[j, 1], angle, turn)
        if harmonics[j, 2] != 0.0 or harmonics[j, 3] != 0.0:
            add_wave(force, 0, harmonics[j, 2], harmonics[j, 3], angle, turn)
        if harmonics[j, 4] != 0.0 or harmonics[j, 5] != 0.0:
            add_wave(row, CLEARANCE, harmonics[j, 4], harmonics[j, 5], angle, turn)
        if harmonics[j, 6] != 0.0 or harmonics[j, 7] != 0.0:
            angle = 2.0 * math.pi * (((j + 1) * ratio * middle) % 1.0)
            add_wave(force, 0, harmonics[j, 6], harmonics[j, 7], angle, ratio * turn)


@njit_noalloc
def finish_clearance(row):
    """Ends, bounds and curvature of the clearance, and a bound of the stiffness, from their series."""
    rate = row[RATE]
    b0, d0, b1, d1 = values_at_ends(row, CLEARANCE)
    row[END_CLEARANCE], row[END_CLEARANCE + 1] = b0, d0 * rate
    row[END_CLEARANCE + 2], row[END_CLEARANCE + 3] = b1, d1 * rate
    bend = fourth_derivative_bound(row, CLEARANCE) / 9.0
    row[CLEARANCE_BEND] = bend
    inner = 0.5 * (b0 + b1) + (d0 - d1) / 3.0
    low, high = min(b0 + 0.5 * d0, b1 - 0.5 * d1), max(b0 + 0.5 * d0, b1 - 0.5 * d1)
    row[CLEARANCE_LOW] = min(min(b0, b1), min(low, inner - bend))
    row[CLEARANCE_HIGH] = max(max(b0, b1), max(high, inner + bend))
    total = 0.0
    for n in range(TERMS):
        total += row[STIFFNESS + n] if n == 0 else abs(row[STIFFNESS + n])
    row[STIFFNESS_HIGH] = total


@njit_noalloc
def finish_maps(row, rate, clearance_bend, slack):
    """The three affine maps of a branch from its series, and the bounds of its fourth derivative.

    A map takes (x, v) to (m0 x + m1 v + m4 + side m6, m2 x + m3 v + m5 + side m7).
    """
    p0, p1, p2, p3 = values_at_ends(row, WAVES + P * TERMS)
    q0, q1, q2, q3 = values_at_ends(row, WAVES + Q * TERMS)
    f0, f1, f2, f3 = values_at_ends(row, WAVES + R_FORCE * TERMS)
    b0, b1, b2, b3 = values_at_ends(row, WAVES + R_CLEARANCE * TERMS)
    row[OUT], row[OUT + 1], row[OUT + 2], row[OUT + 3] = p2, q2, p3 * rate, q3 * rate
    row[OUT + 4], row[OUT + 5], row[OUT + 6], row[OUT + 7] = f2, f3 * rate, b2, b3 * rate
    p1, q1, f1, b1 = p1 * rate, q1 * rate, f1 * rate, b1 * rate
    wronskian = p0 * q1 - p1 * q0
    row[INTO], row[INTO + 1] = q1 / wronskian, -q0 / wronskian
    row[INTO + 2], row[INTO + 3] = -p1 / wronskian, p0 / wronskian
    row[INTO + 4], row[INTO + 5] = (q0 * f1 - q1 * f0) / wronskian, (p1 * f0 - p0 * f1) / wronskian
    row[INTO + 6], row[INTO + 7] = (q0 * b1 - q1 * b0) / wronskian, (p1 * b0 - p0 * b1) / wronskian
    for line in (0, 2):
        p, q, extra = row[OUT + line], row[OUT + line + 1], line // 2
        row[STEP + line] = p * row[INTO] + q * row[INTO + 2]
        row[STEP + line + 1] = p * row[INTO + 1] + q * row[INTO + 3]
        row[STEP + 4 + extra] = p * row[INTO + 4] + q * row[INTO + 5] + row[OUT + 4 + extra]
        row[STEP + 6 + extra] = p * row[INTO + 6] + q * row[INTO + 7] + row[OUT + 6 + extra]
    bend_p = fourth_derivative_bound(row, WAVES + P * TERMS) / 9.0
    bend_q = fourth_derivative_bound(row, WAVES + Q * TERMS) / 9.0
    bend_r = fourth_derivative_bound(row, WAVES + R_FORCE * TERMS) + fourth_derivative_bound(
        row, WAVES + R_CLEARANCE * TERMS
    )
    row[BEND], row[BEND + 1], row[BEND + 2] = bend_p, bend_q, bend_r / 9.0
    slack[0] = max(slack[0], bend_p * abs(row[INTO]) + bend_q * abs(row[INTO + 2]))
    slack[1] = max(slack[1], bend_p * abs(row[INTO + 1]) + bend_q * abs(row[INTO + 3]))
    offset = bend_p * (abs(row[INTO + 4]) + abs(row[INTO + 6])) + bend_q * (abs(row[INTO + 5]) + abs(row[INTO + 7]))
    slack[2] = max(slack[2], offset + bend_r / 9.0 + clearance_bend)
