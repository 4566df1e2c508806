"""Dimensions of a pair, and the same by other formulas."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from gearwear.validation.pairs import geometry_of


def dimension(pair: dict[str, Any], name: str) -> np.ndarray:
    """Return a dimension of the dataset (SI units)."""
    return geometry_of(**pair)[name].values


def working_pitch_radius(pair: dict[str, Any]) -> np.ndarray:
    """Return base radius over the cosine of the working pressure angle (m), pinion and gear."""
    geometry = geometry_of(**pair)
    return geometry["base_radius"].values / math.cos(float(geometry["working_pressure_angle"]))


def path_mark(pair: dict[str, Any], name: str) -> float:
    """Return a mark on the path of contact from its start (m)."""
    geometry = geometry_of(**pair)
    return float(geometry[name] - geometry["start_of_contact"])


def contact_ratio_by_tip_angles(pair: dict[str, Any]) -> float:
    """Return the contact ratio less sum z (tan a_tip - tan a_working) / 2 pi, a_tip from the tip radii."""
    geometry = geometry_of(**pair)
    at_tip = np.arccos(geometry["base_radius"].values / geometry["tip_radius"].values)
    over = np.tan(at_tip) - math.tan(float(geometry["working_pressure_angle"]))
    return float(geometry["contact_ratio"]) - float(geometry["teeth"].values @ over) / (2 * math.pi)


QUANTITIES = {
    "dimension": dimension,
    "working_pitch_radius": working_pitch_radius,
    "path_mark": path_mark,
    "contact_ratio_by_tip_angles": contact_ratio_by_tip_angles,
}
