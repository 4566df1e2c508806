"""One step of the Dormand-Prince 5(4) pair for x'' + c x' + K(t) x = G(t), the oscillator with its branch frozen.

Dormand and Prince (1980), J. Comput. Appl. Math. 6, 19-26. On a branch (contact at x > b, no contact, contact at
x < -b) the oscillator is linear: K and G at the six stage times serve the state and both tangent vectors.
"""

import math

from gearwear.integrate.compiled import njit

FRICTION = 8  # place of 2 zeta in the tuple of a cell


@njit(inline="always")
def torque_at(harmonics, angle):
    """External torque at a phase of its first harmonic."""
    torque = 0.0
    for j in range(harmonics.shape[0]):
        if harmonics[j, 6] != 0.0 or harmonics[j, 7] != 0.0:
            torque += harmonics[j, 6] * math.cos((j + 1) * angle) + harmonics[j, 7] * math.sin((j + 1) * angle)
    return torque


@njit(inline="always")
def load(cell, harmonics, branch, t):
    """K and G on a branch (-1, 0, 1) at the time t, counted from the start of the period.

    ``cell`` is the tuple (frequency, stiffness at the start of the cell, its slope, time of that start, mean
    force, mean clearance, frequency of the external torque and its phase at t = 0, c = 2 zeta); ``harmonics`` has the
    cosine and sine coefficients of stiffness, force, clearance and torque in one row per harmonic.
    """
    frequency, stiffness, slope, start, force, clearance, torque_frequency, torque_phase, _ = cell
    stiffness += slope * (t - start)
    if harmonics.shape[0] > 0:
        c1, s1 = math.cos(frequency * t), math.sin(frequency * t)
        c, s = c1, s1
        for j in range(harmonics.shape[0]):
            stiffness += harmonics[j, 0] * c + harmonics[j, 1] * s
            force += harmonics[j, 2] * c + harmonics[j, 3] * s
            clearance += harmonics[j, 4] * c + harmonics[j, 5] * s
            c, s = c * c1 - s * s1, s * c1 + c * s1
    force += torque_at(harmonics, torque_frequency * t + torque_phase)
    if branch == 0:
        return 0.0, force
    return stiffness, force + stiffness * branch * clearance


@njit
def full_load(cell, harmonics, branch, t):
    """As load, and the rest: (K, G, clearance b, dk/dt, db/dt, d2b/dt2)."""
    frequency, stiffness, slope, start, force, clearance, torque_frequency, torque_phase, _ = cell
    stiffness += slope * (t - start)
    stiffness_rate, clearance_rate, clearance_curvature = slope, 0.0, 0.0
    if harmonics.shape[0] > 0:
        c1, s1 = math.cos(frequency * t), math.sin(frequency * t)
        c, s = c1, s1
        for j in range(harmonics.shape[0]):
            w = (j + 1) * frequency
            wave = harmonics[j, 4] * c + harmonics[j, 5] * s
            stiffness += harmonics[j, 0] * c + harmonics[j, 1] * s
            force += harmonics[j, 2] * c + harmonics[j, 3] * s
            clearance += wave
            stiffness_rate += w * (harmonics[j, 1] * c - harmonics[j, 0] * s)
            clearance_rate += w * (harmonics[j, 5] * c - harmonics[j, 4] * s)
            clearance_curvature -= w * w * wave
            c, s = c * c1 - s * s1, s * c1 + c * s1
    force += torque_at(harmonics, torque_frequency * t + torque_phase)
    if branch == 0:
        stiffness = 0.0
    force += stiffness * branch * clearance
    return stiffness, force, clearance, stiffness_rate, clearance_rate, clearance_curvature


@njit
def stage_loads(cell, harmonics, branch, t, h, before):
    """K and G at the stage times t + (0, 1/5, 3/10, 4/5, 8/9, 1) h, two tuples; ``before`` is full_load at t.

    Returns
    -------
    stiffness, force : tuples of K and of G
    after : full_load at the end of the step
    """
    k2, g2 = load(cell, harmonics, branch, t + 0.2 * h)
    k3, g3 = load(cell, harmonics, branch, t + 0.3 * h)
    k4, g4 = load(cell, harmonics, branch, t + 0.8 * h)
    k5, g5 = load(cell, harmonics, branch, t + 8.0 / 9.0 * h)
    after = full_load(cell, harmonics, branch, t + h)
    return (before[0], k2, k3, k4, k5, after[0]), (before[1], g2, g3, g4, g5, after[1]), after


@njit(inline="always")
def linear_step(h, c, x, v, stiffness, force):
    """One step of x'' + c x' + K x = G over h, with K and G at the stage times as from stage_loads.

    Returns
    -------
    x, v, a : displacement, velocity and acceleration after the step
    dx, dv : estimated errors of displacement and velocity
    """
    k1, k2, k3, k4, k5, k6 = stiffness
    g1, g2, g3, g4, g5, g6 = force
    a1 = g1 - c * v - k1 * x
    v2 = v + h * (1 / 5 * a1)
    a2 = g2 - c * v2 - k2 * (x + h * (1 / 5 * v))
    v3 = v + h * (3 / 40 * a1 + 9 / 40 * a2)
    a3 = g3 - c * v3 - k3 * (x + h * (3 / 40 * v + 9 / 40 * v2))
    v4 = v + h * (44 / 45 * a1 - 56 / 15 * a2 + 32 / 9 * a3)
    a4 = g4 - c * v4 - k4 * (x + h * (44 / 45 * v - 56 / 15 * v2 + 32 / 9 * v3))
    v5 = v + h * (19372 / 6561 * a1 - 25360 / 2187 * a2 + 64448 / 6561 * a3 - 212 / 729 * a4)
    x5 = x + h * (19372 / 6561 * v - 25360 / 2187 * v2 + 64448 / 6561 * v3 - 212 / 729 * v4)
    a5 = g5 - c * v5 - k5 * x5
    v6 = v + h * (9017 / 3168 * a1 - 355 / 33 * a2 + 46732 / 5247 * a3 + 49 / 176 * a4 - 5103 / 18656 * a5)
    x6 = x + h * (9017 / 3168 * v - 355 / 33 * v2 + 46732 / 5247 * v3 + 49 / 176 * v4 - 5103 / 18656 * v5)
    a6 = g6 - c * v6 - k6 * x6
    v7 = v + h * (35 / 384 * a1 + 500 / 1113 * a3 + 125 / 192 * a4 - 2187 / 6784 * a5 + 11 / 84 * a6)
    x7 = x + h * (35 / 384 * v + 500 / 1113 * v3 + 125 / 192 * v4 - 2187 / 6784 * v5 + 11 / 84 * v6)
    a7 = g6 - c * v7 - k6 * x7
    e1, e3, e4, e5, e6, e7 = 71 / 57600, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40
    dv = h * (e1 * a1 + e3 * a3 + e4 * a4 + e5 * a5 + e6 * a6 + e7 * a7)
    dx = h * (e1 * v + e3 * v3 + e4 * v4 + e5 * v5 + e6 * v6 + e7 * v7)
    return x7, v7, a7, dx, dv


@njit(inline="always")
def squared_error(tolerance, x, v, x_after, v_after, dx, dv):
    """Square of the estimated error over the allowed one, which is relative and, below 1, absolute."""
    ex = dx / (1.0 + max(abs(x), abs(x_after)))
    ev = dv / (1.0 + max(abs(v), abs(v_after)))
    return 0.5 * (ex * ex + ev * ev) / (tolerance * tolerance)
