import numpy as np
import pytest

from gearwear.claims.events import chaos_earlier_with_temperature_and_wear, find_event, judge_event
from gearwear.claims.study import Undecided
from gearwear.claims.sweeps import Sweep


def sweep_of(motion_class, displacement=None, swept=None) -> Sweep:
    """Return a sweep with the given classes at 1, 2, 3, ... unless `swept` is given."""
    motion_class = np.asarray(motion_class)
    swept = np.arange(1.0, motion_class.size + 1) if swept is None else np.asarray(swept)
    section = np.zeros(swept.size) if displacement is None else np.asarray(displacement, dtype=float)
    return Sweep(swept, motion_class, np.column_stack([section] * 4))


@pytest.mark.parametrize(
    ("motion_class", "event", "location"),
    [
        ([1, 1, 2, 2], "P1->P2", 2.5),
        ([1, 1, 2, 2, 1, 1, 2, 2], "P1->P2", 2.5),
        ([1, 1, 2, 1, 1, 2, 2], "P1->P2", 5.5),
        ([1, 1, 0, 2, 2], "P1->P2", 3.0),
        ([1, 1, 3, 2, 2], "P1->P2", 3.0),
        ([1, 1, 2, 2, 4, 4], "P2->P4", 4.5),
        ([1, 2, 2], "P1->P2", None),
        ([1, 1, 2, 101], "P1->P2", None),
        ([1, 1, 101, 101, 2, 2], "P1->P2", None),
        ([2, 2, 1, 1], "P1->P2", None),
        ([1, 101, 101, 1, 101, 101, 101], "chaos onset", 5.0),
        ([1, 101, 0, 101, 101], "chaos onset", 2.0),
        ([1, 101, 101], "chaos onset", None),
    ],
)
def test_events_of_a_class_sequence(motion_class, event, location):
    assert find_event(sweep_of(motion_class), event).location == location


def test_bracket_and_absence_are_reported():
    assert find_event(sweep_of([1, 1, 2, 2]), "P1->P2").found == "between 2.0000 and 3.0000"
    assert find_event(sweep_of([1, 1, 0, 1]), "P1->P2").found == "no event; 1 of 4 points not converged"


def test_sweep_without_converged_points_is_undecided():
    for event in ("P1->P2", "chaos onset"):
        with pytest.raises(Undecided, match="converged"):
            find_event(sweep_of([0, 0, 0]), event)


def test_unknown_event_is_refused():
    with pytest.raises(ValueError, match="'grazing' is unknown"):
        find_event(sweep_of([1, 1]), "grazing")


def amplitude_sweep(displacement) -> Sweep:
    """Return a sweep from 0.3 to 0.9 in steps of 0.1 with the given section displacements."""
    return sweep_of([1] * 7, displacement, np.linspace(0.3, 0.9, 7))


def test_amplitude_jump_is_the_largest_change_inside_its_range():
    event = find_event(amplitude_sweep([9.0, 1.0, 1.1, 0.7, 0.6, 9.0, 0.0]), "amplitude jump")
    assert event.location == pytest.approx(0.55)
    assert event.found == "largest change 0.400 half clearances between 0.5000 and 0.6000"


@pytest.mark.parametrize("column", range(4))
def test_amplitude_jump_sees_either_extreme_of_displacement_and_velocity(column):
    sweep = amplitude_sweep([1.0] * 7)
    extent = sweep.extent.copy()
    extent[sweep.swept > 0.65, column] -= 0.5
    event = find_event(Sweep(sweep.swept, sweep.motion_class, extent), "amplitude jump")
    assert event.location == pytest.approx(0.65)


def test_change_below_a_fifth_of_the_clearance_is_no_jump():
    event = find_event(amplitude_sweep([1.0, 1.0, 1.0, 1.19, 1.19, 1.0, 1.0]), "amplitude jump")
    assert event.location is None
    assert "largest change 0.190" in event.found


def test_points_without_a_section_are_left_out_of_the_jump():
    event = find_event(amplitude_sweep([1.0, 1.0, np.nan, 0.5, 0.5, 0.5, 0.5]), "amplitude jump")
    assert event.location == pytest.approx(0.5)
    with pytest.raises(Undecided, match="fewer than two points"):
        find_event(amplitude_sweep([1.0, 1.0, np.nan, np.nan, np.nan, 0.5, 0.5]), "amplitude jump")


def test_jump_needs_a_sweep_over_its_range():
    with pytest.raises(Undecided, match="spans"):
        find_event(sweep_of([1, 1], swept=[0.5, 0.7]), "amplitude jump")


@pytest.mark.parametrize(("expected", "holds"), [(2.5, True), (2.53, True), (2.47, True), (2.54, False)])
def test_event_agrees_within_its_tolerance(expected, holds):
    outcome, found = judge_event(sweep_of([1, 1, 2, 2]), "P1->P2", expected)
    assert outcome is holds
    assert found == "2.5000 (between 2.0000 and 3.0000)"


def test_absent_event_differs_and_stated_value_beyond_the_sweep_is_undecided():
    assert judge_event(sweep_of([1, 1, 1]), "P1->P2", 2.0)[0] is False
    with pytest.raises(Undecided, match="spans 1 to 3 only"):
        judge_event(sweep_of([1, 1, 1]), "P1->P2", 3.5)


def test_chaos_onsets_of_both_cases_are_compared(study, results):
    holds, found = chaos_earlier_with_temperature_and_wear(study)
    assert holds is True
    assert found == "with 1.2300, without 1.2700"
    with_key, without_key = (("sweep", case, "mesh_frequency") for case in ("with", "without"))
    results[with_key], results[without_key] = results[without_key], results[with_key]
    assert chaos_earlier_with_temperature_and_wear(study)[0] is False


def test_comparison_without_both_onsets_is_not_decided(study, results, make_sweep):
    results["sweep", "with", "mesh_frequency"] = make_sweep("mesh_frequency", [0.1, 1.7], [1, 1])
    assert chaos_earlier_with_temperature_and_wear(study) == (None, "with no onset, without 1.2700")
