"""Which motions are the same attractor."""

import numpy as np
import pytest

from gearwear.motions.matching import overlapping_clouds, same_orbits

ORBIT = np.array([[0.1, 0.0], [0.2, 0.1], [0.4, -0.1]])


def test_the_same_orbit_begun_anywhere_has_one_label():
    sections = np.array([ORBIT, np.roll(ORBIT, 1, axis=0), ORBIT[::-1], np.roll(ORBIT, 2, axis=0) + 0.9e-5])
    assert same_orbits(sections, 1e-5).tolist() == [0, 0, 1, 0]


def test_orbits_further_apart_than_the_tolerance_differ():
    sections = np.array([ORBIT, ORBIT + [0.0, 1.1e-5], ORBIT + 0.3])
    assert same_orbits(sections, 1e-5).tolist() == [0, 1, 2]


@pytest.mark.parametrize("order", [[0, 1, 2, 3], [3, 2, 1, 0], [2, 0, 3, 1]])
def test_labels_follow_the_first_of_each_but_groups_do_not(order):
    sections = np.array([ORBIT, ORBIT + 0.3, ORBIT + 1e-7, ORBIT + 0.3])[order]
    labels = same_orbits(sections, 1e-5)
    assert labels[0] == 0
    groups = {frozenset(np.array(order)[labels == label].tolist()) for label in labels}
    assert groups == {frozenset({0, 2}), frozenset({1, 3})}


@pytest.mark.parametrize("seed", range(5))
def test_boxes_that_touch_a_group_join_it_in_any_order(seed):
    """Two chains of boxes, and one that is only inside the box around a whole chain."""
    low = np.array([[0, 0], [0.9, 0.9], [1.8, 0], [5, 5], [5.5, 5.5], [2.5, 1.5], [9, 0]])
    high = low + [[1, 1], [1, 1], [1, 1], [1, 1], [1, 1], [0.1, 0.1], [1, 1]]
    order = np.random.default_rng(seed).permutation(len(low))
    labels = np.empty(len(low), dtype=int)
    labels[order] = overlapping_clouds(low[order], high[order])
    assert labels[order][0] == 0
    groups = {frozenset(np.flatnonzero(labels == label).tolist()) for label in labels}
    assert groups == {frozenset({0, 1, 2, 5}), frozenset({3, 4}), frozenset({6})}


def test_a_box_that_bridges_two_groups_found_before_makes_one():
    low, high = np.array([[0, 0], [4, 0], [0.5, 0.5]]), np.array([[1, 1], [5, 1], [4.5, 0.6]])
    assert overlapping_clouds(low, high).tolist() == [0, 0, 0]
    assert overlapping_clouds(low[:2], high[:2]).tolist() == [0, 1]
