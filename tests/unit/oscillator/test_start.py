"""Where in the mesh period a motion starts, and the mesh force along it."""

import numpy as np
import pytest

from gearwear.integrate.strobe import trace
from gearwear.oscillator.excitation import restoring_force
from gearwear.oscillator.oscillator import ExternalTorque, Oscillator
from gearwear.oscillator.periodic import Harmonics, PeriodicTable

TABLE = PeriodicTable((0.0, 0.4, 1.0), (1.3, 0.8), (1.1, 0.7))
WAVE = Harmonics(1.0, (0.3, 0.1), (-2.0, 0.4))


@pytest.mark.parametrize("function", [TABLE, WAVE])
@pytest.mark.parametrize("shift", [0.0, 0.25, 0.4, 0.7])
def test_a_shifted_function_is_the_same_function_of_time(function, shift):
    phase = np.linspace(0.013, 0.987, 41)
    np.testing.assert_allclose(function.seen_from(shift).at(phase), function.at((phase + shift) % 1.0), rtol=1e-12)


@pytest.mark.parametrize("stiffness", [WAVE, TABLE])
def test_a_run_begun_inside_the_period_joins_the_run_from_its_beginning(stiffness):
    whole = Oscillator(
        0.9,
        0.05,
        0.2,
        stiffness=stiffness,
        error=Harmonics(0.0, (0.2,), (1.1,)),
        clearance=Harmonics(1.0, (0.05,), (0.3,)),
        torque=ExternalTorque(1.37, (0.03, 0.02), (0.2, 1.0)),
    )
    begin = 0.35
    displacement, velocity = trace(whole, (0.4, 0.1), [begin, 1.0], 1, first_period=4)
    # the run ends where period 5 begins, the shifted one where period 0 does: five periods of torque phase
    turned = whole.torque.seen_from(5 * whole.torque.frequency_ratio)
    later = Oscillator(
        whole.frequency,
        whole.damping_ratio,
        whole.mean_force,
        whole.stiffness,
        whole.error,
        whole.clearance,
        turned,
    ).seen_from(begin)
    joined = trace(later, (displacement[0, 0], velocity[0, 0]), [1.0 - begin], 1)
    np.testing.assert_allclose(
        [joined[0][0, 0], joined[1][0, 0]], [displacement[0, 1], velocity[0, 1]], rtol=0, atol=3e-9
    )


def test_restoring_force_is_stiffness_times_what_exceeds_the_clearance():
    oscillator = Oscillator(1.0, 0.05, 0.2, stiffness=WAVE, clearance=Harmonics(0.8))
    phase = np.array([0.1, 0.5, 0.9])
    force = restoring_force(oscillator, phase, np.array([[1.0, 0.5, -0.8], [-1.0, 0.8, 2.0]]))
    k = WAVE.at(phase)
    np.testing.assert_allclose(force, [[0.2 * k[0], 0.0, 0.0], [-0.2 * k[0], 0.0, 1.2 * k[2]]], atol=1e-15)


def test_jump_of_a_table_stands_at_its_breaks_only():
    np.testing.assert_allclose(TABLE.jump([0.0, 0.2, 0.4, 0.7, 1.0]), [0.6, 0.0, -0.3, 0.0, 0.6], atol=1e-15)
    assert not WAVE.jump(np.linspace(0, 1, 5)).any()


def test_displacement_plus_error_is_continuous_across_a_jump_of_the_error():
    error = PeriodicTable((0.0, 0.6, 1.0), (0.10, 0.35), (0.20, 0.30))
    oscillator = Oscillator(0.7, 0.05, 0.3, Harmonics(1.0), error)
    phases = np.array([0.6 - 1e-7, 0.6, 1.0 - 1e-7, 1.0])
    displacement, _ = trace(oscillator, (1.3, 0.0), phases, 1)
    before = displacement[0] + error.jump(phases)
    np.testing.assert_allclose(before[[1, 3]], before[[0, 2]], atol=1e-6)
