"""One step of q'' + C q' + K q + g k(t) f(q_0; b(t)) = F(t) (1, 0, ...) on a branch: the power series of the motion.

On a branch of f (contact at q_0 > b, none, contact at q_0 < -b) the equations are linear, and k, F and b are series of
the time within the step; term by term they give the series of q and q'. The step ends where the branch does.
"""

import numpy as np

from gearwear.integrate.compiled import njit
from gearwear.integrate.taylor.power_series import DEGREE, NONE, TERMS, first_fall, value


@njit
def expand(damping, stiffness, pull, length, driven, side, state, motion, mesh):
    """Write the series of a motion on a branch.

    Parameters
    ----------
    damping, stiffness, pull : C, K (n, n) and g (n,)
    length : of the step
    driven : (3, TERMS) series of k, F and b over the step, its time from 0 to 1
    side : of the contact, 1 or -1, 0 without
    state : (2 n,) q_0, q_0', q_1, ... at its begin
    motion : (2 n, TERMS) where the series of the state go
    mesh : (2, TERMS) where those of side q_0 - b and of the mesh force go
    """
    for i in range(state.size):
        motion[i, 0] = state[i]
    for n in range(DEGREE):
        mesh[0, n] = side * motion[0, n] - driven[2, n]
        force = 0.0
        if side != 0:
            for m in range(n + 1):
                force += driven[0, m] * mesh[0, n - m]
            force *= side
        mesh[1, n] = force
        share = length / (n + 1)
        for i in range(pull.size):
            acceleration = -pull[i] * force
            for j in range(pull.size):
                acceleration -= damping[i, j] * motion[2 * j + 1, n] + stiffness[i, j] * motion[2 * j, n]
            if i == 0:
                acceleration += driven[1, n]
            motion[2 * i, n + 1] = share * motion[2 * i + 1, n]
            motion[2 * i + 1, n + 1] = share * acceleration
    mesh[0, DEGREE] = side * motion[0, DEGREE] - driven[2, DEGREE]
    mesh[1, DEGREE] = 0.0


@njit
def first_switch(side, clearance, displacement, mesh, margin, scratch):
    """Return the place in (0, 1] where a motion leaves its branch, NONE if it stays, and the flank it leaves it on."""
    if side != 0:
        return first_fall(mesh[0], scratch), side
    found, side = NONE, 0
    for flank in (1, -1):
        for n in range(TERMS):
            margin[n] = clearance[n] - flank * displacement[n]
        place = first_fall(margin, scratch)
        if place < found:
            found, side = place, flank
    return found, side


@njit
def branch_of(damping, stiffness, pull, length, driven, state, motion, mesh):
    """Branch of a state: by position, on a switching point by velocity, and at rest there by acceleration."""
    side = 1 if state[0] >= 0.0 else -1
    expand(damping, stiffness, pull, length, driven, 0, state, motion, mesh)
    for n, factor in ((0, 1.0), (1, 1.0 / length), (2, 2.0 / (length * length))):
        gap = factor * (side * motion[0, n] - driven[2, n])
        if n == 2 or abs(gap) > n * 1e-13:
            break
    return side if gap > 0.0 else 0


@njit
def cell_maps(damping, stiffness, pull, lengths, series):
    """(cells, 2, 2 n, 2 n) derivative of the state after a cell by that before it, free and in contact."""
    size = 2 * pull.size
    maps = np.empty((lengths.size, 2, size, size))
    driven, unit = np.zeros((3, TERMS)), np.empty(size)
    motion, mesh = np.empty((size, TERMS)), np.empty((2, TERMS))
    for cell in range(lengths.size):
        driven[0] = series[cell, 0]
        for side in range(2):
            for column in range(size):
                unit[:] = 0.0
                unit[column] = 1.0
                expand(damping, stiffness, pull, lengths[cell], driven, side, unit, motion, mesh)
                for i in range(size):
                    maps[cell, side, i, column] = value(motion[i], 1.0)
    return maps
