"""Branches of maps with closed forms, and what ends a walk."""

import math

import numpy as np
import pytest

from gearwear.codes.branch_codes import (
    CLOSED,
    FOLD,
    HALVED,
    NODE_LIMIT,
    NONE,
    PERIOD_DOUBLING,
    RANGE_END,
    STOPPED,
    TORUS,
)
from gearwear.orbits.branches import follow
from gearwear.orbits.continuation import Limits
from gearwear.orbits.newton import Orbit, periodic_orbit
from gearwear.orbits.return_map import return_maps
from gearwear.oscillator.oscillator import Oscillator
from gearwear.oscillator.periodic import Harmonics


def specials(branch):
    return [(node.special, node.orbit.value) for node in branch.nodes if node.special != NONE]


def branch_from(family, value, state, period, limits):
    return follow(family, periodic_orbit(family, value, state, period).orbit, limits)


def test_fixed_points_of_henon(henon):
    """1 - x + b x - a x^2 = 0: fold at -(1 - b)^2 / 4, doubling at 3 (1 - b)^2 / 4 on the upper half."""
    branch = branch_from(henon, 0.2, (0.9, 0.27), 1, Limits(-1.0, 1.0))
    assert [kind for kind, _ in specials(branch)] == [FOLD, PERIOD_DOUBLING]
    assert [value for _, value in specials(branch)] == pytest.approx([-0.1225, 0.3675], abs=1e-8)
    for node in branch.nodes:
        a, x = node.orbit.value, node.orbit.section[0, 0]
        assert 1 - 0.7 * x - a * x**2 == pytest.approx(0, abs=1e-9)
    upper = [node.orbit.stable for node in branch.nodes if -0.1224 < node.orbit.value < 0.3674]
    assert True in upper and False in upper
    assert branch.end.reason == RANGE_END and branch.nodes[-1].orbit.value == 1.0


def test_period_two_of_henon(henon):
    """The orbit of period 2 is born at 3 (1 - b)^2 / 4 and doubles at (1 - b)^2 + (1 + b)^2 / 4."""
    x = [(0.7 + sign * math.sqrt(4 * 0.6 - 3 * 0.49)) / 1.2 for sign in (1, -1)]
    branch = branch_from(henon, 0.6, (x[0], 0.3 * x[1]), 2, Limits(-1.0, 1.2))
    assert specials(branch) == [(PERIOD_DOUBLING, pytest.approx(0.9125, abs=1e-8))]
    assert {branch.start.reason, branch.end.reason} == {HALVED, RANGE_END}
    half = next(end for end in (branch.start, branch.end) if end.reason == HALVED)
    assert half.orbit.value == pytest.approx(0.3675, abs=1e-8)
    assert half.orbit.section[0] == pytest.approx(half.orbit.section[1], abs=1e-6)


def test_torus_point(delayed_logistic):
    branch = branch_from(delayed_logistic, 1.5, (0.3, 0.3), 1, Limits(1.2, 2.5))
    assert specials(branch) == [(TORUS, pytest.approx(2.0, abs=1e-8))]
    assert all(node.orbit.stable == (node.orbit.value < 2) for node in branch.nodes if node.special == NONE)


def test_nodes_are_close_and_orbits(large_fluctuation):
    limits = Limits(0.5, 0.7, largest_step=0.05)
    branch = branch_from(return_maps(large_fluctuation), 0.52, (1.2, 0.0), 1, limits)
    places = [[*node.orbit.section[0], (node.orbit.value - 0.5) / 0.2] for node in branch.nodes]
    assert np.linalg.norm(np.diff(places, axis=0), axis=1).max() < 0.1
    for node in branch.nodes[:: len(branch.nodes) // 10]:
        polished = periodic_orbit(return_maps(large_fluctuation), node.orbit.value, node.orbit.section[0], 1)
        assert polished.corrections[0] < 1e-7 or node.special == FOLD


def test_an_unstable_branch_goes_through_both_folds(large_fluctuation):
    """Three orbits at one frequency between the folds, the middle one unstable."""
    branch = branch_from(return_maps(large_fluctuation, 1e-12), 0.52, (1.2, 0.0), 1, Limits(0.5, 0.7))
    folds = [value for kind, value in specials(branch) if kind == FOLD]
    assert folds == pytest.approx([0.620486, 0.577217], abs=1e-6)
    kinds = [node.special for node in branch.nodes]
    first, second = (i for i, kind in enumerate(kinds) if kind == FOLD)
    assert not any(node.orbit.stable for node in branch.nodes[first + 1 : second])
    assert all(node.orbit.stable for node in (*branch.nodes[:first], *branch.nodes[second + 1 :]))
    values = [node.orbit.value for node in branch.nodes]
    assert np.all(np.diff(values[: first + 1]) > 0) and np.all(np.diff(values[first : second + 1]) < 0)


def test_any_parameter_can_be_followed(large_fluctuation):
    """The error amplitude at a frequency between the folds: jumps there are folds too."""
    branch = branch_from(
        return_maps(lambda factor: large_fluctuation(0.6).with_error_scaled(factor)), 0.1, (1.0, 0.0), 1, Limits(0.0, 2)
    )
    assert [branch.nodes[0].orbit.value, branch.nodes[-1].orbit.value] == [0.0, 2.0]
    assert [kind for kind, _ in specials(branch)] == [FOLD, FOLD]


def test_a_closed_branch_ends_where_it_began(iterated):
    """x' = x + 0.2 (1 - x^2 - a^2): fixed points on a circle."""
    circle = iterated(
        lambda a, s: ((s[0] + 0.2 * (1 - s[0] ** 2 - a**2), 0.5 * s[1]), ((1 - 0.4 * s[0], 0.0), (0.0, 0.5)))
    )
    branch = branch_from(circle, 0.0, (1.0, 0.0), 1, Limits(-1.5, 1.5, largest_step=0.05))
    assert branch.start.reason == branch.end.reason == CLOSED
    assert [value for _, value in specials(branch)] == pytest.approx([1.0, -1.0], abs=1e-8)
    angles = np.unwrap([math.atan2(node.orbit.value, node.orbit.section[0, 0]) for node in branch.nodes])
    assert angles[-1] - angles[0] == pytest.approx(2 * math.pi, abs=1e-6)


def test_a_lost_motion_stops_with_the_last_good_point(iterated):
    """x' = 0.5 sqrt(2 - a): nothing beyond a = 2."""

    def step(a, s):
        return (0.5 * math.sqrt(2 - a) if a < 2 else math.nan, 0.5 * s[1]), ((0.0, 0.0), (0.0, 0.5))

    branch = branch_from(iterated(step), 1.0, (0.5, 0.0), 1, Limits(0.0, 3.0))
    assert branch.end.reason == STOPPED and branch.start.reason == RANGE_END
    assert branch.end.orbit is branch.nodes[-1].orbit
    assert 1.999 < branch.end.orbit.value < 2.0
    assert "the motion blows up or needs too many steps; last good point 1.99" in branch.end.words


def test_a_refused_value_stops_with_its_message(large_fluctuation):
    """The stiffness would fluctuate by more than its mean."""
    family = return_maps(lambda factor: large_fluctuation(0.4).with_clearance_scaled(1.0 - factor))
    branch = branch_from(family, 0.0, (1.2, 0.0), 1, Limits(-0.5, 1.5, largest_step=0.05))
    assert branch.end.reason == STOPPED
    assert branch.end.orbit.value == pytest.approx(1.0, abs=1e-3)
    assert "clearance: least value" in branch.end.words and "last good point" in branch.end.words


def test_nodes_are_limited(henon):
    branch = branch_from(henon, 0.2, (0.9, 0.27), 1, Limits(-1.0, 1.0, most_nodes=5))
    assert branch.start.reason == branch.end.reason == NODE_LIMIT
    assert len(branch.nodes) <= 13 and "5 nodes are used up; last good point" in branch.end.words


@pytest.mark.parametrize(
    "limits, words",
    [
        (Limits(1.0, 1.0), "range of the parameter: 1.0 to 1.0"),
        (Limits(0.0, math.inf), "must be finite and increase"),
        (Limits(0.0, 1.0, 0.01, 0.02), "steps: smallest 0.02, largest 0.01"),
        (Limits(0.0, 1.0, 0.01, 0.0), "steps: smallest 0.0"),
        (Limits(0.0, 1.0, most_nodes=0), "most_nodes: 0"),
        (Limits(0.3, 1.0), "parameter 0.2 is outside the range 0.3 to 1.0"),
    ],
)
def test_bad_limits_are_refused(henon, limits, words):
    orbit = Orbit(0.2, 1, np.array([[0.9, 0.27]]), np.eye(2))
    with pytest.raises(ValueError, match=words):
        follow(henon, orbit, limits)


def test_a_branch_goes_through_a_grazing_contact():
    """Constant stiffness: the linear orbit grazes the backlash at a frequency in closed form, 0.8206311, and bends."""
    error = Harmonics(0.0, (0.05,), (0.0,))
    family = return_maps(lambda w: Oscillator(w, 0.05, 0.1, Harmonics(1.0), error))
    branch = branch_from(family, 0.75, (1.16, 0.0), 1, Limits(0.7, 1.5))
    assert branch.start.reason == branch.end.reason == RANGE_END
    values = np.array([node.orbit.value for node in branch.nodes])
    period = 2 * math.pi / values
    linear = 2 * np.exp(-0.05 * period) * np.cos(math.sqrt(1 - 0.05**2) * period)
    found = np.array([np.trace(node.orbit.matrix) for node in branch.nodes])
    lost = np.flatnonzero(abs(found - linear) > 1e-6)[0]
    assert 0.8206311 - 0.01 < values[lost - 1] < 0.8206312 and values[lost] > values[lost - 1]
    assert [kind for kind, _ in specials(branch)] == [FOLD, FOLD]
