"""Motion classes over the mesh frequency: from rest, and carried on."""

import numpy as np
import pytest

from gearwear.integrate.strobe import GENERAL
from gearwear.motions.settling import Settling, settle
from gearwear.motions.start import rest_state
from gearwear.onsets import motions
from gearwear.oscillator.excitation import Excitation
from gearwear.oscillator.periodic import Harmonics

SETTLING = Settling(200, 800, 160, 16, 1e-7, 3e-3)
DYNAMICS = {
    "damping_ratio": 0.05,
    "tolerance": 1e-10,
    "torque_fluctuation": {"frequency_ratio": 1.0, "amplitudes": [], "phases": []},
    "start": {"at": "pair_entry", "displacement": 1.1, "velocity": 0.0},
}
LOSS = 0.8206311  # constant stiffness: mesh frequency above which the motion in contact ends; hysteresis below it


@pytest.fixture(scope="module")
def source():
    """A mesh of constant stiffness whose error excites half the mean force."""
    waves = Harmonics(0.0, (1.0,), (0.0,))
    return Excitation(1.0, 1.0, 1.0, 0.1, 0.1, Harmonics(1.0), waves, 0.05, 0.05, 1.0, Harmonics(1.0), 0.5)


@pytest.mark.parametrize("backend", ["automatic", GENERAL])
def test_motions_from_rest_are_those_that_settle_there(source, backend):
    values = np.array([0.5, 0.74, 0.9])
    found = motions.from_rest(source, DYNAMICS, SETTLING, values, backend=backend)
    alone = [
        settle(oscillator, rest_state(source, oscillator, DYNAMICS), SETTLING).motion_class
        for oscillator in (source.oscillator(DYNAMICS, value) for value in values)
    ]
    assert found.tolist() == alone


def test_no_values_no_classes(source):
    assert motions.from_rest(source, DYNAMICS, SETTLING, np.array([])).tolist() == []
    assert motions.carried_on(source, DYNAMICS, SETTLING, np.array([]), (1.1, 0.0), "up").tolist() == []


def test_tolerance_and_backend_reach_the_integrator(source, monkeypatch):
    asked = []

    def record(oscillators, starts, settling, tolerance, detail, backend):
        asked.append((len(oscillators), tolerance, backend))
        return []

    monkeypatch.setattr(motions, "settle_many", record)
    motions.from_rest(source, DYNAMICS, SETTLING, np.array([0.5, 0.6]))
    motions.from_rest(source, DYNAMICS, SETTLING, np.array([0.5]), 5e-11, GENERAL)
    assert asked == [(2, 1e-10, "automatic"), (1, 5e-11, "general")]


@pytest.mark.parametrize(("order", "first"), [("up", 0.60), ("down", LOSS - 1e-3)])
def test_a_chain_begins_at_its_end_from_the_state_given(source, monkeypatch, order, first):
    begins, values = [], np.array([0.60, 0.74, LOSS - 1e-3])
    real = motions.carried

    def record(oscillators, rest, settling, tolerance):
        begins.append((oscillators[0].frequency, rest(oscillators[0])))
        return [motion._replace(period=7) for motion in real(oscillators, rest, settling, tolerance)]

    monkeypatch.setattr(motions, "carried", record)
    motions.carried_on(source, DYNAMICS, SETTLING, values, (1.1, 0.0), order)
    assert begins == [(first, (1.1, 0.0))]


def test_classes_of_a_chain_come_in_ascending_order(source, monkeypatch):
    def numbered(oscillators, rest, settling, tolerance):
        motion = settle(oscillators[0], (1.1, 0.0), SETTLING)
        return [motion._replace(motion_class=round(10 * one.frequency)) for one in oscillators]

    monkeypatch.setattr(motions, "carried", numbered)
    for order in ("up", "down"):
        found = motions.carried_on(source, DYNAMICS, SETTLING, np.array([0.5, 0.6, 0.7]), (1.1, 0.0), order)
        assert found.tolist() == [5, 6, 7]
