"""What speaks for a class, and what against it."""

import numpy as np
import pytest

from gearwear.codes import motion_class
from gearwear.integrate.strobe import strobe
from gearwear.motions.classify import classify
from gearwear.motions.settling import Settling
from gearwear.orbits.newton import periodic_orbit
from gearwear.orbits.return_map import return_maps
from gearwear.oscillator.oscillator import ExternalTorque, Oscillator
from gearwear.oscillator.periodic import Harmonics

SAMPLES = 120
SETTLING = Settling(0, 0, SAMPLES, 16, 1e-7, 3e-3)
DAMPED, GROWING = np.full(SAMPLES, -0.1), np.full(SAMPLES, 0.5)


def look_alike(frequency, **changes):
    stiffness, error = Harmonics(1.0, (-0.4,), (0.0,)), Harmonics(0.0, (0.1,), (0.0,))
    return Oscillator(frequency, 0.1, 0.1, stiffness, error, **changes)


def orbit_of(oscillator, period, seed=(1.0, 0.0)):
    return periodic_orbit(return_maps(lambda _: oscillator), oscillator.frequency, seed, period).orbit


def seen(oscillator, states, growth=DAMPED, first_period=0):
    return classify(oscillator, states, growth, first_period, SETTLING, 1e-10)


def repeated(orbit):
    return np.tile(orbit.section, (SAMPLES // orbit.period + 1, 1))[: SAMPLES + 1]


@pytest.mark.parametrize("frequency, period", [(0.9, 1), (1.1, 2), (1.21, 4)])
def test_orbit_recurrence_and_exponent_agree(frequency, period):
    oscillator = look_alike(frequency)
    settled = strobe(oscillator, (0.0, 0.0), 3000).states[-1]
    found = seen(oscillator, strobe(oscillator, settled, SAMPLES).states)
    assert (found.motion_class, found.recurrence_period, found.stable_orbit_period) == (period, period, period)
    assert found.conflict == motion_class.AGREED
    assert found.stable_orbit_distance < 1e-7 and abs(found.multiplier) < 1


def test_slow_approach_is_known_by_the_orbit_it_leads_to():
    oscillator = look_alike(1.18)
    found = seen(oscillator, strobe(oscillator, (0.0, 0.0), 400 + SAMPLES).states[400:], first_period=400)
    assert (found.motion_class, found.recurrence_period, found.stable_orbit_period) == (2, 0, 2)
    assert 1e-7 < found.stable_orbit_distance < 1e-3
    assert found.conflict == motion_class.AGREED


def test_recurrence_of_another_period_than_the_orbit_is_a_conflict():
    oscillator = look_alike(0.9)
    states = repeated(orbit_of(oscillator, 1)) + 1e-5 * (-1.0) ** np.arange(SAMPLES + 1)[:, None]
    found = seen(oscillator, states)
    assert (found.motion_class, found.recurrence_period, found.stable_orbit_period) == (1, 2, 1)
    assert found.conflict == motion_class.OTHER_PERIOD


def test_recurrence_far_from_any_orbit_is_a_conflict():
    oscillator = look_alike(0.9)
    found = seen(oscillator, repeated(orbit_of(oscillator, 1)) + 0.01)
    assert (found.motion_class, found.recurrence_period, found.stable_orbit_period) == (1, 1, 0)
    assert found.conflict == motion_class.NO_STABLE_ORBIT
    assert np.isnan(found.multiplier.real) and np.isnan(found.stable_orbit_distance)


def test_motion_on_an_unstable_orbit_has_not_converged():
    oscillator = look_alike(1.1)
    unstable = orbit_of(oscillator, 1)
    assert abs(unstable.multipliers[0]) > 1
    found = seen(oscillator, repeated(unstable))
    assert (found.motion_class, found.period, found.recurrence_period) == (motion_class.NOT_CONVERGED, 0, 1)
    assert found.reason == motion_class.SLOW_CONVERGENCE
    assert found.conflict == motion_class.NO_STABLE_ORBIT


def test_periodic_motion_with_a_growing_tangent_is_a_conflict():
    oscillator = look_alike(0.9)
    found = seen(oscillator, repeated(orbit_of(oscillator, 1)), GROWING)
    assert (found.motion_class, found.conflict) == (1, motion_class.POSITIVE_EXPONENT)


def test_chaos_that_ends_in_a_periodic_motion_is_not_yet_decided():
    oscillator = look_alike(0.9)
    states = repeated(orbit_of(oscillator, 1))
    states[: SAMPLES - 40] += np.random.default_rng(1).normal(size=(SAMPLES - 40, 2))
    assert seen(oscillator, states, GROWING).motion_class == motion_class.NOT_CONVERGED
    states += np.random.default_rng(2).normal(size=states.shape)
    assert seen(oscillator, states, GROWING).motion_class == motion_class.CHAOTIC


def test_orbit_over_several_periods_starts_at_the_phase_of_the_torque():
    oscillator = look_alike(0.9, torque=ExternalTorque(1 / 3, (0.02,), (0.4,)))
    settled = strobe(oscillator, (0.0, 0.0), 301).states[-1]
    states = strobe(oscillator, settled, SAMPLES, first_period=301).states
    found = seen(oscillator, states, first_period=301)
    assert (found.motion_class, found.stable_orbit_period, found.conflict) == (3, 3, motion_class.AGREED)
    assert found.stable_orbit_distance < 1e-7
