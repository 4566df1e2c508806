"""Validation, changes and coefficients of the oscillator."""

import dataclasses

import numpy as np
import pytest

from gearwear.integrate.strobe import strobe
from gearwear.oscillator.oscillator import ExternalTorque, Oscillator
from gearwear.oscillator.periodic import Harmonics, PeriodicTable

SOUND = Oscillator(1.1, 0.1, 0.1, Harmonics(1.0, (-0.4,), (0.0,)), Harmonics(0.0, (0.1,), (0.0,)))


@pytest.mark.parametrize(
    "change, message",
    [
        ({"frequency": 0.0}, "frequency: 0.0"),
        ({"frequency": np.nan}, "frequency: nan"),
        ({"damping_ratio": 0.0}, "damping_ratio: 0.0"),
        ({"damping_ratio": -0.1}, "damping_ratio: -0.1"),
        ({"mean_force": np.inf}, "mean_force: inf"),
        ({"clearance": Harmonics(0.0)}, "clearance: least value"),
        ({"clearance": Harmonics(1.0, (1.0,), (0.3,))}, "clearance: least value"),
        ({"stiffness": Harmonics(1.0, (0.7, 0.4), (0.0, np.pi))}, "stiffness: least value"),
        ({"stiffness": PeriodicTable((0.0, 1.0), (1.0,), (0.0,))}, "stiffness: least value"),
    ],
)
def test_impossible_oscillators_are_refused(change, message):
    with pytest.raises(ValueError, match=message):
        dataclasses.replace(SOUND, **change)


@pytest.mark.parametrize(
    "arguments, message",
    [
        ((np.nan, (0.1,), (0.0,)), "external torque: nan"),
        ((0.0, (0.1,), (0.0,)), "external torque: frequency_ratio 0.0"),
        ((1.0, (np.inf,), (0.0,)), "external torque amplitudes: inf"),
        ((1.0, (0.1, 0.2), (0.0,)), "external torque: 2 amplitudes but 1 phases"),
    ],
)
def test_impossible_torques_are_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        ExternalTorque(*arguments)


def test_stiffness_that_stays_positive_is_accepted():
    wave = Harmonics(1.0, (0.7, 0.4), (0.0, 0.0))
    assert dataclasses.replace(SOUND, stiffness=wave).stiffness is wave


def test_two_tables_need_the_same_breaks():
    stiffness = PeriodicTable((0.0, 0.5, 1.0), (1.0, 1.0), (1.0, 1.0))
    error = PeriodicTable((0.0, 0.4, 1.0), (0.0, 0.0), (0.0, 0.0))
    with pytest.raises(ValueError, match="unlike breaks"):
        Oscillator(1.0, 0.1, 0.1, stiffness, error)


def test_it_is_immutable():
    with pytest.raises(dataclasses.FrozenInstanceError):
        SOUND.frequency = 2.0


def test_another_length_unit_scales_the_motion_only():
    oscillator = dataclasses.replace(SOUND, torque=ExternalTorque(0.7, (0.02,), (0.3,)))
    scaled = oscillator.in_length_unit(0.25)
    motion = strobe(oscillator, (0.3, 0.1), 5, tolerance=1e-12)
    other = strobe(scaled, (1.2, 0.4), 5, tolerance=1e-12)
    np.testing.assert_allclose(other.states, 4 * motion.states, atol=1e-9)
    np.testing.assert_allclose(other.lost, motion.lost, atol=1e-9)


def test_changes_of_the_sweeps():
    assert SOUND.at_frequency(0.5).frequency == 0.5
    assert SOUND.with_error_scaled(3.0).error.amplitudes == pytest.approx((0.3,))
    assert SOUND.with_clearance_scaled(0.5).clearance.mean == 0.5
    with pytest.raises(ValueError, match="length unit"):
        SOUND.in_length_unit(0.0)


def test_second_frequency_is_one_that_the_mesh_does_not_have():
    assert not SOUND.has_second_frequency
    assert not dataclasses.replace(SOUND, torque=ExternalTorque(2.0, (0.1,), (0.0,))).has_second_frequency
    assert dataclasses.replace(SOUND, torque=ExternalTorque(0.3, (0.1,), (0.0,))).has_second_frequency
    assert dataclasses.replace(SOUND, torque=ExternalTorque(0.5, (0.1, 0.2), (0.0, 0.0))).has_second_frequency
    assert not dataclasses.replace(SOUND, torque=ExternalTorque(0.5, (0.0, 0.2), (0.0, 0.0))).has_second_frequency


def test_a_torque_repeats_when_all_its_harmonics_do():
    torque = ExternalTorque(1.5, (0.1, 0.2), (0.0, 0.0))
    assert [torque.repeats_after(n) for n in (1, 2, 3, 4)] == [False, True, False, True]
    assert ExternalTorque(1.5, (0.0, 0.2), (0.0, 0.0)).repeats_after(1)


def test_kernels_read_stiffness_force_and_clearance_with_their_phases():
    """The force is -e'', by central differences of e over the mesh phase."""
    waves = [Harmonics(1.0, (0.2, 0.1), (0.7, -2.1)), Harmonics(0.0, (0.3, 0.05), (-1.2, 0.4))]
    oscillator = Oscillator(0.8, 0.05, 0.1, *waves, Harmonics(1.0, (0.1,), (2.5,)))
    phase, step = np.linspace(0, 1, 17), 1e-4
    bend = waves[1].at(phase + step) - 2 * waves[1].at(phase) + waves[1].at(phase - step)
    expected = [waves[0].at(phase) - 1, -bend / (step * oscillator.period) ** 2, oscillator.clearance.at(phase) - 1]
    angle = 2 * np.pi * np.arange(1, 3)[:, None] * phase
    for column, values in enumerate(expected):
        cosine, sine = oscillator.coefficients.harmonics[:, 2 * column : 2 * column + 2].T
        np.testing.assert_allclose(cosine @ np.cos(angle) + sine @ np.sin(angle), values, atol=1e-6)
