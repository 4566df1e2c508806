"""Measures of a field along the path of contact or the mesh phase: means, zone means, jumps."""

import numpy as np
import xarray as xr

from gearwear.claims import rules
from gearwear.claims.study import Study, Undecided

TRANSITIONS = ("lowest_single_contact", "highest_single_contact")


def double_contact(study: Study, field: xr.DataArray) -> np.ndarray:
    """Return which mesh phases of `field` have two pairs in contact, boolean, both kinds present."""
    double = field["mesh_phase"].values < study.scalar("contact_ratio") - 1
    if double.all() or not double.any():
        raise Undecided("the mesh phases do not hold both a single and a double contact zone")
    return double


def jump_ratios(study: Study, field: xr.DataArray) -> list[float]:
    """Return, for both changes between single and double contact, how far the field jumps.

    The measure is the difference of the two one-sided values over the larger of the steps to the next
    node on either side; infinite if the neighbouring steps vanish, zero if the difference is rounding.
    """
    ratios = []
    for point in TRANSITIONS:
        nodes = study.nodes_at(field, point)
        if nodes.size != 2 or nodes[0] == 0 or nodes[1] == field.size - 1:
            raise Undecided(f"the path has no two one-sided nodes with neighbours at {point}")
        before, left, right, after = field.values[nodes[0] - 1 : nodes[1] + 2]
        neighbouring = max(abs(left - before), abs(after - right))
        difference = abs(right - left)
        if difference <= rules.GRID_TOLERANCE * np.abs(field.values).max():
            ratios.append(0.0)
        else:
            ratios.append(float(difference / neighbouring) if neighbouring > 0 else np.inf)
    return ratios


def jumps_everywhere(ratios: list[float]) -> bool:
    """Return whether every ratio of `jump_ratios` is a jump."""
    return min(ratios) > rules.JUMP_OVER_NEIGHBOURS
