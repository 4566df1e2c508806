"""Branch switching and the search from seeds."""

import numpy as np
import pytest

from gearwear.codes.branch_codes import FOLD, HALVED, NONE, PERIOD_DOUBLING
from gearwear.orbits.branches import NO_PARENT, Seed, explore, follow, follow_doubled, holds
from gearwear.orbits.continuation import Limits
from gearwear.orbits.newton import minimal_period, periodic_orbit
from gearwear.orbits.return_map import return_maps

LIMITS = Limits(0.9, 1.3)


def doubling_of(branch):
    return next(node.orbit for node in branch.nodes if node.special == PERIOD_DOUBLING)


@pytest.fixture(scope="module")
def family(large_fluctuation):
    return return_maps(large_fluctuation)


@pytest.fixture(scope="module")
def first(family):
    """The orbits of period 1."""
    return follow(family, periodic_orbit(family, 0.95, (0.7, 0.1), 1).orbit, LIMITS)


def test_both_sides_of_a_doubling_are_the_same_orbits(family, first):
    one, other = (follow_doubled(family, doubling_of(first), LIMITS, side) for side in (1.0, -1.0))
    for branch in (one, other):
        assert branch.period == 2 and branch.start.reason == HALVED
        assert all(minimal_period(node.orbit) == 2 for node in branch.nodes[1:])
    node, twin = one.nodes[1].orbit, other.nodes[1].orbit
    shift = doubling_of(first).section[0]
    assert (node.section[0] - shift) @ (twin.section[0] - shift) < 0
    assert (node.section[0] - shift) @ (twin.section[1] - shift) > 0
    for sample in other.nodes[5::20]:
        assert holds(family, one, sample.orbit)


def test_the_branch_switched_to_reaches_the_settled_motion(family, first):
    branch = follow_doubled(family, doubling_of(first), LIMITS)
    settled = periodic_orbit(family, 1.1, (1.01007, 0.0), 2).orbit
    assert settled.stable and holds(family, branch, settled)
    assert not holds(family, first, settled)


def test_a_branch_of_twice_the_period_leads_back(henon):
    branches = explore(henon, [Seed(0.6, (1.387, -0.066), 2)], Limits(-0.5, 0.8), 2)
    assert [branch.period for branch in branches] == [2, 1]
    assert [branch.parent for branch in branches] == [NO_PARENT, 0]


def test_seeds_find_every_branch_once(henon):
    """Two seeds on one branch, one of period 2 given as period 4, and one that leads nowhere."""
    seeds = [
        Seed(0.2, (0.9, 0.27), 1),
        Seed(0.3, (0.85, 0.25), 1),
        Seed(0.6, (1.387, -0.066), 4),
        Seed(-0.4, (0, 0), 1),
    ]
    branches = explore(henon, seeds, Limits(-0.5, 1.0), 4)
    assert [branch.period for branch in branches] == [1, 2, 4]
    assert [branch.parent for branch in branches] == [NO_PARENT, 0, 1]
    found = [[node.orbit.value for node in b.nodes if node.special == PERIOD_DOUBLING] for b in branches]
    assert found[0] == pytest.approx([0.3675], abs=1e-8)
    assert found[1] == pytest.approx([0.9125], abs=1e-8)
    assert found[2] == []  # the next one is at 1.026


def test_longer_periods_than_wanted_are_left_out(henon):
    assert [b.period for b in explore(henon, [Seed(0.2, (0.9, 0.27), 1)], Limits(-0.5, 1.0), 1)] == [1]
    assert explore(henon, [Seed(0.6, (1.387, -0.066), 2)], Limits(-0.5, 1.0), 1) == []


def test_a_bubble_of_period_two_is_one_branch(iterated):
    """x' = -(1 + a (1 - a) - 0.1) x + x^3: period 2 between two doublings."""

    def step(a, s):
        slope = -(0.9 + a * (1 - a))
        return (slope * s[0] + s[0] ** 3, 0.1 * s[1]), ((slope + 3 * s[0] ** 2, 0.0), (0.0, 0.1))

    branches = explore(iterated(step), [Seed(0.0, (0.0, 0.0), 1)], Limits(0.0, 1.0), 2)
    assert [branch.period for branch in branches] == [1, 2]
    edges = (0.5 - np.sqrt(0.15), 0.5 + np.sqrt(0.15))
    assert [n.orbit.value for n in branches[0].nodes if n.special] == pytest.approx(edges, abs=1e-8)
    assert [branches[1].start.orbit.value, branches[1].end.orbit.value] == pytest.approx(edges, abs=1e-8)
    assert branches[1].start.reason == branches[1].end.reason == HALVED
    for node in branches[1].nodes[1:-1]:
        a, x = node.orbit.value, node.orbit.section[0, 0]
        assert x**2 == pytest.approx(a * (1 - a) - 0.1, abs=1e-8)


def test_the_oscillator_has_no_torus_points(family, first):
    """det M = exp(-2 zeta n T) < 1 on all branches."""
    branches = explore(family, [Seed(0.95, tuple(first.nodes[0].orbit.section[0]), 1)], LIMITS, 4)
    assert {branch.period for branch in branches} == {1, 2, 4}
    for branch in branches:
        for node in branch.nodes:
            orbit = node.orbit
            assert node.special in (NONE, FOLD, PERIOD_DOUBLING)
            contraction = np.exp(-0.2 * branch.period * 2 * np.pi / orbit.value)
            assert np.linalg.det(orbit.matrix) == pytest.approx(contraction, rel=1e-5, abs=1e-7)
