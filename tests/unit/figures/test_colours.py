"""Colours that stand side by side stay apart for readers who lack one kind of cone."""

from itertools import combinations

import numpy as np
import pytest
from matplotlib.colors import to_rgb

from gearwear.figures import labels, motion_classes

# Machado, Oliveira and Fernandes (2009), severity 1, on linear RGB.
SIGHT = {
    "normal": np.eye(3),
    "protanopia": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    "deuteranopia": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
    "tritanopia": [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
}
TO_XYZ = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])  # sRGB, D65
CLASSES = ("P1", "P2", "P4", "P8", "P3", "P6", "QP", "CH", "P5", "not_converged")
LEAST = 15.0  # in CIELAB, where about 2 can just be told apart


def lab(colour, sight):
    """Return CIELAB of a colour as it is seen."""
    rgb = np.array(to_rgb(colour))
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    x, y, z = TO_XYZ @ np.clip(np.array(sight) @ linear, 0, 1) / TO_XYZ.sum(axis=1)
    f, g, h = (np.cbrt(t) if t > 0.008856 else 7.787 * t + 16 / 116 for t in (x, y, z))
    return np.array([116 * g - 16, 500 * (f - g), 200 * (g - h)])


@pytest.mark.parametrize("sight", SIGHT)
@pytest.mark.parametrize(
    "colours",
    [{motion_classes.colour(name) for name in CLASSES}, {labels.colour(place) for place in range(6)}],
    ids=["classes", "states"],
)
def test_any_two_colours_can_be_told_apart(colours, sight):
    seen = {colour: lab(colour, SIGHT[sight]) for colour in colours}
    near = [pair for pair in combinations(colours, 2) if np.linalg.norm(seen[pair[0]] - seen[pair[1]]) < LEAST]
    assert near == []
