"""Extremes of displacement and mesh force inside a cell, from the power series of the branch.

The hull of cell_exit bounds the quantity over a piece; only where the bound exceeds what has been reached before is the
turning point computed.
"""

from gearwear.integrate.affine.affine_table import BEND, CLEARANCE, CLEARANCE_LOW, HALF_WIDTH, STIFFNESS, STIFFNESS_HIGH
from gearwear.integrate.affine.cell_exit import MOTION, READY, SIXTH, series_at, set_motion
from gearwear.integrate.affine.cell_series import TERMS, fourth_derivative_bound, product_series
from gearwear.integrate.compiled import njit_inline, njit_noalloc
from gearwear.integrate.status import FORCE, HIGHEST, LOST, LOWEST

# Places in the work array of the series of the mesh force, of its slope and of its curvature by s.
LOAD, LOAD_SLOPE, LOAD_CURVE = 64, 80, 96
WORK = 112
MOST_PIECES = 60


@njit_inline
def hull_top(length, f0, d0, f1, d1, bend):
    """Upper bound of a function over a piece; ``bend`` as in cell_exit.hull_verdict."""
    half = 0.5 * length
    q1, q3 = f0 + 0.25 * length * d0, f1 - 0.25 * length * d1
    q2 = 0.5 * (f0 + f1) + SIXTH * length * (d0 - d1) + bend * half * half * half * half
    return max(max(f0, f1), max(q2, max(q1, q3)))


@njit_inline
def turns_down_once(length, f0, d0, f1, d1, bend):
    """Whether the hull has its slopes first up, then down, with one change of sign."""
    half = 0.5 * length
    bend *= half * half * half * half
    q1, q3 = f0 + 0.25 * length * d0, f1 - 0.25 * length * d1
    q2 = 0.5 * (f0 + f1) + SIXTH * length * (d0 - d1)
    return d0 > 0.0 > d1 and (q2 - bend >= q1 or q3 <= q2 - bend) and (q2 + bend <= q1 or q3 >= q2 + bend or q3 <= q2)


@njit_noalloc
def top_of_turn(work, start, sign, low, high):
    """Value at the turning point between low, where the function rises, and high, where it falls."""
    s = 0.5 * (low + high)
    for _ in range(60):
        slope, curve = sign * series_at(work, start + TERMS, s), sign * series_at(work, start + 2 * TERMS, s)
        if slope > 0.0:
            low = s
        else:
            high = s
        following = s - slope / curve if curve < 0.0 else low - 1.0
        if not low <= following <= high:
            following = 0.5 * (low + high)
        if abs(following - s) < 1e-9:
            return sign * series_at(work, start, following)
        s = following
    return sign * series_at(work, start, s)


@njit_noalloc
def highest(work, start, sign, low, f0, d0, end, f_end, d_end, bend, best):
    """Largest value of sign times a series over [low, end], or ``best`` if that is larger."""
    high, f1, d1 = end, f_end, d_end
    for _ in range(MOST_PIECES):
        length = high - low
        best = max(best, max(f0, f1))
        top = hull_top(length, f0, d0, f1, d1, bend)
        settled = top <= best + 1e-15
        if not settled and turns_down_once(length, f0, d0, f1, d1, bend):
            best = max(best, top_of_turn(work, start, sign, low, high))
            settled = True
        if settled:
            if high == end:
                break
            low, f0, d0 = high, f1, d1
            high = min(end, low + 2.0 * length)
        else:
            high = low + 0.5 * length
        if high == end:
            f1, d1 = f_end, d_end
        else:
            f1, d1 = sign * series_at(work, start, high), sign * series_at(work, start + TERMS, high)
    return best


@njit_noalloc
def set_load(common, side, work):
    """Write the series of the mesh force k (side x - b) and of its derivatives, up to the degree kept."""
    margin = work[LOAD_CURVE : LOAD_CURVE + TERMS]
    for n in range(TERMS):
        margin[n] = side * work[MOTION + n] - common[CLEARANCE + n]
    product_series(margin, common[STIFFNESS:], work[LOAD:])
    work[LOAD + TERMS - 1] = 0.0
    for n in range(TERMS - 1):
        work[LOAD_SLOPE + n] = (n + 1) * work[LOAD + n + 1]
    work[LOAD_SLOPE + TERMS - 1] = 0.0
    for n in range(TERMS - 1):
        work[LOAD_CURVE + n] = (n + 1) * work[LOAD_SLOPE + n + 1]
    work[LOAD_CURVE + TERMS - 1] = 0.0


@njit_noalloc
def note_piece(common, branch, middle, low, x, v, high, x1, v1, work, record, lane):
    """Take the piece of a motion between s = low and high into the record of its period.

    Parameters
    ----------
    common, branch : rows of the cell
    middle : (side, x, v) of the motion in the middle of the cell
    x, v, x1, v1 : states at both ends
    work : work array; READY there tells whether the series of the motion is written
    record : (lanes, COLUMNS), of which the row ``lane`` is updated
    """
    side, half = middle[0], common[HALF_WIDTH]
    length = high - low
    bend = branch[BEND] * abs(middle[1]) + branch[BEND + 1] * abs(middle[2]) + branch[BEND + 2]
    d0, d1 = v * half, v1 * half
    record[lane, HIGHEST] = max(record[lane, HIGHEST], max(x, x1))
    record[lane, LOWEST] = min(record[lane, LOWEST], min(x, x1))
    top = hull_top(length, x, d0, x1, d1, bend)
    bottom = -hull_top(length, -x, -d0, -x1, -d1, bend)
    load = 0.0
    if side == 0.0:
        record[lane, LOST] += length * half
    else:
        load = common[STIFFNESS_HIGH] * (max(side * top, side * bottom) - common[CLEARANCE_LOW])
    higher, lower = top > record[lane, HIGHEST], bottom < record[lane, LOWEST]
    heavier = load > record[lane, FORCE]
    if (higher or lower or heavier) and work[READY] == 0.0:
        set_motion(branch, middle, work)
    if higher:
        best = record[lane, HIGHEST]
        record[lane, HIGHEST] = highest(work, MOTION, 1.0, low, x, d0, high, x1, d1, bend, best)
    if lower:
        best = -record[lane, LOWEST]
        record[lane, LOWEST] = -highest(work, MOTION, -1.0, low, -x, -d0, high, -x1, -d1, bend, best)
    if heavier:
        set_load(common, side, work)
        bend = fourth_derivative_bound(work, LOAD) / 9.0
        f0, d0 = series_at(work, LOAD, low), series_at(work, LOAD_SLOPE, low)
        f1, d1 = series_at(work, LOAD, high), series_at(work, LOAD_SLOPE, high)
        record[lane, FORCE] = highest(work, LOAD, 1.0, low, f0, d0, high, f1, d1, bend, record[lane, FORCE])
