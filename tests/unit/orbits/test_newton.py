"""Periodic orbits and their multipliers."""

import cmath
import math

import numpy as np
import pytest

from gearwear.integrate.strobe import strobe
from gearwear.orbits.newton import (
    FOUND,
    MOTION_LOST,
    NOT_CONVERGED,
    SINGULAR,
    minimal_period,
    multipliers,
    periodic_orbit,
)
from gearwear.orbits.return_map import return_maps
from gearwear.oscillator.oscillator import ExternalTorque, Oscillator


@pytest.mark.parametrize("zeta", [0.02, 0.3])
@pytest.mark.parametrize("frequency", [0.7, 1.3])
def test_linear_oscillator(zeta, frequency):
    """In contact throughout: x = b + F + the response; multipliers exp(-zeta T +- i sqrt(1 - zeta^2) T)."""
    oscillator = Oscillator(frequency, zeta, 3.0, torque=ExternalTorque(1.0, (0.02,), (0.0,)))
    attempt = periodic_orbit(return_maps(lambda _: oscillator, 1e-12), 0.0, (3.5, 0.1), 1)
    response = 0.02 / (1 - frequency**2 + 2j * zeta * frequency)
    expected = (4.0 + response.real, (1j * frequency * response).real)
    assert attempt.reason == FOUND and len(attempt.corrections) == 2
    assert attempt.orbit.section[0] == pytest.approx(expected, abs=1e-9)
    period = 2 * math.pi / frequency
    one = cmath.exp((-zeta + 1j * math.sqrt(1 - zeta**2)) * period)
    assert sorted(attempt.orbit.multipliers, key=lambda m: m.imag) == pytest.approx(
        sorted([one, one.conjugate()], key=lambda m: m.imag), abs=1e-9
    )
    assert attempt.orbit.stable


def test_an_orbit_of_the_torque_alone_repeats_after_its_period():
    """A torque of 3/2 of the mesh frequency makes the linear response repeat after two mesh periods."""
    oscillator = Oscillator(0.9, 0.1, 3.0, torque=ExternalTorque(1.5, (0.3,), (0.4,)))
    orbit = periodic_orbit(return_maps(lambda _: oscillator, 1e-12), 0.0, (4.0, 0.0), 2).orbit
    rate = 1.5 * 0.9
    response = 0.3 * cmath.exp(0.4j) / (1 - rate**2 + 0.2j * rate)
    expected = [(4 + sign * response.real, sign * (1j * rate * response).real) for sign in (1, -1)]
    assert np.array(expected) == pytest.approx(orbit.section, abs=1e-9)
    assert minimal_period(orbit) == 2


def test_corrections_square(large_fluctuation):
    """Contact is lost and made, and the map still has a derivative."""
    found = periodic_orbit(return_maps(large_fluctuation, 1e-13), 1.1, (0.0, 0.0), 1, accuracy=1e-11)
    assert found.reason == FOUND
    sizes = [size for size in found.corrections if 1e-12 < size < 3e-2]
    assert len(sizes) >= 3
    for size, following in zip(sizes[:-1], sizes[1:], strict=True):
        assert following < 5 * size**2 + 1e-12


def test_an_unstable_orbit_is_found_and_called_so(large_fluctuation):
    orbit = periodic_orbit(return_maps(large_fluctuation), 1.1, (0.4, 0.0), 1).orbit
    assert not orbit.stable
    assert orbit.multipliers[0].real < -1 and orbit.multipliers[0].imag == 0
    away = strobe(large_fluctuation(1.1), orbit.section[0] + (1e-7, 0.0), 400).states
    assert abs(away[-1, 0] - orbit.section[0, 0]) > 0.1


def test_a_short_period_is_seen_in_a_long_one(large_fluctuation):
    family = return_maps(large_fluctuation)
    state = strobe(large_fluctuation(1.1), (0.0, 0.0), 600).states[-1]
    twice = periodic_orbit(family, 1.1, state, 4).orbit
    assert twice.period == 4 and minimal_period(twice) == 2
    settled = periodic_orbit(family, 1.1, state, 2).orbit
    assert sorted(settled.section[:, 0]) == pytest.approx([0.17803, 1.01007], abs=6e-6)
    assert minimal_period(settled) == 2 and settled.stable


def test_steps_are_shortened_until_they_help(iterated):
    """Undamped Newton steps on arctan diverge from 3."""
    family = iterated(lambda _, s: ((s[0] + math.atan(s[0]), 0.5 * s[1]), ((1 + 1 / (1 + s[0] ** 2), 0.0), (0.0, 0.5))))
    attempt = periodic_orbit(family, 0.0, (3.0, 1.0), 1)
    assert attempt.orbit.section[0] == pytest.approx((0.0, 0.0), abs=1e-12)


def test_failures_are_values(henon, iterated):
    assert periodic_orbit(henon, -0.2, (0.0, 0.0), 1).reason == NOT_CONVERGED
    lost = periodic_orbit(return_maps(lambda force: Oscillator(1.0, 0.01, force)), 1e9, (0.0, 0.0), 1)
    assert (lost.orbit, lost.reason) == (None, MOTION_LOST)
    shift = iterated(lambda _, s: ((s[0] + 1, s[1]), ((1.0, 0.0), (0.0, 1.0))))
    assert periodic_orbit(shift, 0.0, (0.0, 0.0), 1).reason == SINGULAR


def test_multipliers_stand_by_modulus():
    assert multipliers(np.diag([0.5, -2.0])) == pytest.approx([-2.0, 0.5])
    assert multipliers(np.array([[0.0, -1.0], [1.0, 0.0]])) == pytest.approx([1j, -1j])


@pytest.mark.parametrize("state", [(0.0, math.nan), (1.0,)])
def test_bad_states_are_refused(henon, state):
    with pytest.raises(ValueError, match="must be finite numbers"):
        periodic_orbit(henon, 0.5, state, 1)


def test_a_state_of_another_size_than_that_of_the_oscillator_is_refused():
    with pytest.raises(ValueError, match="must be two finite numbers"):
        periodic_orbit(return_maps(lambda frequency: Oscillator(frequency, 0.1, 0.1)), 0.9, (0.0, 0.0, 0.0), 1)


def test_an_accuracy_must_be_positive(henon):
    with pytest.raises(ValueError, match="accuracy: 0.0"):
        periodic_orbit(henon, 0.5, (0.0, 0.0), 1, accuracy=0.0)
