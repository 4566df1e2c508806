"""One step of the integrator."""

import math

import numpy as np
import pytest

from gearwear.integrate.dormand_prince.dormand_prince import full_load, linear_step, load, stage_loads

HARMONICS = np.array([[0.2, -0.1, 0.05, 0.3, 0.1, 0.02, 0.05, -0.01], [0.02, 0.03, -0.1, 0.0, 0.0, 0.04, 0.0, 0.02]])
CELL = (0.7, 1.1, 0.2, 0.5, 0.1, 1.0, 0.4, 0.3, 0.1)


def test_error_of_a_step_is_of_sixth_order():
    c, k, g = 0.2, 1.3, 0.4
    rate = math.sqrt(k - c * c / 4)

    def exact(t):
        return g / k + math.exp(-c * t / 2) * (1 - g / k) * (math.cos(rate * t) + c / (2 * rate) * math.sin(rate * t))

    errors = [abs(linear_step(h, c, 1.0, 0.0, (k,) * 6, (g,) * 6)[0] - exact(h)) for h in (0.4, 0.2, 0.1)]
    assert math.log2(errors[0] / errors[1]) == pytest.approx(6, abs=0.5)
    assert math.log2(errors[1] / errors[2]) == pytest.approx(6, abs=0.5)


def test_estimated_error_is_of_fifth_order_and_larger_than_the_true_one():
    loads = ((1.3,) * 6, (0.4,) * 6)
    estimates = [math.hypot(*linear_step(h, 0.2, 1.0, 0.0, *loads)[3:]) for h in (0.2, 0.1)]
    assert math.log2(estimates[0] / estimates[1]) == pytest.approx(5, abs=0.5)


def test_loads_follow_the_formulas():
    t = 0.9
    angle = np.array([0.7 * t, 1.4 * t])
    waves = HARMONICS[:, ::2].T @ np.cos(angle) + HARMONICS[:, 1::2].T @ np.sin(angle)
    stiffness, clearance = 1.1 + 0.2 * (t - 0.5) + waves[0], 1.0 + waves[2]
    turned = 0.4 * t + 0.3
    torque = 0.05 * math.cos(turned) - 0.01 * math.sin(turned) + 0.02 * math.sin(2 * turned)
    force = 0.1 + waves[1] + torque
    assert load(CELL, HARMONICS, 0, t) == pytest.approx((0.0, force), rel=1e-14)
    for branch in (-1, 1):
        expected = (stiffness, force + stiffness * branch * clearance)
        assert load(CELL, HARMONICS, branch, t) == pytest.approx(expected, rel=1e-14)
        assert full_load(CELL, HARMONICS, branch, t)[:3] == pytest.approx((*expected, clearance), rel=1e-14)


def test_rates_are_the_derivatives():
    t, d = 0.9, 1e-4
    before, at, after = (full_load(CELL, HARMONICS, 1, t + shift) for shift in (-d, 0.0, d))
    assert at[3] == pytest.approx((after[0] - before[0]) / (2 * d), abs=1e-8)
    assert at[4] == pytest.approx((after[2] - before[2]) / (2 * d), abs=1e-8)
    assert at[5] == pytest.approx((after[2] - 2 * at[2] + before[2]) / d**2, abs=1e-6)


def test_stages_are_taken_at_the_stage_times():
    before = full_load(CELL, HARMONICS, 1, 0.6)
    stiffness, force, after = stage_loads(CELL, HARMONICS, 1, 0.6, 0.45, before)
    for i, node in enumerate((0.0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1.0)):
        expected = load(CELL, HARMONICS, 1, 0.6 + node * 0.45)
        assert (stiffness[i], force[i]) == pytest.approx(expected, rel=1e-14)
    assert after == full_load(CELL, HARMONICS, 1, 0.6 + 0.45)
