"""Where two sweeps over the same points in different orders met different motions."""

from __future__ import annotations

import numpy as np

from gearwear.codes.motion_class import LARGEST_PERIOD, NOT_CONVERGED

SAME_ORBIT = 2e-3  # of the half backlash; a section may still be 1e-3 away from its orbit: see classify.classify


def differing(classes: np.ndarray, sections: np.ndarray) -> np.ndarray:
    """Return at which points the two sweeps differ, (points,) bool.

    They do where the classes differ, and where both are periodic and their orbits are more than 2e-3 apart, whichever
    mesh period of either one begins with. Two chaotic motions count as one, and so do two quasi-periodic ones. A motion
    that has not converged is compared with nothing: no difference is shown there.

    Parameters
    ----------
    classes : (2, points) codes of the classes of motion; that of a periodic one is its period.
    sections : (2, points, samples, 2) displacement over b0 and velocity at mesh phase 0.
    """
    one, other = np.asarray(classes, dtype=int)
    differs = (one != other) & (one != NOT_CONVERGED) & (other != NOT_CONVERGED)
    for point in np.flatnonzero((one == other) & (one >= 1) & (one <= LARGEST_PERIOD)):
        period = one[point]
        differs[point] = distance(*(section[point, -period:] for section in sections)) > SAME_ORBIT
    return differs


def distance(one: np.ndarray, other: np.ndarray) -> float:
    """Return the largest distance of two orbits of one period, least over the mesh period that one begins with.

    Parameters
    ----------
    one, other : (period, 2) states at mesh phase 0, one a mesh period.
    """
    turned = (np.abs(np.roll(other, turn, axis=0) - one).max() for turn in range(len(one)))
    return float(min(turned))
