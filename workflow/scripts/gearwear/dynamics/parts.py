"""How the points of a sweep are dealt to its parts."""

from __future__ import annotations

import numpy as np


def indices(points: int, item: str, order: str) -> np.ndarray:
    """Return the points that one part computes, in the order in which it does.

    Points that all start from rest are dealt in turn, so that no part gets all the long ones. A sweep that carries the
    state from point to point (`up`, `down`) is one chain and belongs whole to the first part.

    Parameters
    ----------
    points : number of points of the sweep.
    item : name of the part, "2-of-4".
    order : `restart`, `up` or `down`.
    """
    part, parts = (int(word) for word in item.split("-of-"))
    everything = np.arange(points)
    if order == "restart":
        return everything[part - 1 :: parts]
    if part > 1:
        return everything[:0]
    return everything if order == "up" else everything[::-1]
