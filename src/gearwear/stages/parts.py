"""How the points of a sweep are dealt to its parts."""

from __future__ import annotations

import numpy as np


def indices(points: int, item: str) -> np.ndarray:
    """Return the points that one part computes.

    They are dealt in turn, so that no part gets all the long ones.

    Parameters
    ----------
    points : number of points of the sweep.
    item : name of the part, "2-of-4".
    """
    part, parts = (int(word) for word in item.split("-of-"))
    return np.arange(part - 1, points, parts)
