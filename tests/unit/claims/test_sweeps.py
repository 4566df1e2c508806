import numpy as np
import pytest

from gearwear.claims.study import Undecided
from gearwear.claims.sweeps import class_code, class_name, read_sweep


def test_points_are_put_in_ascending_order(study, results, make_sweep):
    results["sweep", "with", "ste"] = make_sweep("ste", [3.0, 1.0, 2.0], [101, 1, 2], [0.3, 0.1, 0.2])
    sweep = read_sweep(study, "with", "ste")
    np.testing.assert_array_equal(sweep.swept, [1.0, 2.0, 3.0])
    np.testing.assert_array_equal(sweep.motion_class, [1, 2, 101])
    np.testing.assert_array_equal(sweep.extent[:, 1], [0.1, 0.2, 0.3])


def test_extent_of_the_section(study, results, make_sweep):
    dataset = make_sweep("ste", [1.0, 2.0], [2, 0])
    dataset["section_displacement"].values[:] = [[-0.5, 1.5], [np.nan, np.nan]]
    results["sweep", "with", "ste"] = dataset
    sweep = read_sweep(study, "with", "ste")
    np.testing.assert_array_equal(sweep.extent[:, 0], [-0.5, np.nan])
    np.testing.assert_array_equal(sweep.extent[:, 1], [1.5, np.nan])


def test_missing_sweep_section_or_class_is_undecided(study, results, make_sweep):
    with pytest.raises(Undecided, match="no result sweep/with/ste"):
        read_sweep(study, "with", "ste")
    results["sweep", "with", "ste"] = make_sweep("ste", [1.0, 2.0], [1.0, np.nan])
    with pytest.raises(Undecided, match="motion_class"):
        read_sweep(study, "with", "ste")
    results["sweep", "with", "ste"] = make_sweep("ste", [1.0], [1]).drop_vars("section_displacement")
    with pytest.raises(Undecided, match="section_displacement"):
        read_sweep(study, "with", "ste")


def test_span_is_required_at_both_ends(study):
    sweep = read_sweep(study, "with", "mesh_frequency")
    sweep.require_span(0.1, 1.7)
    for low, high in ((0.05, 1.0), (1.0, 1.71)):
        with pytest.raises(Undecided, match="spans 0.1 to 1.7 only"):
            sweep.require_span(low, high)


@pytest.mark.parametrize(("name", "code"), [("P1", 1), ("P16", 16), ("QP", 100), ("CH", 101)])
def test_class_names_and_codes(name, code):
    assert class_code(name) == code
    assert class_name(code) == name


@pytest.mark.parametrize("name", ["P0", "P", "chaos", "p2", "P100"])
def test_unknown_class_names_are_refused(name):
    with pytest.raises(ValueError, match="unknown"):
        class_code(name)


def test_points_that_did_not_converge_have_a_name():
    assert class_name(0) == "not converged"
