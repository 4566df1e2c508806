"""Test functions of bifurcations."""

import numpy as np
import pytest

from gearwear.codes.branch_codes import FOLD, PERIOD_DOUBLING, TORUS
from gearwear.orbits.special_points import crossings, margins


def rotation(modulus, angle):
    return modulus * np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


def test_margins_are_products_of_distances_from_the_circle():
    assert margins(np.diag([0.5, -3.0])) == pytest.approx([(0.5 - 1) * (-3 - 1), (0.5 + 1) * (-3 + 1), -2.5])


@pytest.mark.parametrize(
    "before, after, kinds",
    [
        (np.diag([0.9, 0.2]), np.diag([1.1, 0.2]), [FOLD]),
        (np.diag([-0.9, 0.2]), np.diag([-1.1, 0.2]), [PERIOD_DOUBLING]),
        (np.diag([-0.9, 0.9]), np.diag([-1.1, 1.1]), [FOLD, PERIOD_DOUBLING]),
        (rotation(0.9, 1.0), rotation(1.1, 1.2), [TORUS]),
        (np.diag([0.5, 1.9]), np.diag([0.5, 2.1]), []),
        (rotation(0.9, 1.0), rotation(0.9, 2.0), []),
    ],
)
def test_crossings(before, after, kinds):
    assert crossings(before, after) == kinds
    assert crossings(after, before) == kinds
