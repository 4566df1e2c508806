"""The axes of maps: the mesh frequency and, across it, another parameter of the oscillator or a state of the pair."""

from __future__ import annotations

from typing import Any

import numpy as np

COORDINATES = {
    "ste": "ste",
    "backlash": "backlash",
    "temperature": "bulk_temperature",
    "wear": "running_cycles",
}


def values(axis: dict[str, Any] | list[float]) -> np.ndarray:
    """Return the values of an axis, a list or given by `first`, `last` and `points`."""
    if isinstance(axis, list):
        return np.array(axis, dtype=float)
    return np.linspace(axis["first"], axis["last"], axis["points"])
