"""The eighth-order integrator with events, where the answer is known."""

import math

import numpy as np
import pytest

from gearwear.validation import second_method
from gearwear.validation.second_method import DOUBLING, special_frequency

SYSTEM = {"damping_ratio": 0.05, "mean_force": 0.1, "stiffness": [], "error": [0.05]}


def test_linear_motion_is_that_of_the_closed_form():
    steady = 0.05 * 0.25 / (1 - 0.25 + 0.05j)
    state = np.array([1.1 + steady.real, (0.5j * steady).real])
    after, matrix = second_method._run(SYSTEM, 0.5, state, 1)
    np.testing.assert_allclose(after, state, atol=1e-11)
    assert np.linalg.det(matrix) == pytest.approx(math.exp(-0.1 * 2 * math.pi / 0.5), rel=1e-9)


def test_contraction_holds_through_impacts():
    large = {"damping_ratio": 0.1, "mean_force": 0.1, "stiffness": [-0.4], "error": [0.1]}
    _, matrix = second_method._run(large, 1.3, (0.0, 0.0), 4)
    assert np.linalg.det(matrix) == pytest.approx(math.exp(-0.2 * 8 * math.pi / 1.3), rel=1e-8)


def test_no_special_point_no_number():
    with pytest.raises(ValueError, match="no orbit of period 1"):
        special_frequency(SYSTEM, 1, DOUBLING, 0.5, (1.1, 0.0))
