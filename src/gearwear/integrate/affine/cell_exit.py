"""Where the motion inside a cell first leaves its branch: |x| = b, from the power series of the branch.

The margin m of a branch (side x - b in contact, b - flank x without) is positive inside it. Between two points it lies
in the hull of the Bernstein coefficients of a quartic: that of the Hermite cubic through m and dm/ds, its middle
coefficient widened by the bound L^4 max|m''''| / 144 of the remainder. The hull proves that m keeps its sign or that it
crosses zero once; where it proves neither the piece is halved. Nothing is sampled, so no grazing contact is missed.
"""

from gearwear.integrate.affine.affine_table import CLEARANCE, CLEARANCE_BEND, WAVES
from gearwear.integrate.affine.cell_series import DEGREE, TERMS
from gearwear.integrate.compiled import njit_inline

# Places in the work array: series of x, of dx/ds and of d2x/ds2, and whether they are up to date.
MOTION, SLOPE, CURVE, READY = 0, 16, 32, 48
ROUND_OFF = 1e-14
SIXTH = 1.0 / 6.0
MOST_PIECES = 400
NONE, CROSSES, UNDECIDED = 0, 1, 2


@njit_inline
def set_motion(branch, middle, work):
    """Write the series of the motion on a branch that passes through (side, x, v) in the middle of its cell."""
    side, x, v = middle
    for j in range(TERMS):
        work[MOTION + j] = (branch[WAVES + j] * x + branch[WAVES + TERMS + j] * v) + (
            branch[WAVES + 2 * TERMS + j] + side * branch[WAVES + 3 * TERMS + j]
        )
    for j in range(TERMS - 1):
        work[SLOPE + j] = (j + 1) * work[MOTION + j + 1]
    for j in range(TERMS - 2):
        work[CURVE + j] = (j + 1) * work[SLOPE + j + 1]
    work[READY] = 1.0


@njit_inline
def series_at(work, start, s):
    """Value of a series of TERMS coefficients; four interleaved Horner schemes in s^4."""
    square = s * s
    fourth = square * square
    a = work[start] + fourth * (work[start + 4] + fourth * (work[start + 8] + fourth * work[start + 12]))
    b = work[start + 1] + fourth * (work[start + 5] + fourth * (work[start + 9] + fourth * work[start + 13]))
    c = work[start + 2] + fourth * (work[start + 6] + fourth * (work[start + 10] + fourth * work[start + 14]))
    d = work[start + 3] + fourth * (work[start + 7] + fourth * (work[start + 11] + fourth * work[start + 15]))
    return (a + s * b) + square * (c + s * d)


@njit_inline
def short_series_at(work, start, s):
    """Value of the first eight terms of a series: within 1e-5 of it, a first approximation."""
    square = s * s
    fourth = square * square
    a, b = work[start] + fourth * work[start + 4], work[start + 1] + fourth * work[start + 5]
    c, d = work[start + 2] + fourth * work[start + 6], work[start + 3] + fourth * work[start + 7]
    return (a + s * b) + square * (c + s * d)


@njit_inline
def clearance_at(common, s):
    """Clearance b inside a cell, and its first and second derivative by s."""
    b, slope, curve = common[CLEARANCE], 0.0, 0.0
    if common[CLEARANCE_BEND] != 0.0:
        b = 0.0
        for n in range(DEGREE, -1, -1):
            curve = curve * s + 2.0 * slope
            slope = slope * s + b
            b = b * s + common[CLEARANCE + n]
    return b, slope, curve


@njit_inline
def margin_at(common, work, inward, flank, s):
    """Margin to the switching point at flank b, its slope and its curvature by s."""
    b, slope, curve = clearance_at(common, s)
    return (
        inward * (flank * series_at(work, MOTION, s) - b),
        inward * (flank * series_at(work, SLOPE, s) - slope),
        inward * (flank * series_at(work, CURVE, s) - curve),
    )


@njit_inline
def hull_verdict(length, m0, d0, m1, d1, bend):
    """Whether a margin, not negative at first, crosses zero in a piece: NONE, CROSSES (once) or UNDECIDED.

    ``bend`` bounds the change of the middle coefficient over a piece of length 2.
    """
    half = 0.5 * length
    bend *= half * half * half * half
    q1, q3 = m0 + 0.25 * length * d0, m1 - 0.25 * length * d1
    q2 = 0.5 * (m0 + m1) + SIXTH * length * (d0 - d1)
    if q1 >= 0.0 and q3 >= 0.0 and q2 >= bend and m1 >= 0.0:
        return NONE
    if m1 < 0.0 and (q1 >= 0.0 or q3 < 0.0) and (q3 < 0.0 or q2 >= bend) and (q1 >= 0.0 or q2 < -bend):
        return CROSSES
    if max(max(abs(m0), abs(m1)), max(max(abs(q1), abs(q3)), abs(q2) + bend)) < ROUND_OFF:
        return CROSSES if m1 < 0.0 else NONE
    return UNDECIDED


@njit_inline
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


@njit_inline
def better_guess(common, work, inward, flank, low, s, high):
    """One Newton step on the first terms of the margin, kept in its bracket."""
    b, slope, _ = clearance_at(common, s)
    d = inward * (flank * short_series_at(work, SLOPE, s) - slope)
    if d >= 0.0:
        return s
    return min(high, max(low, s - inward * (flank * short_series_at(work, MOTION, s) - b) / d))


@njit_inline
def locate(common, work, inward, flank, low, m0, d0, high, m1, d1):
    """Root of the margin in [low, high], where it falls below zero, and its slope there.

    Halley's method kept in its bracket; its last step is taken without another evaluation, if it is so small that the
    third derivative (with a constant clearance) or the second gives the slope to round-off.
    """
    if m0 <= 0.0 and d0 < 0.0:
        return low, d0
    length, last = high - low, 1e-6 if common[CLEARANCE_BEND] == 0.0 else 1e-8
    s = low + length * min(1.0, max(0.0, first_guess(m0, length * d0, m1, length * d1)))
    s = better_guess(common, work, inward, flank, low, s, high)
    d = d1
    for _ in range(80):
        m, d, c = margin_at(common, work, inward, flank, s)
        if m > 0.0:
            low = s
        else:
            high = s
        following = 0.5 * (low + high)
        if d < 0.0:
            change = -2.0 * m * d / (2.0 * d * d - m * c)
            trial = s + change
            if abs(change) < last and abs(change * c) <= -1e-5 * d:
                third = 6.0 * work[MOTION + 3] + s * (24.0 * work[MOTION + 4] + s * 60.0 * work[MOTION + 5])
                return min(1.0, trial), d + change * (c + 0.5 * change * inward * flank * third)
            if low < trial < high:
                following = trial
        if following in (low, high) or m == 0.0:
            return s, d
        s = following
    return s, d


@njit_inline
def first_exit(common, branch, middle, work, inward, flank, low, m0, d0, m_end, d_end, bend):
    """First departure of a branch at one flank between s = low and 1: (found, s, slope of the margin there).

    Parameters
    ----------
    common, branch : rows of the cell
    middle : (side, x, v) of the motion in the middle of the cell
    inward, flank : 1 in contact, -1 without; 1 or -1, the flank
    m0, d0, m_end, d_end : margin and its slope by s at both ends
    bend : see hull_verdict
    """
    high, m1, d1 = 1.0, m_end, d_end
    for _ in range(MOST_PIECES):
        length = high - low
        verdict = hull_verdict(length, m0, d0, m1, d1, bend)
        if verdict == NONE and high == 1.0:
            break
        if work[READY] == 0.0:
            set_motion(branch, middle, work)
        if verdict == CROSSES:
            s, slope = locate(common, work, inward, flank, low, m0, d0, high, m1, d1)
            return True, s, slope
        if verdict == NONE:
            low, m0, d0 = high, m1, d1
            high = min(1.0, low + 2.0 * length)
        else:
            high = low + 0.5 * length
        if high == 1.0:
            m1, d1 = m_end, d_end
        else:
            m1, d1, _ = margin_at(common, work, inward, flank, high)
    return False, 1.0, d_end
