import numpy as np
import pytest

from gearwear.claims.study import Undecided
from gearwear.claims.sweeps import read_sweep
from gearwear.claims.windows import judge_window, judge_window_of_cases, points_of_window

TENTHS = np.linspace(0.1, 1.0, 10)


def test_ends_belong_to_the_window_in_spite_of_rounding():
    np.testing.assert_array_equal(points_of_window(TENTHS, 0.3, 0.7), [2, 3, 4, 5, 6])


def test_narrow_window_takes_the_nearest_point_or_both():
    np.testing.assert_array_equal(points_of_window(TENTHS, 0.31, 0.33), [2])
    np.testing.assert_array_equal(points_of_window(TENTHS, 0.34, 0.36), [2, 3])


@pytest.mark.parametrize(
    ("motion_class", "names", "holds"),
    [
        ([1, 1, 2, 2], ["P1"], True),
        ([1, 2, 2, 2], ["P1"], False),
        ([1, 2, 2, 100], ["QP", "P1"], True),
        ([101, 101, 0, 0], ["CH"], True),
        ([1, 0, 2, 2], ["P1"], None),
        ([0, 0, 0, 0], ["P1"], None),
        ([1, 101, 0, 0], ["P6"], None),
        ([1, 101, 1, 0], ["P6"], False),
    ],
)
def test_half_of_the_points_decide(study, results, make_sweep, motion_class, names, holds):
    results["sweep", "with", "ste"] = make_sweep("ste", [1.0, 1.1, 1.2, 1.3], motion_class)
    assert judge_window(read_sweep(study, "with", "ste"), 1.0, 1.3, names)[0] is holds


def test_classes_seen_are_counted(study, results, make_sweep):
    results["sweep", "with", "ste"] = make_sweep("ste", [1.0, 1.1, 1.2, 1.3], [101, 2, 0, 2])
    _, found = judge_window(read_sweep(study, "with", "ste"), 1.0, 1.3, ["P2"])
    assert found == "50 % of 4 points (not converged 1, P2 2, CH 1)"


def test_window_beyond_the_sweep_is_undecided(study):
    with pytest.raises(Undecided, match="spans"):
        judge_window(read_sweep(study, "with", "mesh_frequency"), 1.6, 1.8, ["CH"])


def test_every_case_must_agree(study):
    cases = ["without", "with"]
    assert judge_window_of_cases(study, cases, "mesh_frequency", (0.1, 0.58), ["P1"])[0] is True
    holds, found = judge_window_of_cases(study, cases, "mesh_frequency", (1.24, 1.26), ["P4"])
    assert holds is False
    assert found == "without: 100 % of 3 points (P4 3); with: 0 % of 3 points (CH 3)"


def test_missing_case_leaves_agreement_open_but_not_disagreement(study, results):
    del results["sweep", "with", "mesh_frequency"]
    cases = ["without", "with"]
    holds, found = judge_window_of_cases(study, cases, "mesh_frequency", (0.1, 0.58), ["P1"])
    assert holds is None
    assert "with: no result sweep/with/mesh_frequency" in found
    assert judge_window_of_cases(study, cases, "mesh_frequency", (0.1, 0.58), ["CH"])[0] is False
