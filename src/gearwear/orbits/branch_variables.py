"""Branches as columns of a table, one behind the other along the dimension `node`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from gearwear.orbits.branches import Branch


def columns(branches: Sequence[Branch], largest_period: int, coordinate: str) -> dict[str, Any]:
    """Return the variables of branches, each as (dimensions, array).

    Parameters
    ----------
    branches : may be none.
    largest_period : number of section points kept room for; an orbit of a shorter period leaves the rest nan.
    coordinate : name of the parameter.
    """
    orbits = [node.orbit for branch in branches for node in branch.nodes]
    section = np.full((len(orbits), largest_period, 2), np.nan)
    for i, orbit in enumerate(orbits):
        section[i, : orbit.period] = orbit.section
    multipliers = np.array([orbit.multipliers for orbit in orbits], dtype=complex).reshape(-1, 2)
    table = {
        coordinate: ("node", np.array([orbit.value for orbit in orbits], dtype=float)),
        "branch_index": ("node", _integers(i for i, branch in enumerate(branches) for _ in branch.nodes)),
        "branch_displacement": (("node", "iterate"), section[:, :, 0]),
        "branch_velocity": (("node", "iterate"), section[:, :, 1]),
        "floquet_real": (("node", "multiplier"), multipliers.real),
        "floquet_imag": (("node", "multiplier"), multipliers.imag),
        "stable": ("node", _integers(orbit.stable for orbit in orbits)),
        "special_point": ("node", _integers(node.special for branch in branches for node in branch.nodes)),
        "branch_period": ("branch", _integers(branch.period for branch in branches)),
        "branch_parent": ("branch", _integers(branch.parent for branch in branches)),
    }
    for side in ("start", "end"):
        sides = [getattr(branch, side) for branch in branches]
        table[f"branch_{side}"] = ("branch", _integers(end.reason for end in sides))
        table[f"branch_{side}_remark"] = ("branch", np.array([end.words for end in sides], dtype=object))
    return table


def _integers(values: Any) -> np.ndarray:
    return np.array([int(value) for value in values], dtype=np.int32)
