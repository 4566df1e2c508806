"""Many oscillators in one call against each of them alone."""

import dataclasses

import numpy as np
import pytest

from gearwear.integrate import strobe_many as strobe_many_module
from gearwear.integrate.affine.cycle_detection import fill_if_recurring
from gearwear.integrate.status import BLOW_UP, COMPLETED, GROWTH, MAPS, RECORDS, STATES
from gearwear.integrate.strobe import strobe
from gearwear.integrate.strobe_many import strobe_many
from gearwear.oscillator.oscillator import ExternalTorque, Oscillator
from gearwear.oscillator.periodic import Harmonics, PeriodicTable

CHAOTIC = Oscillator(1.4, 0.1, 0.1, Harmonics(1.0, (-0.4,), (0.0,)), Harmonics(0.0, (0.1,), (0.0,)))
BREAKS = (0.0, 0.37, 1.0)


def unlike_oscillators():
    """Every kind of parameter in lanes side by side: harmonics, tables with kicks, clearance, damping, force."""
    random = np.random.default_rng(3)
    oscillators = [CHAOTIC.at_frequency(w) for w in np.linspace(0.15, 2.1, 21)]
    for i in range(12):
        oscillators.append(
            Oscillator(
                random.uniform(0.2, 2.0),
                random.uniform(0.01, 0.1),
                random.uniform(-0.2, 0.3),
                PeriodicTable(BREAKS, (1.3, 0.8), (1.2, 0.7)) if i % 3 == 1 else Harmonics(1.0, (0.3, 0.1), (0.0, 1.0)),
                PeriodicTable(BREAKS, (0.0, 0.15), (0.05, 0.02)) if i % 3 else Harmonics(0.0, (0.2,), (0.5,)),
                Harmonics(10.0 ** -(i % 4), (0.2 * 10.0 ** -(i % 4),), (0.4,)) if i % 2 else Harmonics(0.3),
                ExternalTorque(1.0, (0.05, 0.02, 0.01), (0.2, 0.0, 0.5)) if i == 5 else ExternalTorque(),
            )
        )
    return oscillators


def assert_same(point, many, p):
    for name in point._fields:
        one, all_of_them = getattr(point, name), getattr(many, name)
        if one is None:
            assert all_of_them is None
        else:
            np.testing.assert_array_equal(one, all_of_them[p], err_msg=f"{name} of point {p}")


@pytest.mark.parametrize("detail", [STATES, GROWTH, MAPS, RECORDS])
def test_every_point_is_that_of_strobe_to_the_last_bit(detail):
    oscillators = unlike_oscillators()
    starts = np.random.default_rng(1).uniform(-1.5, 1.5, (len(oscillators), 2))
    many = strobe_many(oscillators, starts, 30, detail=detail)
    for p, (oscillator, start) in enumerate(zip(oscillators, starts, strict=True)):
        assert_same(strobe(oscillator, start, 30, detail=detail), many, p)


def test_records_of_many_are_those_of_one_wherever_their_extremes_lie():
    """Forces with several peaks a period, equal ones, on both flanks, and constant ones."""
    random = np.random.default_rng(7)
    oscillators = [
        Oscillator(
            random.uniform(0.1, 2.0),
            random.choice([0.01, 0.1]),
            random.choice([0.1, -0.1, 0.0]),
            Harmonics(1.0, tuple(random.uniform(0.0, 0.25, 3)), tuple(random.uniform(0.0, 6.0, 3))),
            Harmonics(0.0, tuple(random.choice([0.0, 0.01, 0.3]) / (1 + np.arange(3))), tuple(random.uniform(0, 6, 3))),
            Harmonics(1.0, (random.choice([0.0, 0.2]),), (1.0,)),
        )
        for _ in range(160)
    ]
    starts = random.uniform(-1.5, 1.5, (len(oscillators), 2))
    many = strobe_many(oscillators, starts, 40)
    for p, (oscillator, start) in enumerate(zip(oscillators, starts, strict=True)):
        assert_same(strobe(oscillator, start, 40), many, p)


def test_neighbours_do_not_matter():
    oscillators = unlike_oscillators()
    many = strobe_many(oscillators, (0.3, 0.1), 40, detail=GROWTH)
    turned = strobe_many(oscillators[5:][::-1], (0.3, 0.1), 40, detail=GROWTH)
    np.testing.assert_array_equal(many.states[5:], turned.states[::-1])
    np.testing.assert_array_equal(many.growth[5:], turned.growth[::-1])


def test_many_states_of_one_oscillator():
    starts = np.random.default_rng(2).uniform(-2, 2, (37, 2))
    many = strobe_many([CHAOTIC] * 37, starts, 20)
    for p in range(37):
        assert_same(strobe(CHAOTIC, starts[p], 20), many, p)


def test_what_the_map_does_not_serve_is_integrated(monkeypatch):
    torque = dataclasses.replace(CHAOTIC, torque=ExternalTorque(0.618, (0.05,), (0.4,)))
    monkeypatch.setattr(strobe_many_module, "LONGEST_TABLE", 40)
    oscillators = [CHAOTIC, torque, CHAOTIC.at_frequency(0.2), CHAOTIC.at_frequency(1.1)]
    many = strobe_many(oscillators, (0.0, 0.0), 5, first_period=3)
    for p, oscillator in enumerate(oscillators):
        assert_same(strobe(oscillator, (0.0, 0.0), 5, first_period=3), many, p)


def test_blow_up_of_one_point_leaves_the_others_alone():
    driven = dataclasses.replace(CHAOTIC, error=Harmonics(0.0, (3e6,), (0.0,)))
    many = strobe_many([CHAOTIC, driven, CHAOTIC], (0.3, 0.1), 5)
    assert list(many.status) == [COMPLETED, BLOW_UP, COMPLETED]
    assert np.isnan(many.states[1, -1]).all()
    np.testing.assert_array_equal(many.states[0], many.states[2])
    assert_same(strobe(CHAOTIC, (0.3, 0.1), 5), many, 0)


@pytest.mark.parametrize("detail", [STATES, GROWTH, MAPS, RECORDS])
def test_detect_cycles_changes_no_bit(detail):
    """Periods 1, 2 and 4 recur and are filled in; chaos and a blow-up are run to the end. Growth alone is rounded."""
    driven = dataclasses.replace(CHAOTIC, error=Harmonics(0.0, (3e6,), (0.0,)))
    oscillators = [*(CHAOTIC.at_frequency(w) for w in (0.4, 0.9, 1.1, 1.21, 1.4)), driven]
    whole = strobe_many(oscillators, (0.0, 0.0), 1500, detail=detail)
    early = strobe_many(oscillators, (0.0, 0.0), 1500, detail=detail, detect_cycles=True)
    for p, oscillator in enumerate(oscillators):
        assert_same(strobe(oscillator, (0.0, 0.0), 1500, detail=detail, detect_cycles=True), early, p)
    for name in whole._fields:
        if detail == GROWTH and name in ("growth", "tangent"):
            np.testing.assert_allclose(getattr(early, name), getattr(whole, name), atol=1e-11)
        elif getattr(whole, name) is None:
            assert getattr(early, name) is None
        else:
            np.testing.assert_array_equal(getattr(early, name), getattr(whole, name), err_msg=name)


@pytest.mark.parametrize("period", [1, 2, 3, 5])
def test_recurring_states_are_filled_in(period):
    cycle = np.random.default_rng(period).uniform(size=(period, 2))
    states = np.concatenate([np.random.default_rng(9).uniform(size=(7, 2)), np.resize(cycle, (40, 2))])
    expected = states.copy()
    filled, nothing, none = 0, np.zeros(0), np.zeros((0, 2, 2))
    for reached in range(1, 47):
        rest = states.copy()
        rest[reached + 1 :] = np.nan
        if fill_if_recurring(reached, STATES, nothing, rest, none, nothing, none[:, 0]):
            filled += 1
            np.testing.assert_array_equal(rest, expected)
    assert filled > 0
    unlike = np.arange(100.0).reshape(50, 2)
    assert not any(
        fill_if_recurring(reached, STATES, nothing, unlike, none, nothing, none[:, 0]) for reached in range(1, 50)
    )


@pytest.mark.parametrize(
    "oscillators, states, message",
    [
        ([], np.zeros((0, 2)), "oscillators"),
        ([CHAOTIC], (0.0, np.inf), "state"),
        ([CHAOTIC] * 2, np.zeros((3, 2)), "state"),
    ],
)
def test_impossible_oscillators_and_states_are_refused(oscillators, states, message):
    with pytest.raises(ValueError, match=message):
        strobe_many(oscillators, states, 1)
