"""Sixteen states through a cell that holds no corner for them: one loop without branches, made for vector registers."""

import numpy as np

from gearwear.dynamics.affine_flow import stays
from gearwear.dynamics.affine_table import (
    CLEARANCE_HIGH,
    CLEARANCE_LOW,
    COMMON,
    CONTACT,
    FREE,
    HALF_WIDTH,
    STEP,
)
from gearwear.dynamics.compiled import borrowing, inlined

LANES = 16
# Columns of the plain steps: the map in contact (8), what of the free one is not 1 or 0 (4), half width, clearances.
FREE_STEP, HALF, LOW, HIGH, PLAIN = 8, 12, 13, 14, 15
# Places of the lanes, in units of LANES: state before and after, side, map of the cell, tangent map, whether it stays.
X, V, X1, V1, SIDE, M0, M1, M2, M3, T0, T1, T2, T3, STAYS, PLACES = range(15)


@borrowing
def stand_still(plain, n, lane):
    """Make a cell of a lane change nothing."""
    for column in range(PLAIN):
        plain[n, column * LANES + lane] = 0.0
    for column in (0, 3, FREE_STEP + 1):
        plain[n, column * LANES + lane] = 1.0
    plain[n, LOW * LANES + lane] = np.inf
    plain[n, HIGH * LANES + lane] = -np.inf


@borrowing
def pack_plain(rows, first, cells, plain, lane):
    """Copy what a plain step needs of the rows of a lane, the first of them ``first``."""
    for n in range(cells):
        r = first + n
        for column in range(8):
            plain[n, column * LANES + lane] = rows[r, CONTACT, STEP + column]
        for column, source in ((0, 1), (1, 3), (2, 4), (3, 5)):
            plain[n, (FREE_STEP + column) * LANES + lane] = rows[r, FREE, STEP + source]
        for column, source in ((HALF, HALF_WIDTH), (LOW, CLEARANCE_LOW), (HIGH, CLEARANCE_HIGH)):
            plain[n, column * LANES + lane] = rows[r, COMMON, source]


@inlined
def plain_steps(cell, slack, lanes):
    """Step every lane through a cell on its branch; returns 1 if one of them may have met a corner, else 0."""
    doubtful = 0
    for lane in range(LANES):
        x, v, side = lanes[X * LANES + lane], lanes[V * LANES + lane], lanes[SIDE * LANES + lane]
        a0, a1, a2, a3 = cell[lane], cell[LANES + lane], cell[2 * LANES + lane], cell[3 * LANES + lane]
        fx, fv = cell[4 * LANES + lane], cell[5 * LANES + lane]
        bx, bv = cell[6 * LANES + lane], cell[7 * LANES + lane]
        b1, b3 = cell[FREE_STEP * LANES + lane], cell[(FREE_STEP + 1) * LANES + lane]
        gx, gv = cell[(FREE_STEP + 2) * LANES + lane], cell[(FREE_STEP + 3) * LANES + lane]
        half, low, high = cell[HALF * LANES + lane], cell[LOW * LANES + lane], cell[HIGH * LANES + lane]
        free = side == 0.0
        m0, m1 = (1.0 if free else a0), (b1 if free else a1)
        m2, m3 = (0.0 if free else a2), (b3 if free else a3)
        x1 = (m0 * x + m1 * v) + (gx if free else fx + side * bx)
        v1 = (m2 * x + m3 * v) + (gv if free else fv + side * bv)
        sure = stays(
            side,
            x,
            v,
            x1,
            v1,
            half,
            low,
            high,
            slack[lane],
            slack[LANES + lane],
            slack[2 * LANES + lane],
        )
        doubtful |= 0 if sure else 1
        lanes[X1 * LANES + lane], lanes[V1 * LANES + lane] = x1, v1
        lanes[M0 * LANES + lane], lanes[M1 * LANES + lane] = m0, m1
        lanes[M2 * LANES + lane], lanes[M3 * LANES + lane] = m2, m3
        lanes[STAYS * LANES + lane] = 1.0 if sure else 0.0
    return doubtful


@inlined
def turn_tangents(lanes, first, second):
    """Multiply a tangent vector of every lane, its components at two places, by the map of its cell."""
    for lane in range(LANES):
        p, q = lanes[first * LANES + lane], lanes[second * LANES + lane]
        lanes[first * LANES + lane] = lanes[M0 * LANES + lane] * p + lanes[M1 * LANES + lane] * q
        lanes[second * LANES + lane] = lanes[M2 * LANES + lane] * p + lanes[M3 * LANES + lane] * q


@inlined
def take_states(lanes):
    """Make the states after a cell those before the next."""
    for k in range(2 * LANES):
        lanes[X * LANES + k] = lanes[X1 * LANES + k]
