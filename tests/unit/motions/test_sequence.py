"""Runs of classes along a sweep and their order."""

import numpy as np
import pytest

from gearwear.motions.sequence import changes, first_run, runs


def test_runs_cover_the_sequence():
    assert runs(np.array([1, 1, 2, 101, 101])) == [(1, 0, 1), (2, 2, 2), (101, 3, 4)]
    assert runs(np.array([4])) == [(4, 0, 0)]


@pytest.mark.parametrize(
    ("classes", "found"),
    [
        ([1, 1, 2, 2, 1, 1, 2, 2], [(1, 2), (5, 6)]),
        ([1, 1, 0, 2, 2], [(1, 3)]),
        ([1, 1, 2, 1, 1, 2, 2], [(4, 5)]),
        ([1, 1, 3, 2, 2], [(1, 3)]),
        ([1, 1, 4, 4, 2, 2], []),
        ([2, 2, 1, 1], []),
        ([0, 0], []),
    ],
)
def test_changes_of_period(classes, found):
    assert changes(np.array(classes), 1, 2, 2) == found


@pytest.mark.parametrize(
    ("classes", "found"),
    [
        ([1, 101, 101, 1, 101, 101, 101], (4, 6)),
        ([1, 101, 0, 101, 101, 2], (1, 4)),
        ([101, 101, 1], None),
        ([0, 0, 0], None),
    ],
)
def test_first_run_of_chaos(classes, found):
    assert first_run(np.array(classes), 101, 3) == found
