"""Sweeps: constant stiffness, whose loss of contact has a closed form and hysteresis below it."""

import numpy as np
import pytest

from gearwear.integrate.status import GROWTH
from gearwear.integrate.strobe import GENERAL
from gearwear.motions.motion_variables import end_of
from gearwear.motions.settling import Settling, settle
from gearwear.motions.start import rest_state
from gearwear.motions.sweep import DOWN, RESTART, UP, settle_by_continuation, settle_from_rest, sweep
from gearwear.oscillator.excitation import Excitation, SweptOscillator
from gearwear.oscillator.oscillator import Oscillator
from gearwear.oscillator.periodic import Harmonics

SETTLING = Settling(200, 1600, 160, 16, 1e-7, 3e-3)
DYNAMICS = {
    "damping_ratio": 0.05,
    "tolerance": 1e-10,
    "torque_fluctuation": {"frequency_ratio": 1.0, "amplitudes": [], "phases": []},
    "start": {"at": "pair_entry", "displacement": 1.1, "velocity": 0.0},
}
LOSS = 0.8206311  # mesh frequency above which the motion in contact ends


def oscillator(frequency):
    return Oscillator(frequency, 0.05, 0.1, Harmonics(1.0), Harmonics(0.0, (0.05,), (0.0,)))


@pytest.fixture(scope="module")
def swept():
    """The oscillator of a mesh of constant stiffness whose error excites half the mean force, by its frequency."""
    waves = Harmonics(0.0, (1.0,), (0.0,))
    source = Excitation(1.0, 1.0, 1.0, 0.1, 0.1, Harmonics(1.0), waves, 0.05, 0.05, 1.0, Harmonics(1.0), 0.5)
    return SweptOscillator(source, "mesh_frequency", DYNAMICS)


def at_equilibrium(_):
    return 1.1, 0.0


def test_a_sweep_with_continuation_stays_on_its_motion_where_another_one_exists():
    frequencies = [0.60, 0.74, LOSS - 1e-3, LOSS + 1e-3]
    up, down = (
        settle_by_continuation(map(oscillator, frequencies), at_equilibrium, SETTLING, direction=direction)
        for direction in (UP, DOWN)
    )
    assert [motion.contact_loss_share > 0 for motion in up] == [False, False, False, True]
    assert [motion.contact_loss_share > 0 for motion in down] == [False, True, True, True]


def test_a_point_starts_where_its_neighbour_ended():
    first, second = settle_by_continuation(map(oscillator, [0.9, 0.8]), at_equilibrium, SETTLING)
    alone = settle(oscillator(0.8), end_of(first), SETTLING)
    np.testing.assert_array_equal(second.displacement, alone.displacement)


@pytest.mark.parametrize("end, begins", [(np.nan, (1.1, 0.0)), (0.3, (0.3, 0.2))])
def test_the_motion_after_one_without_an_end_starts_from_rest(monkeypatch, end, begins):
    lost = settle(oscillator(0.6), (1.1, 0.0), SETTLING)
    lost.displacement[-1], lost.velocity[-1] = end, 0.2
    starts = []
    monkeypatch.setattr("gearwear.motions.sweep.settle", lambda _, start, *rest: starts.append(start) or lost)
    settle_by_continuation([oscillator(0.6), oscillator(0.6)], at_equilibrium, SETTLING)
    assert starts == [(1.1, 0.0), begins]


@pytest.mark.parametrize("backend", ["automatic", GENERAL])
def test_motions_from_rest_are_those_that_settle_there_alone(swept, backend):
    oscillators = [swept.at(value) for value in (0.5, 0.74, 0.9)]
    together = settle_from_rest(swept.source, oscillators, DYNAMICS, SETTLING, detail=GROWTH, backend=backend)
    for oscillator, motion in zip(oscillators, together, strict=True):
        alone = settle(oscillator, rest_state(swept.source, oscillator, DYNAMICS), SETTLING)
        assert motion.motion_class == alone.motion_class
        np.testing.assert_allclose(motion.displacement, alone.displacement, atol=1e-6)
    assert settle_from_rest(swept.source, [], DYNAMICS, SETTLING) == []


def test_tolerance_and_backend_reach_the_integrator(swept, monkeypatch):
    asked = []
    monkeypatch.setattr(
        "gearwear.motions.sweep.settle_many", lambda own, starts, settling, *rest: asked.append((len(own), *rest)) or []
    )
    settle_from_rest(swept.source, [swept.at(0.5), swept.at(0.6)], DYNAMICS, SETTLING)
    settle_from_rest(swept.source, [swept.at(0.5)], DYNAMICS, SETTLING, tolerance=5e-11, detail=GROWTH, backend=GENERAL)
    assert asked == [(2, 1e-10, 3, "automatic"), (1, 5e-11, 1, "general")]


@pytest.mark.parametrize(("direction", "lost"), [(RESTART, 2), (UP, 1), (DOWN, 3)])
def test_a_sweep_has_its_values_in_their_order_whatever_the_direction(swept, direction, lost):
    values = np.array([0.60, 0.74, LOSS - 1e-3, LOSS + 1e-3])
    found = sweep(swept, values, SETTLING, direction)
    np.testing.assert_array_equal(found["mesh_frequency"], values)
    assert found["section_displacement"].shape == (4, SETTLING.sampled_periods)
    contact_lost = found["contact_loss_share"].values > 0
    assert contact_lost[-1] and contact_lost.sum() == lost
