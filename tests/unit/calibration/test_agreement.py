"""Agreement with the claims as a search weighs it."""

import numpy as np
import pytest

from gearwear.calibration.agreement import HEADLINE, about_motion, agreements
from gearwear.claims.sweeps import CHAOTIC, Sweep

SWEPT = np.linspace(0.1, 1.7, 161)


def sweep(classes):
    return Sweep(SWEPT, np.asarray(classes), np.zeros((len(SWEPT), 4)))


def route(doubling, chaos):
    """Period 1, then 2, then chaos."""
    classes = np.where(doubling - 1e-9 > SWEPT, 1, 2)
    classes[chaos - 1e-9 <= SWEPT] = CHAOTIC
    return sweep(classes)


def judged(claim, **cases):
    agrees, merit = agreements([claim], {(case, "mesh_frequency"): one for case, one in cases.items()})
    return bool(agrees[0]), float(merit[0])


WINDOW = {"id": "w", "kind": "window", "case": "with", "sweep": "mesh_frequency", "range": [0.5, 1.0], "class": ["P2"]}
EVENT = {"id": "e", "kind": "numeric", "case": "with", "sweep": "mesh_frequency", "event": "P1->P2", "expected": 1.0}
FIRST = {"id": HEADLINE, "kind": "qualitative"}


def test_half_of_a_window_agrees_and_less_is_worth_its_share():
    assert judged(WINDOW, **{"with": route(0.75, 1.5)})[0]
    agrees, merit = judged(WINDOW, **{"with": route(0.9, 1.5)})
    assert not agrees
    assert merit == pytest.approx((11 / 51) / 0.5)


def test_the_worst_case_of_a_window_counts():
    both = {**WINDOW, "case": ["without", "with"]}
    assert judged(both, without=route(0.4, 1.5), **{"with": route(0.4, 1.5)}) == (True, pytest.approx(1.1))
    assert judged(both, without=route(1.2, 1.5), **{"with": route(0.4, 1.5)}) == (False, 0.0)


def test_an_event_agrees_within_the_tolerance_and_loses_worth_beyond_it():
    assert judged(EVENT, **{"with": route(1.02, 1.5)})[0]
    near, far = (judged(EVENT, **{"with": route(at, 1.5)}) for at in (1.06, 1.2))
    assert not near[0] and not far[0]
    assert 1.0 > near[1] > far[1] > 0.0


def test_an_event_that_is_absent_is_worth_nothing():
    assert judged(EVENT, **{"with": sweep(np.ones(len(SWEPT), dtype=int))}) == (False, 0.0)


def test_the_headline_compares_the_onsets_of_chaos():
    early, late = route(1.0, 1.3), route(1.0, 1.4)
    assert judged(FIRST, without=late, **{"with": early}) == (True, 1.0)
    assert judged(FIRST, without=early, **{"with": late}) == (False, 0.0)
    assert judged(FIRST, without=early, **{"with": early}) == (False, 0.0)


def test_only_claims_that_sweeps_decide_are_kept():
    other = {"id": "wear-zero-at-pitch", "kind": "qualitative"}
    assert about_motion([WINDOW, other, EVENT, FIRST]) == [WINDOW, EVENT, FIRST]
