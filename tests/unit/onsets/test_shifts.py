"""Shifts: pairs of cases computed alike, errors that hold every way, and the statistics of the members."""

import numpy as np
import pytest
import xarray as xr

from gearwear.codes.onset_codes import BELOW_RANGE, EVENTS, MET, PASSED_BY, VARIANTS
from gearwear.onsets.shifts import drawn, shifts, spread

NAN = np.nan
WITHOUT, WITH = [1.04, 1.19, 1.27, 1.30], [1.00, 1.16, 1.23, 1.25]
FACTORS = {name: {"damping_ratio": 1.0, "torque": 1.0} for name in ("torque_low", "box_001", "box_002", "box_003")}


@pytest.fixture
def make_variants(make_onsets):
    """Return a function that makes the ways to compute one case, all as `places` but those named."""

    def make(places, **changes):
        ways = [make_onsets(changes.get(name.replace(" ", "_").split(",")[0], places)) for name in VARIANTS]
        return xr.concat(ways, "variant").assign_coords(variant=np.array(VARIANTS, dtype=object))

    return make


@pytest.fixture
def compared(make_onsets, make_variants):
    """Return a function that compares the two cases above, with members and variants changed as given."""

    def compare(without=WITHOUT, hot=WITH, members=None, variants=({}, {}), order="restart", resolution=0.0):
        cases = {"without": without, "with": hot}
        factors = FACTORS if members is None else {name: FACTORS["box_001"] for name in members["with"]}
        members = {case: dict.fromkeys(FACTORS, cases[case]) for case in cases} if members is None else members
        return shifts(
            {case: make_onsets(places, resolution=resolution) for case, places in cases.items()},
            {
                case: make_variants(places, **changes)
                for (case, places), changes in zip(cases.items(), variants, strict=True)
            },
            {
                case: {
                    name: places if isinstance(places, xr.Dataset) else make_onsets(places)
                    for name, places in of.items()
                }
                for case, of in members.items()
            },
            order,
            factors,
        )

    return compare


def errors(table):
    return {str(name): table["shift_error"].sel(error=name).values for name in table["error"].values}


def test_the_shift_is_negative_where_the_second_case_comes_first(compared):
    table = compared()
    assert list(table["event"].values) == list(EVENTS)
    assert table["onset_shift"].values == pytest.approx([-0.04, -0.03, -0.04, -0.05])
    assert all(error == pytest.approx(np.zeros(4), abs=1e-15) for error in errors(table).values())


def test_a_way_that_moves_both_cases_alike_is_no_error(compared):
    later = ({"up": [1.05, 1.20, 1.28, 1.31]}, {"up": [1.01, 1.17, 1.24, 1.26]})
    assert errors(compared(variants=later))["total"] == pytest.approx(np.zeros(4), abs=1e-15)


def test_each_contribution_is_how_far_its_ways_lead_from_the_usual_one(compared):
    changed = (
        {"up": [1.04, 1.19, 1.27, 1.29], "halved_step": [1.04, 1.19, 1.27, 1.28]},
        {"down": [1.02, 1.16, 1.23, 1.25], "Dormand-Prince": [1.00, 1.161, 1.23, 1.25]},
    )
    found = errors(compared(variants=changed))
    assert found["start"] == pytest.approx([0.02, 0, 0, 0.01])
    assert found["step"] == pytest.approx([0, 0, 0, 0.02])
    assert found["integrator"] == pytest.approx([0, 0.001, 0, 0])
    assert found["settling"] == pytest.approx(np.zeros(4), abs=1e-15)
    assert found["total"] == pytest.approx([0.02, 0.001, 0, 0.02])


def test_the_bar_of_the_shift_holds_every_way_also_the_usual_sweep_past_the_doubling(compared):
    table = compared(variants=({"restart": [1.06, 1.19, 1.27, 1.30], "down": [1.02, 1.19, 1.27, 1.30]}, {}))
    ways, shift = table["variant_shift"].values, table["onset_shift"].values
    assert (abs(ways - shift) <= errors(table)["total"] + 1e-15).all()
    assert errors(table)["total"][0] == pytest.approx(0.02)
    assert errors(table)["start"][0] == pytest.approx(0.04)


def test_resolution_of_both_cases_is_added_to_the_total(compared):
    table = compared(resolution=1e-3, variants=({"up": [1.03, 1.19, 1.27, 1.30]}, {}))
    assert errors(table)["resolution"] == pytest.approx(np.full(4, 1e-3))
    assert errors(table)["total"] == pytest.approx([11e-3, 1e-3, 1e-3, 1e-3])


def test_a_way_without_the_event_says_nothing_of_its_error(compared):
    table = compared(variants=({"halved_step": [1.04, 1.19, NAN, 1.30]}, {}))
    assert errors(table)["step"] == pytest.approx([0, 0, NAN, 0], abs=1e-15, nan_ok=True)
    assert errors(table)["total"] == pytest.approx(np.zeros(4), abs=1e-15)
    assert np.isnan(table["variant_shift"].sel(variant="halved step").values[2])


def test_the_order_of_the_study_is_the_usual_way(compared):
    found = errors(compared(order="up", variants=({"up": [1.02, 1.19, 1.27, 1.30]}, {})))
    assert found["step"] == pytest.approx([0.02, 0, 0, 0])


def test_an_event_that_the_study_lacks_has_no_shift(compared):
    table = compared(without=[1.04, 1.19, 1.27, NAN])
    assert np.isnan(table["onset_shift"].values).tolist() == [False, False, False, True]
    assert np.isnan(errors(table)["total"][3])


def test_a_doubling_that_the_sweep_passes_by_has_its_place_chaos_below_the_range_has_none(compared, make_onsets):
    how = [MET, PASSED_BY, MET, BELOW_RANGE]
    members = {"without": {"box_001": WITHOUT}, "with": {"box_001": make_onsets(WITH, how)}}
    table = compared(members=members)
    assert np.isnan(table["member_shift"].values[0]).tolist() == [False, False, False, True]
    assert table["member_how_with"].values[0].tolist() == how


def test_statistics_are_those_of_the_drawn_members(compared):
    places = [1.00, 1.01, 1.02, 1.03, 1.05]
    names = [f"box_{i:03d}" for i in range(1, 6)]
    hot = {name: [place, 1.16, NAN, NAN] for name, place in zip(names, places, strict=True)}
    hot |= {"torque_low": [0.5, 0.5, 0.5, 0.5], "box_005": [1.05, 1.16, 1.23, NAN]}
    table = compared(members={"without": dict.fromkeys(hot, WITHOUT), "with": hot})
    assert drawn(table).tolist() == [name != "torque_low" for name in hot]
    found = spread(table)
    assert found["exists"].tolist() == [5, 5, 1, 0]
    assert found["median"][:2] == pytest.approx([-0.02, -0.03])
    assert (found["low"][0], found["high"][0]) == (pytest.approx(-0.038), pytest.approx(0.006))
    assert np.isnan([found[name][2:] for name in ("median", "low", "high")]).all()
    assert found["earlier"][:3] == pytest.approx([0.8, 1.0, 1.0]) and np.isnan(found["earlier"][3])


def test_an_ensemble_without_members_is_empty(compared):
    table = compared(members={"without": {}, "with": {}})
    assert table.sizes["member"] == 0
    assert spread(table)["exists"].tolist() == [0, 0, 0, 0]
