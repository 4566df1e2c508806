"""Chains of settled motions: constant stiffness, whose loss of contact has a closed form and hysteresis below it."""

import numpy as np
import pytest

from gearwear.motions.motion_variables import end_of
from gearwear.motions.settling import Settling, settle
from gearwear.motions.sweep import carried
from gearwear.oscillator.oscillator import Oscillator
from gearwear.oscillator.periodic import Harmonics

SETTLING = Settling(200, 1600, 160, 16, 1e-7, 3e-3)
LOSS = 0.8206311  # mesh frequency above which the motion in contact ends


def oscillator(frequency):
    return Oscillator(frequency, 0.05, 0.1, Harmonics(1.0), Harmonics(0.0, (0.05,), (0.0,)))


def at_equilibrium(_):
    return 1.1, 0.0


def test_a_chain_stays_on_its_motion_where_another_one_exists():
    frequencies = [0.60, 0.74, LOSS - 1e-3, LOSS + 1e-3]
    up = carried(map(oscillator, frequencies), at_equilibrium, SETTLING)
    down = carried(map(oscillator, frequencies[::-1]), at_equilibrium, SETTLING)[::-1]
    assert [motion.contact_loss_share > 0 for motion in up] == [False, False, False, True]
    assert [motion.contact_loss_share > 0 for motion in down] == [False, True, True, True]


def test_a_point_starts_where_its_neighbour_ended():
    first, second = carried(map(oscillator, [0.9, 0.8]), at_equilibrium, SETTLING)
    alone = settle(oscillator(0.8), end_of(first), SETTLING)
    np.testing.assert_array_equal(second.displacement, alone.displacement)


@pytest.mark.parametrize("end, begins", [(np.nan, (1.1, 0.0)), (0.3, (0.3, 0.2))])
def test_a_motion_without_an_end_is_not_carried_on(monkeypatch, end, begins):
    lost = settle(oscillator(0.6), (1.1, 0.0), SETTLING)
    lost.displacement[-1], lost.velocity[-1] = end, 0.2
    starts = []
    monkeypatch.setattr("gearwear.motions.sweep.settle", lambda _, start, *rest: starts.append(start) or lost)
    carried([oscillator(0.6), oscillator(0.6)], at_equilibrium, SETTLING)
    assert starts == [(1.1, 0.0), begins]
