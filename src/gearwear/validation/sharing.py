"""Two tooth pairs that share a force."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.optimize import brentq

from gearwear.mesh.sharing import Sharing, Springs, share


def _two_pairs(stiffness: np.ndarray, removed: Any, force: float) -> Sharing:
    springs = Springs(np.array(stiffness), np.zeros(2), np.array([1, 0]))
    return share(springs, np.array(removed), force)


def approach(stiffness: np.ndarray, removed: Any, force: float) -> float:
    """Return the approach (m) of two pairs: stiffness in N/m, material removed in m, force in N."""
    return _two_pairs(stiffness, removed, force).approach[0]


def forces(stiffness: np.ndarray, removed: np.ndarray, force: float) -> np.ndarray:
    """Return the force on either pair (N)."""
    return force * _two_pairs(stiffness, removed, force).load_share


def shares(stiffness: np.ndarray, removed: np.ndarray, force: float) -> np.ndarray:
    """Return the part of the force on either pair."""
    return _two_pairs(stiffness, removed, force).load_share


def separation(stiffness: np.ndarray, force: float) -> float:
    """Return the difference of removed material (m) from which on the second pair carries nothing."""
    return brentq(lambda e: _two_pairs(stiffness, [0.0, e], force).load_share[1] - 1e-12, 0.0, 1.0, xtol=1e-15)


def sudden(stiffness: np.ndarray, force: float) -> float:
    """Return the step of the approach (m) where the second pair loses contact, E_2 - E_1 = F/k_1."""
    threshold = force / stiffness[0]
    before, after = (approach(stiffness, [0.0, threshold * (1 + side * 1e-9)], force) for side in (-1, 1))
    return after - before


QUANTITIES = {
    "approach": approach,
    "forces": forces,
    "shares": shares,
    "separation": separation,
    "sudden": sudden,
}
