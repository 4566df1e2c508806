"""Agreement with the claims as a search weighs it."""

import numpy as np
import pytest
import xarray as xr

from gearwear.calibration.agreement import HEADLINE, agreements, judged, subject
from gearwear.claims.study import Study
from gearwear.claims.sweeps import CHAOTIC, Sweep

SWEPT = np.linspace(0.1, 1.7, 161)


def sweep(classes):
    return Sweep(SWEPT, np.asarray(classes), np.zeros((len(SWEPT), 4)))


def route(doubling, chaos):
    """Period 1, then 2, then chaos."""
    classes = np.where(doubling - 1e-9 > SWEPT, 1, 2)
    classes[chaos - 1e-9 <= SWEPT] = CHAOTIC
    return sweep(classes)


def verdict(claim, **cases):
    agrees, merit = agreements([claim], {(case, "mesh_frequency"): one for case, one in cases.items()}, NOTHING)
    return bool(agrees[0]), float(merit[0])


WINDOW = {"id": "w", "kind": "window", "case": "with", "sweep": "mesh_frequency", "range": [0.5, 1.0], "class": ["P2"]}
EVENT = {"id": "e", "kind": "numeric", "case": "with", "sweep": "mesh_frequency", "event": "P1->P2", "expected": 1.0}
FIRST = {"id": HEADLINE, "kind": "qualitative"}
NOTHING = Study({}, (("with", 1),))


def test_half_of_a_window_agrees_and_less_is_worth_its_share():
    assert verdict(WINDOW, **{"with": route(0.75, 1.5)})[0]
    agrees, merit = verdict(WINDOW, **{"with": route(0.9, 1.5)})
    assert not agrees
    assert merit == pytest.approx((11 / 51) / 0.5)


def test_the_worst_case_of_a_window_counts():
    both = {**WINDOW, "case": ["without", "with"]}
    assert verdict(both, without=route(0.4, 1.5), **{"with": route(0.4, 1.5)}) == (True, pytest.approx(1.1))
    assert verdict(both, without=route(1.2, 1.5), **{"with": route(0.4, 1.5)}) == (False, 0.0)


def test_an_event_agrees_within_the_tolerance_and_loses_worth_beyond_it():
    assert verdict(EVENT, **{"with": route(1.02, 1.5)})[0]
    near, far = (verdict(EVENT, **{"with": route(at, 1.5)}) for at in (1.06, 1.2))
    assert not near[0] and not far[0]
    assert 1.0 > near[1] > far[1] > 0.0


def test_an_event_that_is_absent_is_worth_nothing():
    assert verdict(EVENT, **{"with": sweep(np.ones(len(SWEPT), dtype=int))}) == (False, 0.0)


def test_the_headline_compares_the_onsets_of_chaos():
    early, late = route(1.0, 1.3), route(1.0, 1.4)
    assert verdict(FIRST, without=late, **{"with": early}) == (True, 1.0)
    assert verdict(FIRST, without=early, **{"with": late}) == (False, 0.0)
    assert verdict(FIRST, without=early, **{"with": early}) == (False, 0.0)


def test_claims_about_wear_are_judged_as_by_the_scorecard():
    claim = {"id": "wear-grows-with-cycles", "kind": "qualitative"}
    for rates, expected in (((1.0, 1.0, 1.0), True), ((1.0, 1.0, 0.0), False)):
        agrees, merit = agreements([claim], {}, worn(np.array(rates)))
        assert (bool(agrees[0]), float(merit[0])) == (expected, float(expected))


def worn(rates):
    """Wear of three cycles at three nodes, the pitch point in the middle."""
    path = np.array([1.0, 2.0, 3.0])
    geometry = xr.Dataset({"pitch_point": 2.0, "base_pitch": 1.0})
    results = {
        ("wear", "with", q): xr.Dataset(
            {"wear_depth": (("gear", "path"), q * np.array([rates, rates]))}, {"gear": ["pinion", "gear"], "path": path}
        )
        for q in range(3)
    }
    return Study({"geometry": geometry} | results, (("with", 2),))


def test_a_claim_without_wear_to_judge_does_not_agree():
    assert not agreements([{"id": "wear-zero-at-pitch", "kind": "qualitative"}], {}, NOTHING)[0][0]


def test_claims_that_sweeps_or_wear_decide_are_kept():
    wear, other = ({"id": name, "kind": "qualitative"} for name in ("wear-zero-at-pitch", "tvms-falls-with-wear"))
    assert judged([WINDOW, wear, other, EVENT, FIRST]) == [WINDOW, wear, EVENT, FIRST]
    assert [subject(claim) for claim in (WINDOW, wear, FIRST)] == ["mesh_frequency", "states", "mesh_frequency"]
