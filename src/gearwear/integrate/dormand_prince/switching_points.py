"""Where a step with the branch frozen leaves its branch: |x| = b, located by re-stepping.

The margin m of a branch (side x - b in contact, b - side x without) is positive inside it. The quintic Hermite
polynomial through m, m', m'' at both ends of a step is as accurate as the step; it tells whether m can vanish, or
only graze zero, inside the step. The crossing itself is a root of the integrated solution, not of the polynomial.
"""

from gearwear.integrate.compiled import njit
from gearwear.integrate.dormand_prince.dormand_prince import FRICTION, linear_step, stage_loads

CLEAR, EXIT, GRAZE, UNDECIDED = 0, 1, 2, 3
ROUND_OFF = 1e-14


@njit
def quintic(f0, d0, s0, f1, d1, s1):
    """Cubic to quintic coefficients on [0, 1] from values, slopes and curvatures at 0 and 1."""
    f, d, s = f1 - f0 - d0 - 0.5 * s0, d1 - d0 - s0, s1 - s0
    return 10 * f - 4 * d + 0.5 * s, -15 * f + 7 * d - s, 6 * f - 3 * d + 0.5 * s


@njit
def turning_point(d0, s0, c3, c4, c5):
    """Root in (0, 1) of the quintic's slope, which changes sign once; Newton's method kept in its bracket."""
    low, high = 0.0, 1.0
    rising = d0 > 0.0 or (d0 == 0.0 and s0 > 0.0)
    u = 0.5
    for _ in range(60):
        slope = d0 + u * (s0 + u * (3 * c3 + u * (4 * c4 + u * 5 * c5)))
        if (slope > 0.0) == rising:
            low = u
        else:
            high = u
        curvature = s0 + u * (6 * c3 + u * (12 * c4 + u * 20 * c5))
        following = u - slope / curvature if curvature != 0.0 else -1.0
        if not low <= following <= high:
            following = 0.5 * (low + high)
        if abs(following - u) < 1e-15:
            return following
        u = following
    return u


@njit
def highest_value(h, f0, d0, s0, f1, d1, s1):
    """Largest value over a step of length h from values, slopes and curvatures at its ends."""
    highest = max(f0, f1)
    if d0 > 0.0 and d1 < 0.0:
        d0, s0, d1, s1 = d0 * h, s0 * h * h, d1 * h, s1 * h * h
        c3, c4, c5 = quintic(f0, d0, s0, f1, d1, s1)
        u = turning_point(d0, s0, c3, c4, c5)
        highest = max(highest, f0 + u * (d0 + u * (0.5 * s0 + u * (c3 + u * (c4 + u * c5)))))
    return highest


@njit
def highest_force(h, side, x0, v0, before, x1, v1, after):
    """Largest k (side x - b) over a step in contact: cubic through its values and rates at the ends."""
    k0, _, b0, dk0, db0, _ = before
    k1, _, b1, dk1, db1, _ = after
    f0, f1 = k0 * (side * x0 - b0), k1 * (side * x1 - b1)
    r0 = dk0 * (side * x0 - b0) + k0 * (side * v0 - db0)
    r1 = dk1 * (side * x1 - b1) + k1 * (side * v1 - db1)
    chord = 6.0 * (f1 - f0) / h
    return highest_value(h, f0, r0, (chord - 4 * r0 - 2 * r1) / h, f1, r1, (2 * r0 + 4 * r1 - chord) / h)


@njit
def first_exit(h, m0, d0, s0, m1, d1, s1, band):
    """Whether a margin vanishes inside a step: (verdict, lower end, upper end) in shares of the step.

    EXIT: it does, first inside the bracket given. GRAZE: its minimum, at the upper end, is within the band of
    zero. UNDECIDED: it turns more than once near zero; take a shorter step.
    """
    d0, s0, d1, s1 = d0 * h, s0 * h * h, d1 * h, s1 * h * h
    c3, c4, c5 = quintic(m0, d0, s0, m1, d1, s1)
    # Bernstein coefficients of the slope: their sign changes bound the number of its roots.
    b1, b2, b3 = d0 + 0.25 * s0, d0 + 0.5 * s0 + 0.5 * c3, d1 - 0.25 * s1
    reach = max(max(abs(d0), abs(d1)), max(abs(b1), max(abs(b2), abs(b3))))
    if m0 + m1 > reach:
        return CLEAR, 0.0, 1.0
    if reach < ROUND_OFF:
        return (EXIT if m1 < 0.0 else CLEAR), 0.0, 1.0
    changes, last = 0, 0.0
    for slope in (d0, b1, b2, b3, d1):
        if slope != 0.0:
            if slope * last < 0.0:
                changes += 1
            last = slope
    if changes == 0 or (changes > 1 and h < 1e-6):
        return (EXIT if m1 < 0.0 else CLEAR), 0.0, 1.0
    if changes > 1:
        return UNDECIDED, 0.0, 1.0
    u = turning_point(d0, s0, c3, c4, c5)
    if last < 0.0:
        return (EXIT if m1 < 0.0 else CLEAR), u, 1.0
    if m1 < 0.0:
        return EXIT, 0.0, u
    if u * h < 1e-7:
        return CLEAR, 0.0, 1.0
    least = m0 + u * (d0 + u * (0.5 * s0 + u * (c3 + u * (c4 + u * c5))))
    if least < -band:
        return EXIT, 0.0, u
    return (GRAZE if least < band else CLEAR), 0.0, u


@njit
def margin_after(cell, harmonics, branch, side, t, h, x, v, before):
    """Margin to the switching point at side b, its rate and its curvature after a step h from (x, v) at t."""
    stiffness, force, after = stage_loads(cell, harmonics, branch, t, h, before)
    x, v, a, _, _ = linear_step(h, cell[FRICTION], x, v, stiffness, force)
    return margin(branch, side, x, v, a, after)


@njit
def margin(branch, side, x, v, a, at):
    """Margin of a branch to the switching point at side b, its rate and its curvature; ``at`` is full_load there."""
    inward = 1.0 if branch != 0 else -1.0
    return inward * (side * x - at[2]), inward * (side * v - at[4]), inward * (side * a - at[5])


@njit
def locate_exit(cell, harmonics, branch, side, t, x, v, low, high, before):
    """Step length in [low, high] after which the integrated margin vanishes, to round-off."""
    h = high
    for _ in range(100):
        gap, rate, _ = margin_after(cell, harmonics, branch, side, t, h, x, v, before)
        if gap == 0.0 or (abs(gap) < 4e-16 and rate < 0.0):
            return h
        if gap > 0.0:
            low = h
        else:
            high = h
        following = h - gap / rate if rate < 0.0 else low - 1.0
        if not low < following < high:
            following = 0.5 * (low + high)
        if following in (low, high) or abs(following - h) < 1e-17:
            return following
        h = following
    return h


@njit
def locate_turn(cell, harmonics, branch, side, t, x, v, h, before):
    """Step length near h after which the integrated margin is least, and that margin."""
    gap, rate, curvature = margin_after(cell, harmonics, branch, side, t, h, x, v, before)
    for _ in range(3):
        if curvature <= 0.0 or abs(rate) > 0.5 * h * curvature or abs(rate) < 1e-12:
            break
        h -= rate / curvature
        gap, rate, curvature = margin_after(cell, harmonics, branch, side, t, h, x, v, before)
    return h, gap


@njit
def exit_of_step(cell, harmonics, branch, t, h, start, end, before, after, band):
    """First departure from the branch inside a step: (verdict, step length to it, flank).

    ``start`` and ``end`` are (x, v, a), ``before`` and ``after`` full_load at both ends. After EXIT or GRAZE the
    step is to end at the length given: on the switching point, or where the margin is least but not negative.
    """
    x, v, a = start
    x1, v1, a1 = end
    verdict, length, flank = CLEAR, h, branch
    for side in (1, -1):
        if branch == -side:
            continue
        m0, d0, s0 = margin(branch, side, x, v, a, before)
        m1, d1, s1 = margin(branch, side, x1, v1, a1, after)
        found, low, high = first_exit(h, m0, d0, s0, m1, d1, s1, band)
        if found == UNDECIDED:
            return UNDECIDED, h, side
        at = h
        if found == GRAZE:
            at, least = locate_turn(cell, harmonics, branch, side, t, x, v, high * h, before)
            if least < 0.0:
                found, low, high = EXIT, 0.0, at / h
        if found == EXIT:
            at = locate_exit(cell, harmonics, branch, side, t, x, v, low * h, high * h, before)
        if found != CLEAR and (verdict == CLEAR or at < length):
            verdict, length, flank = found, at, side
    return verdict, length, flank


@njit
def branch_at(x, v, a, at):
    """Branch of a state: by position, on a switching point by velocity, and at rest there by acceleration."""
    side = 1 if x >= 0.0 else -1
    gap = side * x - at[2]
    if gap == 0.0:
        gap = side * v - at[4]
        if abs(gap) < 1e-13:
            gap = side * a - at[5]
    return side if gap > 0.0 else 0
