"""Sixteen states through a cell without a switching point: one loop without branches, made for vector registers."""

import math

import numpy as np

from gearwear.integrate.affine.affine_flow import stays
from gearwear.integrate.affine.affine_table import (
    CLEARANCE_HIGH,
    CLEARANCE_LOW,
    COMMON,
    CONTACT,
    FREE,
    HALF_WIDTH,
    STEP,
)
from gearwear.integrate.compiled import njit_inline, njit_noalloc

LANES = 16
# Columns of the plain steps: the map in contact (8), what of the free one is not 1 or 0 (4), half width, clearances.
FREE_STEP, HALF, LOW, HIGH, PLAIN = 8, 12, 13, 14, 15
# Places of the lanes, in units of LANES: state, state before the cell, side, tangent map before the cell, tangent map,
# growth.
X, V, X0, V0, SIDE, S0, S1, S2, S3, T0, T1, T2, T3, GROWN, PLACES = range(15)


@njit_noalloc
def stand_still(plain, n, lane):
    """Make a cell of a lane change nothing."""
    for column in range(PLAIN):
        plain[n, column * LANES + lane] = 0.0
    for column in (0, 3, FREE_STEP + 1):
        plain[n, column * LANES + lane] = 1.0
    plain[n, LOW * LANES + lane] = np.inf
    plain[n, HIGH * LANES + lane] = -np.inf


@njit_noalloc
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


@njit_inline
def plain_steps(cell, slack, lanes, vectors):
    """Step every lane through a cell on its branch, with 0 to 2 tangent vectors.

    Returns the lanes that may have met a switching point, bit by bit.
    """
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
        doubtful |= 0 if sure else 1 << lane
        lanes[X0 * LANES + lane], lanes[V0 * LANES + lane] = x, v
        lanes[X * LANES + lane], lanes[V * LANES + lane] = x1, v1
        if vectors >= 1:
            p, q = lanes[T0 * LANES + lane], lanes[T2 * LANES + lane]
            lanes[S0 * LANES + lane], lanes[S2 * LANES + lane] = p, q
            lanes[T0 * LANES + lane], lanes[T2 * LANES + lane] = m0 * p + m1 * q, m2 * p + m3 * q
        if vectors == 2:
            p, q = lanes[T1 * LANES + lane], lanes[T3 * LANES + lane]
            lanes[S1 * LANES + lane], lanes[S3 * LANES + lane] = p, q
            lanes[T1 * LANES + lane], lanes[T3 * LANES + lane] = m0 * p + m1 * q, m2 * p + m3 * q
    return doubtful


@njit_inline
def make_unit(lanes):
    """Make the first tangent vector of every lane one of length 1; its square length goes to GROWN."""
    for lane in range(LANES):
        p, q = lanes[T0 * LANES + lane], lanes[T2 * LANES + lane]
        square = p * p + q * q
        share = 1.0 / math.sqrt(square)
        lanes[T0 * LANES + lane], lanes[T2 * LANES + lane] = p * share, q * share
        lanes[GROWN * LANES + lane] = square
