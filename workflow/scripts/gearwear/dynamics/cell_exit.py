"""Where the motion inside a cell first leaves its branch: |x| = b, from the power series of the branch.

The margin m of a branch (side x - b in contact, b - corner x without) is positive inside it. Between two points it lies
in the hull of the Bernstein coefficients of a quartic: that of the Hermite cubic through m and dm/ds, its middle
coefficient widened by the bound L^4 max|m''''| / 144 of the remainder. The hull proves that m keeps its sign or that it
crosses zero once; where it proves neither the piece is halved. Nothing is sampled, so no grazing contact is missed.
"""

from gearwear.dynamics.affine_table import (
    CLEARANCE,
    CLEARANCE_BEND,
    END_CLEARANCE,
    RATE,
    WAVES,
)
from gearwear.dynamics.cell_series import DEGREE, TERMS
from gearwear.dynamics.compiled import njit

# Places in the work array: series of x, of dx/ds and of d2x/ds2, and whether they are up to date.
MOTION, SLOPE, CURVE, READY = 0, 16, 32, 48
ROUND_OFF = 1e-14
MOST_PIECES = 400
NONE, CROSSES, UNDECIDED = 0, 1, 2


@njit
def set_motion(rows, r, place, side, x_middle, v_middle, work):
    """Write the series of the motion that passes through a state in the middle of a cell."""
    at = place + WAVES
    for j in range(TERMS):
        work[MOTION + j] = (rows[r, at + 4 * j] * x_middle + rows[r, at + 4 * j + 1] * v_middle) + (
            rows[r, at + 4 * j + 2] + side * rows[r, at + 4 * j + 3]
        )
    for j in range(TERMS - 1):
        work[SLOPE + j] = (j + 1) * work[MOTION + j + 1]
    for j in range(TERMS - 2):
        work[CURVE + j] = (j + 1) * work[SLOPE + j + 1]
    work[READY] = 1.0


@njit
def series_at(work, start, s):
    """Value of a series of TERMS coefficients; four interleaved Horner schemes in s^4."""
    square = s * s
    fourth = square * square
    a = work[start] + fourth * (work[start + 4] + fourth * (work[start + 8] + fourth * work[start + 12]))
    b = work[start + 1] + fourth * (work[start + 5] + fourth * (work[start + 9] + fourth * work[start + 13]))
    c = work[start + 2] + fourth * (work[start + 6] + fourth * (work[start + 10] + fourth * work[start + 14]))
    d = work[start + 3] + fourth * (work[start + 7] + fourth * (work[start + 11] + fourth * work[start + 15]))
    return (a + s * b) + square * (c + s * d)


@njit
def clearance_at(rows, r, s):
    """Clearance b inside a cell, and its first and second derivative by s."""
    b, slope, curve = rows[r, CLEARANCE], 0.0, 0.0
    if rows[r, CLEARANCE_BEND] != 0.0:
        b = 0.0
        for n in range(DEGREE, -1, -1):
            curve = curve * s + 2.0 * slope
            slope = slope * s + b
            b = b * s + rows[r, CLEARANCE + n]
    return b, slope, curve


@njit
def margin_at(rows, r, work, inward, corner, s):
    """Margin to the corner at corner b, its slope and its curvature by s."""
    b, slope, curve = clearance_at(rows, r, s)
    return (
        inward * (corner * series_at(work, MOTION, s) - b),
        inward * (corner * series_at(work, SLOPE, s) - slope),
        inward * (corner * series_at(work, CURVE, s) - curve),
    )


@njit
def hull_verdict(length, m0, d0, m1, d1, bend):
    """Whether a margin, not negative at first, crosses zero in a piece: NONE, CROSSES (once) or UNDECIDED.

    ``bend`` bounds the change of the middle coefficient over a piece of length 2.
    """
    half = 0.5 * length
    bend *= half * half * half * half
    q1, q3 = m0 + 0.25 * length * d0, m1 - 0.25 * length * d1
    q2 = 0.5 * (m0 + m1) + length / 6.0 * (d0 - d1)
    if q1 >= 0.0 and q3 >= 0.0 and q2 >= bend and m1 >= 0.0:
        return NONE
    if m1 < 0.0 and (q1 >= 0.0 or q3 < 0.0) and (q3 < 0.0 or q2 >= bend) and (q1 >= 0.0 or q2 < -bend):
        return CROSSES
    if max(max(abs(m0), abs(m1)), max(max(abs(q1), abs(q3)), abs(q2) + bend)) < ROUND_OFF:
        return CROSSES if m1 < 0.0 else NONE
    return UNDECIDED


@njit
def first_guess(m0, d0, m1, d1):
    """Approximate root in [0, 1] of a margin that falls below zero, from values and slopes at 0 and 1."""
    if d0 < 0.0:
        fall = m0 - m1
        t = m0 / fall
        g0, g1 = min(3.0, -fall / d0), (min(3.0, -fall / d1) if d1 < 0.0 else 3.0)
        return t + t * (1.0 - t) * ((g0 - 1.0) * (1.0 - t) - (g1 - 1.0) * t)
    c2, c3 = 3.0 * (m1 - m0) - 2.0 * d0 - d1, 2.0 * (m0 - m1) + d0 + d1
    u = 1.0
    for _ in range(3):
        slope = d0 + u * (2.0 * c2 + u * 3.0 * c3)
        if slope >= 0.0:
            break
        u = max(0.0, u - (m0 + u * (d0 + u * (c2 + u * c3))) / slope)
    return u


@njit
def locate(rows, r, work, inward, corner, low, m0, d0, high, m1, d1):
    """Root of the margin in [low, high], where it falls below zero, by Halley's method kept in its bracket."""
    if m0 <= 0.0 and d0 < 0.0:
        return low
    length = high - low
    s = low + length * min(1.0, max(0.0, first_guess(m0, length * d0, m1, length * d1)))
    for _ in range(80):
        m, d, c = margin_at(rows, r, work, inward, corner, s)
        if m > 0.0:
            low = s
        else:
            high = s
        change = high - low
        following = 0.5 * (low + high)
        if d < 0.0:
            bent = d - 0.5 * m * c / d
            if bent < 0.0:
                trial = s - m / bent
                if low <= trial <= high:
                    change, following = abs(m / bent), trial
                elif abs(m) < 1e-16:
                    return s
        if change < 1e-8 and change * abs(c) <= 1e-5 * abs(d):
            return following
        if following in (low, high) and change < 1e-15:
            return following
        s = following
    return s


@njit
def first_exit(rows, r, place, middle, work, inward, corner, low, m0, d0, m_end, d_end, bend):
    """First departure of a branch through one corner between s = low and 1: (found, s).

    Parameters
    ----------
    place, middle : branch and the (side, x, v) of its motion in the middle of the cell
    inward, corner : 1 in contact, -1 without; side of the corner
    m0, d0, m_end, d_end : margin and its slope by s at both ends
    bend : see hull_verdict
    """
    high, m1, d1 = 1.0, m_end, d_end
    for _ in range(MOST_PIECES):
        length = high - low
        verdict = hull_verdict(length, m0, d0, m1, d1, bend)
        if verdict == NONE and high == 1.0:
            return False, 1.0
        if work[READY] == 0.0:
            set_motion(rows, r, place, middle[0], middle[1], middle[2], work)
        if verdict == CROSSES:
            return True, locate(rows, r, work, inward, corner, low, m0, d0, high, m1, d1)
        if verdict == NONE:
            low, m0, d0 = high, m1, d1
            high = min(1.0, low + 2.0 * length)
        else:
            high = low + 0.5 * length
        if high == 1.0:
            m1, d1 = m_end, d_end
        else:
            m1, d1, _ = margin_at(rows, r, work, inward, corner, high)
    return False, 1.0


@njit
def ends_of_clearance(rows, r, s):
    """Clearance and its slope by s at a point and at the end of the cell."""
    b0, slope0, _ = clearance_at(rows, r, s)
    return b0, slope0, rows[r, END_CLEARANCE + 2], rows[r, END_CLEARANCE + 3] / rows[r, RATE]
