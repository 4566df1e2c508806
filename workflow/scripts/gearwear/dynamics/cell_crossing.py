"""The motion through one cell of the forcing period with the corners it meets.

At a corner the state enters the other branch as that motion which passes through it at this instant; its virtual state
in the middle of the cell solves two linear equations. The field is continuous at the corner, so tangent vectors pass
unchanged: they go through the same matrices.
"""

from gearwear.dynamics.affine_table import (
    BEND,
    CLEARANCE_BEND,
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
from gearwear.dynamics.cell_exit import READY, clearance_at, ends_of_clearance, first_exit, margin_at, set_motion
from gearwear.dynamics.cell_extremes import IMPACTS, note_piece
from gearwear.dynamics.cell_series import DEGREE
from gearwear.dynamics.compiled import njit

STATES, GROWTH, MAPS, RECORDS = range(4)
MAP = 49  # place in the work array, after those of cell_exit, of the cell's tangent map
MOST_CROSSINGS = 200


@njit
def affine(rows, r, start, side, x, v):
    """A map of a row: see affine_table.finish_maps."""
    return (
        (rows[r, start] * x + rows[r, start + 1] * v) + (rows[r, start + 4] + side * rows[r, start + 6]),
        (rows[r, start + 2] * x + rows[r, start + 3] * v) + (rows[r, start + 5] + side * rows[r, start + 7]),
    )


@njit
def fundamental_at(rows, r, place, s):
    """P, Q, R_F, R_b of a branch at s, and their derivatives by time."""
    at, rate = place + WAVES, rows[r, RATE]
    p, q, f, b = rows[r, at], rows[r, at + 1], rows[r, at + 2], rows[r, at + 3]
    dp, dq, df, db = 0.0, 0.0, 0.0, 0.0
    power = 1.0
    for j in range(1, DEGREE + 1):
        at += 4
        slope = j * power
        power *= s
        p += rows[r, at] * power
        q += rows[r, at + 1] * power
        f += rows[r, at + 2] * power
        b += rows[r, at + 3] * power
        dp += rows[r, at] * slope
        dq += rows[r, at + 1] * slope
        df += rows[r, at + 2] * slope
        db += rows[r, at + 3] * slope
    return p, q, f, b, dp * rate, dq * rate, df * rate, db * rate


@njit
def side_at_start(rows, r, x, v):
    """Branch of a state at the start of a cell: by position, on the corner by velocity, at rest by acceleration."""
    side = 1.0 if x >= 0.0 else -1.0
    gap = side * x - rows[r, END_CLEARANCE]
    if gap == 0.0:
        gap = side * v - rows[r, END_CLEARANCE + 1]
        if abs(gap) < 1e-13:
            gap = side * (rows[r, FORCE_START] - rows[r, FRICTION] * v)
    return side if gap > 0.0 else 0.0


@njit
def exit_of_branch(rows, r, place, middle, low, x, v, x1, v1, work):
    """First departure from a branch between s = low and the end of a cell: (corner or 0, s); states at both ends."""
    side, half = middle[0], rows[r, HALF_WIDTH]
    b0, slope0, b1, slope1 = ends_of_clearance(rows, r, low)
    bend = rows[r, place + BEND] * abs(middle[1]) + rows[r, place + BEND + 1] * abs(middle[2])
    bend += rows[r, place + BEND + 2] + rows[r, CLEARANCE_BEND]
    left, at = 0.0, 1.0
    inward = 1.0 if side != 0.0 else -1.0
    for corner in (1.0, -1.0):
        if side == -corner:
            continue
        m0, d0 = inward * (corner * x - b0), inward * (corner * v * half - slope0)
        m1, d1 = inward * (corner * x1 - b1), inward * (corner * v1 * half - slope1)
        found, s = first_exit(rows, r, place, middle, work, inward, corner, low, m0, d0, m1, d1, bend)
        if found and (left == 0.0 or s < at):
            left, at = corner, s
    return left, at


@njit
def cross_cell(rows, r, side, x, v, detail, work, record, lane):
    """Carry a state through a cell.

    Writes the tangent map of the cell to the place MAP of ``work`` and updates the row ``lane`` of the record, each if
    the detail asks for it.

    Returns
    -------
    x, v, side : at the end of the cell, before its kick
    completed : False if there are too many crossings or the state is not finite
    """
    low, with_map = -1.0, detail > STATES
    place = CONTACT if side != 0.0 else FREE
    x_middle, v_middle = affine(rows, r, place + INTO, side, x, v)
    a, b, c, d = 1.0, 0.0, 0.0, 1.0
    if with_map:
        at = place + INTO
        a, b, c, d = rows[r, at], rows[r, at + 1], rows[r, at + 2], rows[r, at + 3]
    completed = False
    for _ in range(MOST_CROSSINGS):
        x1, v1 = affine(rows, r, place + OUT, side, x_middle, v_middle)
        if not (abs(x1) < 1e100 and abs(v1) < 1e100):
            break
        work[READY] = 0.0
        corner, s = exit_of_branch(rows, r, place, (side, x_middle, v_middle), low, x, v, x1, v1, work)
        if corner == 0.0:
            completed = True
            break
        if work[READY] == 0.0:
            set_motion(rows, r, place, side, x_middle, v_middle, work)
        m, slope, curve = margin_at(rows, r, work, 1.0, corner, s)
        clearance, clearance_slope, _ = clearance_at(rows, r, s)
        x0, v0, x, v = x, v, corner * clearance, corner * (slope + clearance_slope) * rows[r, RATE]
        if detail == RECORDS:
            note_piece(rows, r, place, (side, x_middle, v_middle), low, x0, v0, s, x, v, work, record, lane)
            if side == 0.0:
                record[lane, IMPACTS] += 1.0
        if with_map:
            p, q, _, _, dp, dq, _, _ = fundamental_at(rows, r, place, s)
            a, b, c, d = p * a + q * c, p * b + q * d, dp * a + dq * c, dp * b + dq * d
        if side == 0.0:
            side, place = corner, CONTACT
        else:
            side, place = 0.0, FREE
        p, q, f, e, dp, dq, df, de = fundamental_at(rows, r, place, s)
        share = 1.0 / (p * dq - q * dp)
        gap_x, gap_v = x - (f + side * e), v - (df + side * de)
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
        note_piece(rows, r, place, (side, x_middle, v_middle), low, x, v, 1.0, x1, v1, work, record, lane)
    if with_map:
        at = place + OUT
        p, q, dp, dq = rows[r, at], rows[r, at + 1], rows[r, at + 2], rows[r, at + 3]
        work[MAP], work[MAP + 1], work[MAP + 2], work[MAP + 3] = (
            p * a + q * c,
            p * b + q * d,
            dp * a + dq * c,
            dp * b + dq * d,
        )
    return x1, v1, side, completed
