"""Doublings on branches, and which of them a sweep goes through."""

import numpy as np
import pytest

from gearwear.codes.branch_codes import FOLD, PERIOD_DOUBLING
from gearwear.codes.onset_codes import ABSENT, MET, PASSED_BY
from gearwear.onsets.doublings import ACCURACY, Doubling, doublings, onset_of_doubling

VALUES = np.arange(1.0, 2.0, 0.1)


def at(*places, period=1):
    return [Doubling(place, (place, -place), period) for place in places]


def test_only_a_loss_of_stability_upwards_is_an_onset(make_branches):
    lost = [(1.0, True), (1.1, True), (1.2, True, PERIOD_DOUBLING), (1.3, False)]
    regained = [(1.6, False), (1.65, False, PERIOD_DOUBLING), (1.7, True)]
    branches = make_branches((1, [*lost, *regained]))
    assert doublings(branches, "mesh_frequency", 1) == [Doubling(1.2, (1.2, -1.2), 1)]
    assert doublings(branches, "mesh_frequency", 2) == []


def test_a_branch_may_be_walked_downwards(make_branches):
    branches = make_branches((2, [(1.4, False), (1.3, True, PERIOD_DOUBLING), (1.2, True)]))
    assert [one.value for one in doublings(branches, "mesh_frequency", 2)] == [1.3]


def test_special_points_beside_it_do_not_tell_the_stability(make_branches):
    nodes = [(1.0, True), (1.1, False, FOLD), (1.2, False, PERIOD_DOUBLING), (1.3, True, FOLD), (1.4, False)]
    assert [one.value for one in doublings(make_branches((1, nodes)), "mesh_frequency", 1)] == [1.2]


def test_a_doubling_of_an_orbit_that_turns_round_is_none(make_branches):
    nodes = [(1.3, True), (1.2, True, PERIOD_DOUBLING), (1.25, False)]
    assert doublings(make_branches((1, nodes)), "mesh_frequency", 1) == []


def test_doublings_of_all_branches_ascend(make_branches):
    one = (1, [(1.5, True), (1.6, True, PERIOD_DOUBLING), (1.7, False)])
    other = (1, [(1.1, True), (1.2, True, PERIOD_DOUBLING), (1.3, False)])
    assert [one.value for one in doublings(make_branches(one, other), "mesh_frequency", 1)] == [1.2, 1.6]


@pytest.mark.parametrize("place", [1.45, 1.4, 1.5])
def test_a_doubling_between_the_points_of_a_change_is_met(place):
    classes = np.array([1, 1, 1, 1, 1, 2, 2, 2, 2, 2])
    onset = onset_of_doubling(at(1.05, place, 1.95), VALUES, classes, 1)
    assert (onset.value, onset.seen, onset.how, onset.resolution) == (place, place, MET, ACCURACY)


def test_the_first_doubling_met_counts():
    classes = np.array([1, 1, 2, 2, 1, 1, 2, 2, 2, 2])
    assert onset_of_doubling(at(1.55), VALUES, classes, 1).value == 1.55
    assert onset_of_doubling(at(1.15, 1.55), VALUES, classes, 1).value == 1.15


def test_a_jump_leaves_the_nearest_doubling_aside():
    classes = np.array([2, 2, 2, 2, 2, 4, 4, 4, 4, 4])
    onset = onset_of_doubling(at(1.0, 1.3, 1.8, period=2), VALUES, classes, 2, above=1.1)
    assert (onset.value, onset.how) == (1.3, PASSED_BY)
    assert onset.seen == pytest.approx(1.45)
    assert onset.remark == "the sweep jumps from period 2 to 4 between 1.4 and 1.5"


def test_without_a_change_the_next_doubling_of_the_cascade_counts():
    classes = np.array([2, 2, 2, 2, 2, 101, 101, 101, 101, 101])
    onset = onset_of_doubling(at(1.05, 1.3, 1.8, period=2), VALUES, classes, 2, above=1.1)
    assert (onset.value, onset.how) == (1.3, PASSED_BY)
    assert np.isnan(onset.seen)
    assert onset.remark == "the sweep has no change from period 2 to 4"


def test_no_doubling_at_all_is_said():
    classes = np.array([2, 2, 2, 2, 2, 4, 4, 4, 4, 4])
    onset = onset_of_doubling([], VALUES, classes, 2)
    assert np.isnan(onset.value) and onset.how == ABSENT and onset.seen == pytest.approx(1.45)
    assert onset.remark.startswith("no stable orbit of period 2 doubles; the sweep jumps")
    assert onset_of_doubling(at(1.2, period=2), VALUES, np.full(10, 2), 2, above=1.3).how == ABSENT
