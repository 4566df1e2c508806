"""The onset of chaos: the run of the sweep, and the finer grid below it."""

import numpy as np
import pytest

from gearwear.codes.onset_codes import ABSENT, BELOW_RANGE, MET
from gearwear.onsets.chaos import onset_of_chaos

VALUES = np.linspace(1.0, 2.0, 11)
LATE = [1, 1, 101, 1, 1, 8, 101, 101, 101, 101, 101]


def chaotic_from(place, asked=None):
    def classify(values, below, above):
        if asked is not None:
            asked.append((values, below, above))
        return np.where(values >= place, 101, 8)

    return classify


def test_it_lies_in_the_step_below_the_first_run_of_three():
    asked = []
    onset = onset_of_chaos(VALUES, np.array(LATE), chaotic_from(1.54, asked), 4)
    assert (onset.value, onset.seen, onset.how) == (pytest.approx(1.55), onset.value, MET)
    assert onset.resolution == pytest.approx(0.025)
    ((values, below, above),) = asked
    assert values == pytest.approx([1.525, 1.55, 1.575]) and (below, above) == (5, 6)


@pytest.mark.parametrize(("place", "found"), [(1.0, 1.525), (1.59, 1.6)])
def test_it_stays_within_the_step(place, found):
    assert onset_of_chaos(VALUES, np.array(LATE), chaotic_from(place), 4).value == pytest.approx(found)


def test_a_periodic_window_in_the_step_ends_it():
    def classify(values, below, above):
        return np.array([101, 8, 101])

    assert onset_of_chaos(VALUES, np.array(LATE), classify, 4).value == pytest.approx(1.575)


def test_points_that_did_not_converge_are_passed_over():
    classes = np.array([1, 1, 1, 8, 0, 0, 101, 0, 101, 101, 1])
    asked = []
    onset = onset_of_chaos(VALUES, classes, chaotic_from(1.45, asked), 6)
    assert asked[0][1:] == (3, 6)
    assert onset.value == pytest.approx(1.45)

    def undecided(values, below, above):
        return np.where(values > 1.53, 101, np.where(values > 1.42, 0, 101))

    assert onset_of_chaos(VALUES, classes, undecided, 6).value == pytest.approx(1.35)


def test_a_refinement_of_one_asks_for_nothing():
    asked = []
    onset = onset_of_chaos(VALUES, np.array(LATE), chaotic_from(1.0, asked), 1)
    assert onset.value == pytest.approx(1.6) and onset.resolution == pytest.approx(0.1)
    assert asked[0][0].size == 0


def test_a_sweep_without_a_run_has_no_onset():
    onset = onset_of_chaos(VALUES, np.array([1, 1, 101, 101, 1, 1, 1, 101, 101, 1, 1]), chaotic_from(1.0), 4)
    assert np.isnan([onset.value, onset.seen, onset.resolution]).all() and onset.how == ABSENT
    assert onset.remark == "no 3 successive points of the sweep are chaotic"


def test_a_sweep_chaotic_from_the_start_has_its_onset_below():
    onset = onset_of_chaos(VALUES, np.array([0, *[101] * 10]), chaotic_from(1.0), 4)
    assert (onset.value, onset.how) == (pytest.approx(1.1), BELOW_RANGE)
