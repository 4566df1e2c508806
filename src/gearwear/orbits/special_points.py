"""Test functions of bifurcations: zero where a multiplier of an orbit leaves the unit circle.

    fold             det(M - 1) = (m1 - 1)(m2 - 1)       a multiplier at +1
    period doubling  det(M + 1) = (m1 + 1)(m2 + 1)       a multiplier at -1
    torus            det M - 1  = m1 m2 - 1, m complex   a complex pair of modulus 1

A polynomial of the matrix is smooth where the multipliers themselves are not, at a double one. Damping makes the
oscillator contract areas, det M = exp(-2 zeta T) < 1 for any forcing, so its branches hold no torus points; with a
second frequency quasi-periodic motions are forced, they do not bifurcate from periodic ones.
"""

from __future__ import annotations

import numpy as np

from gearwear.codes.branch_codes import FOLD, PERIOD_DOUBLING, TORUS


def margins(matrix: np.ndarray) -> np.ndarray:
    """Return the three test functions of a (2, 2) monodromy matrix: fold, period doubling, torus."""
    trace, determinant = np.trace(matrix), np.linalg.det(matrix)
    return np.array([1 - trace + determinant, 1 + trace + determinant, determinant - 1])


def crossings(before: np.ndarray, after: np.ndarray) -> list[int]:
    """Return the kinds of special points between two orbits with these monodromy matrices.

    The product of two real multipliers may pass 1 (a neutral saddle): that is no torus.
    """
    changed = (margins(before) < 0) != (margins(after) < 0)
    if max(_discriminant(before), _discriminant(after)) >= 0:
        changed[TORUS - 1] = False
    return [kind for kind, found in zip((FOLD, PERIOD_DOUBLING, TORUS), changed, strict=True) if found]


def _discriminant(matrix: np.ndarray) -> float:
    return np.trace(matrix) ** 2 - 4 * np.linalg.det(matrix)
