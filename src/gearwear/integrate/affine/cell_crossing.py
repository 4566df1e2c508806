"""The motion through one cell of the forcing period with the switching points it meets.

At a switching point, |x| = b, the state enters the other branch as that motion which passes through it at this instant;
its virtual state in the middle of the cell solves two linear equations. The field is continuous there, so tangent
vectors pass unchanged: they go through the same matrices.
"""

from gearwear.integrate.affine.affine_table import (
    BEND,
    CLEARANCE_BEND,
    COMMON,
    CONTACT,
    END_CLEARANCE,
    FORCE_START,
    FREE,
    FRICTION,
    HALF_WIDTH,
    INTO,
    OUT,
    RATE,
    WAVES,
)
from gearwear.integrate.affine.cell_exit import READY, clearance_at, first_exit
from gearwear.integrate.affine.cell_extremes import note_piece
from gearwear.integrate.affine.cell_series import R_CLEARANCE, R_FORCE, TERMS, P, Q
from gearwear.integrate.compiled import njit_inline, njit_noalloc
from gearwear.integrate.status import IMPACTS, LARGEST_INSIDE, RECORDS, STATES

MAP = 49  # place in the work array, after those of cell_exit, of the cell's tangent map
MOST_CROSSINGS = 200


@njit_inline
def affine(branch, start, side, x, v):
    """A map of the row of a branch: see affine_table.finish_maps."""
    return (
        (branch[start] * x + branch[start + 1] * v) + (branch[start + 4] + side * branch[start + 6]),
        (branch[start + 2] * x + branch[start + 3] * v) + (branch[start + 5] + side * branch[start + 7]),
    )


@njit_inline
def series_and_slope(branch, wave, rate, s):
    """One of P, Q, R_F, R_b of a branch at s, and its derivative by time; four interleaved Horner schemes in s^4."""
    c = WAVES + wave * TERMS
    square = s * s
    f = square * square
    a0, b0, c0, d0 = branch[c + 12], branch[c + 13], branch[c + 14], branch[c + 15]
    a, da = a0 * f + branch[c + 8], a0
    b, db = b0 * f + branch[c + 9], b0
    g, dg = c0 * f + branch[c + 10], c0
    h, dh = d0 * f + branch[c + 11], d0
    da, a = da * f + a, a * f + branch[c + 4]
    db, b = db * f + b, b * f + branch[c + 5]
    dg, g = dg * f + g, g * f + branch[c + 6]
    dh, h = dh * f + h, h * f + branch[c + 7]
    da, a = da * f + a, a * f + branch[c]
    db, b = db * f + b, b * f + branch[c + 1]
    dg, g = dg * f + g, g * f + branch[c + 2]
    dh, h = dh * f + h, h * f + branch[c + 3]
    value = (a + s * b) + square * (g + s * h)
    slope = (b + s * (2.0 * g)) + square * (3.0 * h) + 4.0 * (square * s) * ((da + s * db) + square * (dg + s * dh))
    return value, slope * rate


@njit_inline
def fundamental_at(branch, free, rate, s):
    """P, Q of a branch at s and their derivatives by time; without contact P is 1."""
    p, dp = (1.0, 0.0) if free else series_and_slope(branch, P, rate, s)
    q, dq = series_and_slope(branch, Q, rate, s)
    return p, q, dp, dq


@njit_inline
def response_at(branch, side, rate, s):
    """R_F + side R_b of a branch at s and its derivative by time."""
    f, df = series_and_slope(branch, R_FORCE, rate, s)
    if side == 0.0:
        return f, df
    b, db = series_and_slope(branch, R_CLEARANCE, rate, s)
    return f + side * b, df + side * db


@njit_inline
def side_at_start(common, x, v):
    """Branch of a state at the start of a cell: by position, where |x| = b by velocity, at rest by acceleration."""
    side = 1.0 if x >= 0.0 else -1.0
    gap = side * x - common[END_CLEARANCE]
    if gap == 0.0:
        gap = side * v - common[END_CLEARANCE + 1]
        if abs(gap) < 1e-13:
            gap = side * (common[FORCE_START] - common[FRICTION] * v)
    return side if gap > 0.0 else 0.0


@njit_inline
def exit_of_branch(common, branch, middle, low, x, v, x1, v1, work):
    """First departure from a branch between s = low and the end of a cell, from the states at both ends.

    Returns
    -------
    flank, s, slope : 1 or -1 (0 if there is none), where, and flank x's slope by s there
    """
    side, half = middle[0], common[HALF_WIDTH]
    b0, slope0, _ = clearance_at(common, low)
    b1, slope1 = common[END_CLEARANCE + 2], common[END_CLEARANCE + 3] * half
    bend = (branch[BEND] * abs(middle[1]) + branch[BEND + 1] * abs(middle[2])) + branch[BEND + 2]
    bend += common[CLEARANCE_BEND]
    if side != 0.0:
        m0, d0 = side * x - b0, side * v * half - slope0
        m1, d1 = side * x1 - b1, side * v1 * half - slope1
        found, s, slope = first_exit(common, branch, middle, work, 1.0, side, low, m0, d0, m1, d1, bend)
        return (side if found else 0.0), s, slope
    left, at, rate = 0.0, 1.0, 0.0
    for flank in (1.0, -1.0):
        m0, d0 = b0 - flank * x, slope0 - flank * v * half
        m1, d1 = b1 - flank * x1, slope1 - flank * v1 * half
        found, s, slope = first_exit(common, branch, middle, work, -1.0, flank, low, m0, d0, m1, d1, bend)
        if found and (left == 0.0 or s < at):
            left, at, rate = flank, s, -slope
    return left, at, rate


@njit_noalloc
def cross_cell(cell, side, x, v, detail, work, record, lane):
    """Carry a state through a cell.

    Writes the tangent map of the cell to the place MAP of ``work`` and updates the row ``lane`` of the record, each if
    the detail asks for it.

    Returns
    -------
    x, v, side : at the end of the cell, before its kick
    completed : False if there are too many crossings or the state is not finite
    """
    low, with_map = -1.0, detail > STATES
    common = cell[COMMON]
    branch = cell[CONTACT if side != 0.0 else FREE]
    x_middle, v_middle = affine(branch, INTO, side, x, v)
    a, b, c, d = branch[INTO], branch[INTO + 1], branch[INTO + 2], branch[INTO + 3]
    completed = False
    for _ in range(MOST_CROSSINGS):
        x1, v1 = affine(branch, OUT, side, x_middle, v_middle)
        if not (abs(x1) < LARGEST_INSIDE and abs(v1) < LARGEST_INSIDE):
            break
        work[READY] = 0.0
        flank, s, slope = exit_of_branch(common, branch, (side, x_middle, v_middle), low, x, v, x1, v1, work)
        if flank == 0.0:
            completed = True
            break
        clearance, clearance_slope, _ = clearance_at(common, s)
        x0, v0, x, v = x, v, flank * clearance, flank * (slope + clearance_slope) * common[RATE]
        if detail == RECORDS:
            note_piece(common, branch, (side, x_middle, v_middle), low, x0, v0, s, x, v, work, record, lane)
            if side == 0.0:
                record[lane, IMPACTS] += 1.0
        if with_map:
            p, q, dp, dq = fundamental_at(branch, side == 0.0, common[RATE], s)
            a, b, c, d = p * a + q * c, p * b + q * d, dp * a + dq * c, dp * b + dq * d
        side = flank if side == 0.0 else 0.0
        branch = cell[CONTACT if side != 0.0 else FREE]
        p, q, dp, dq = fundamental_at(branch, side == 0.0, common[RATE], s)
        f, df = response_at(branch, side, common[RATE], s)
        share = 1.0 / (p * dq - q * dp)
        gap_x, gap_v = x - f, v - df
        x_middle, v_middle = (dq * gap_x - q * gap_v) * share, (p * gap_v - dp * gap_x) * share
        if with_map:
            a, b, c, d = (
                (dq * a - q * c) * share,
                (dq * b - q * d) * share,
                (p * c - dp * a) * share,
                (p * d - dp * b) * share,
            )
        low = s
    if detail == RECORDS:
        note_piece(common, branch, (side, x_middle, v_middle), low, x, v, 1.0, x1, v1, work, record, lane)
    if with_map:
        p, q, dp, dq = branch[OUT], branch[OUT + 1], branch[OUT + 2], branch[OUT + 3]
        work[MAP], work[MAP + 1], work[MAP + 2], work[MAP + 3] = (
            p * a + q * c,
            p * b + q * d,
            dp * a + dq * c,
            dp * b + dq * d,
        )
    return x1, v1, side, completed
