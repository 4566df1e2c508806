"""What becomes of initial states."""

import numpy as np
import pytest

from gearwear.codes.motion_class import CHAOTIC, NOT_CONVERGED, QUASI_PERIODIC
from gearwear.motions.destinations import destinations, share_escaping
from gearwear.motions.settling import Settling, settle
from gearwear.oscillator.oscillator import ExternalTorque, Oscillator
from gearwear.oscillator.periodic import Harmonics

SETTLING = Settling(200, 1600, 160, 16, 1e-7, 3e-3)
STATES = np.random.default_rng(3).uniform(-2.0, 2.0, (24, 2))


def route(frequency):
    return Oscillator(frequency, 0.1, 0.1, Harmonics(1.0, (-0.4,), (0.0,)), Harmonics(0.0, (0.1,), (0.0,)))


@pytest.mark.parametrize("frequency", [0.4, 1.1, 1.21, 1.28, 1.4])
def test_every_fate_is_the_class_its_state_settles_to(frequency):
    found = destinations(route(frequency), STATES, SETTLING)
    assert found.motion_class.tolist() == [settle(route(frequency), state, SETTLING).motion_class for state in STATES]


def test_no_fate_depends_on_the_others():
    """Chaos and a motion of period 1, in another order and in other company."""
    for oscillator in (route(1.4), route(0.6)):
        whole = destinations(oscillator, STATES, SETTLING)
        turned = destinations(oscillator, STATES[::-1], SETTLING, together=5)
        for one, other in zip(whole, turned, strict=True):
            np.testing.assert_array_equal(one, other[::-1])


def test_the_box_is_that_of_the_section():
    found = destinations(route(1.4), STATES, SETTLING)
    assert set(found.motion_class) == {CHAOTIC}
    assert np.all(found.sections.min(axis=1) >= found.low) and np.all(found.sections.max(axis=1) <= found.high)
    settled = settle(route(1.4), STATES[0], SETTLING)
    np.testing.assert_allclose(found.high.max(axis=0)[0], settled.displacement.max(), atol=0.05)


def test_what_the_longest_transient_does_not_decide_stays_undecided():
    """Period 1 with a multiplier of -0.99: 50 periods are too few."""
    slow = Oscillator(
        1.97,
        0.05,
        0.1,
        Harmonics(1.0, (-0.2, -0.1, -0.05), (0.0,) * 3),
        Harmonics(0.0, (0.01, 0.004, 0.002), (0.0,) * 3),
    )
    short = Settling(10, 20, 32, 4, 1e-10, 3e-3)
    assert set(destinations(slow, STATES, short).motion_class) == {NOT_CONVERGED}


def test_a_second_frequency_gives_quasi_periodic_destinations():
    stiffness, error = Harmonics(1.0, (-0.1,), (0.0,)), Harmonics(0.0, (0.02,), (0.0,))
    torque = ExternalTorque((np.sqrt(5) - 1) / 2, (0.02,), (0.0,))
    oscillator = Oscillator(0.9, 0.1, 0.1, stiffness, error, torque=torque)
    assert set(destinations(oscillator, STATES[:2], SETTLING).motion_class) == {QUASI_PERIODIC}


def test_chaos_does_not_escape_and_a_periodic_motion_does():
    assert share_escaping(route(1.4), STATES, SETTLING) == 0.0
    assert share_escaping(route(1.1), STATES, SETTLING) == 1.0
