"""Safe speeds: intervals of the classes, limits over all orders, the largest force."""

import numpy as np
import pytest
import xarray as xr

from gearwear.codes.motion_class import CHAOTIC, NOT_CONVERGED
from gearwear.studies.speeds import contact_limit, intervals, peak, period_one_limit

ORDERS = ("restart", "up", "down")


def outcome(classes, lost=None, force=None):
    """Return an outcome whose sweep from rest has these classes, and the others where they are given."""
    shape = np.shape(np.atleast_2d(classes))

    def three(values, fill):
        table = np.full((3, shape[1]), fill, dtype=float) if values is None else np.atleast_2d(values).astype(float)
        return np.repeat(table, 3, axis=0) if len(table) == 1 else table

    ratio = np.linspace(0.5, 1.0, shape[1])
    values = {
        "motion_class": (("order", "point"), three(classes, 1).astype(np.int32)),
        "contact_loss_share": (("order", "point"), three(lost, 0.0)),
        "force_max": (("order", "point"), three(force, 1.0)),
        "pinion_speed": ("point", 1000 * ratio),
    }
    return xr.Dataset(values, {"order": ("order", list(ORDERS)), "mesh_frequency": ("point", ratio)})


def test_intervals_are_runs_of_one_class():
    found = intervals(outcome([1, 1, 2, 2, 2, CHAOTIC]), "restart")
    assert [one[0] for one in found] == ["P1", "P2", "CH"]
    assert found[1][1:] == pytest.approx((0.7, 0.9, 700.0, 900.0))
    assert found[2][1] == found[2][2] == 1.0


def test_the_limit_is_the_last_point_before_any_order_leaves_period_one():
    rest, up, down = [1, 1, 1, 1, 2, 2], [1] * 6, [1, 1, 1, 2, 2, 2]
    limit = period_one_limit(outcome([rest, up, down]))
    assert limit.ratio == pytest.approx(0.7) and limit.speed == pytest.approx(700.0) and not limit.everywhere


def test_what_is_not_decided_is_not_safe():
    assert period_one_limit(outcome([1, NOT_CONVERGED, 1])).ratio == pytest.approx(0.5)


def test_a_limit_that_is_nowhere_has_no_number_and_one_that_is_never_met_says_so():
    assert np.isnan(period_one_limit(outcome([2, 1, 1])).ratio)
    limit = period_one_limit(outcome([1, 1, 1]))
    assert limit.everywhere and limit.ratio == 1.0


def test_contact_counts_in_every_order():
    lost = [[0, 0, 0.1], [0, 0, 0], [0, 0.2, 0]]
    assert contact_limit(outcome([[1, 1, 1]] * 3, lost)).ratio == pytest.approx(0.5)


def test_the_peak_is_that_of_all_orders():
    force = [[1, 2, 3], [1, 7, 2], [np.nan, 1, 1]]
    assert peak(outcome([[1, 1, 1]] * 3, force=force)) == pytest.approx((7.0, 0.75, 750.0))
    assert np.isnan(peak(outcome([1, 1], force=[np.nan, np.nan])).force)
