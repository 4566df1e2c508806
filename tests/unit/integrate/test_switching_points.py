"""Detection of the corners inside a step."""

import numpy as np
import pytest

from gearwear.integrate.dormand_prince.switching_points import (
    CLEAR,
    EXIT,
    GRAZE,
    UNDECIDED,
    branch_at,
    first_exit,
    highest_force,
    highest_value,
)


def margins(polynomial, h):
    """Values, slopes and curvatures of a polynomial of time at both ends of a step."""
    p = np.polynomial.Polynomial(polynomial)
    return [f(t) for t in (0.0, h) for f in (p, p.deriv(), p.deriv(2))]


def test_monotone_margin_leaves_only_if_its_end_is_negative():
    assert first_exit(0.5, *margins([0.1, -0.1], 0.5), 1e-7)[0] == CLEAR
    assert first_exit(0.5, *margins([0.1, -0.3], 0.5), 1e-7)[0] == EXIT


@pytest.mark.parametrize("at", [0.1, 0.25, 0.4])
@pytest.mark.parametrize("depth, verdict", [(1e-3, EXIT), (1e-6, EXIT), (5e-8, GRAZE), (-5e-8, GRAZE), (-1e-6, CLEAR)])
def test_minimum_inside_a_step(at, depth, verdict):
    found, low, high = first_exit(0.5, *margins([2 * at**2 - depth, -4 * at, 2.0], 0.5), 1e-7)
    assert found == verdict
    if verdict != CLEAR:
        assert (low, high) == pytest.approx((0.0, at / 0.5), abs=1e-7)


def test_root_at_the_start_is_not_found_again():
    found, low, high = first_exit(0.5, *margins([0.0, 0.1, -0.3], 0.5), 1e-7)
    assert found == EXIT
    assert low <= (0.1 / 0.3) / 0.5 <= high
    assert low > 0.0
    assert first_exit(0.5, *margins([0.0, 0.1, -0.1], 0.5), 1e-7)[0] == CLEAR


def test_two_turns_near_zero_ask_for_a_shorter_step():
    wave = [-1e-4 + 0.001, -0.031, 0.2, -0.26]
    assert np.polynomial.Polynomial(wave)(np.linspace(0, 0.5, 99)).min() < 0
    assert first_exit(0.5, *margins(wave, 0.5), 1e-7)[0] in (UNDECIDED, EXIT)
    up_down_up = [1e-5, 0.02, -0.1, 0.15]
    assert first_exit(0.5, *margins(up_down_up, 0.5), 1e-7)[0] == UNDECIDED


def test_rest_on_the_corner_stays():
    assert first_exit(0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1e-7)[0] == CLEAR


def test_highest_value_of_a_turning_step():
    assert highest_value(0.5, *margins([1.0, 0.4, -1.0], 0.5)) == pytest.approx(1.04, rel=1e-14)
    assert highest_value(0.5, *margins([1.0, -0.4, -1.0], 0.5)) == 1.0


def test_highest_force_of_a_turning_step():
    # x = 1 + 0.2 t - 0.4 t^2 with k = 2 and b = 0.9: the force 2 (x - b) is highest at t = 1/4.
    before, after = (2.0, 0.0, 0.9, 0.0, 0.0, 0.0), (2.0, 0.0, 0.9, 0.0, 0.0, 0.0)
    assert highest_force(0.5, 1, 1.0, 0.2, before, 1.0, -0.2, after) == pytest.approx(2 * 0.125, rel=1e-14)
    assert highest_force(0.5, -1, -1.0, -0.2, before, -1.0, 0.2, after) == pytest.approx(2 * 0.125, rel=1e-14)


@pytest.mark.parametrize(
    "x, v, a, branch",
    [(1.1, -5.0, 0.0, 1), (0.9, 5.0, 0.0, 0), (-1.1, 5.0, 0.0, -1), (-0.9, -5.0, 0.0, 0)]
    + [(1.0, 0.1, 0.0, 1), (1.0, -0.1, 0.0, 0), (-1.0, -0.1, 0.0, -1), (-1.0, 0.1, 0.0, 0)]
    + [(1.0, 0.0, 0.1, 1), (1.0, 0.0, -0.1, 0), (-1.0, 0.0, -0.1, -1), (-1.0, 0.0, 0.1, 0)],
)
def test_branch_by_position_velocity_and_acceleration(x, v, a, branch):
    assert branch_at(x, v, a, (0.0, 0.0, 1.0, 0.0, 0.0, 0.0)) == branch


def test_branch_on_a_moving_corner_is_by_relative_velocity():
    assert branch_at(1.0, 0.1, 0.0, (0.0, 0.0, 1.0, 0.0, 0.2, 0.0)) == 0
    assert branch_at(1.0, 0.3, 0.0, (0.0, 0.0, 1.0, 0.0, 0.2, 0.0)) == 1
