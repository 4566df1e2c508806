"""The map over several mesh periods."""

import numpy as np
import pytest

from gearwear.integrate.strobe import monodromy
from gearwear.orbits.return_map import return_maps
from gearwear.oscillator.oscillator import ExternalTorque, Oscillator


def test_the_map_is_that_of_the_motion(large_fluctuation):
    passage = return_maps(large_fluctuation)(1.1, 3)((0.4, -0.2))
    after, matrix = monodromy(large_fluctuation(1.1), (0.4, -0.2), 3)
    assert passage.section.shape == (4, 2)
    assert passage.section[0] == pytest.approx((0.4, -0.2), abs=0)
    assert passage.section[-1] == pytest.approx(after, abs=0)
    assert passage.matrix == pytest.approx(matrix, abs=0)


def test_a_motion_that_is_lost_is_nan():
    passage = return_maps(lambda force: Oscillator(1.0, 0.01, force))(1e9, 2)((0.0, 0.0))
    assert np.isnan(passage.section[-1]).all() and np.isnan(passage.matrix).all()


@pytest.mark.parametrize("period", [0, -1, 1.5])
def test_a_period_is_a_whole_number(large_fluctuation, period):
    with pytest.raises(ValueError, match="period: .* must be a whole number, 1 or more"):
        return_maps(large_fluctuation)(1.0, period)


def test_an_orbit_must_hold_whole_periods_of_the_torque():
    family = return_maps(lambda w: Oscillator(w, 0.1, 1.0, torque=ExternalTorque(1.5, (0.1,), (0.3,))))
    assert family(1.0, 2)((1.0, 0.0)).section.shape == (3, 2)
    with pytest.raises(ValueError, match="no whole number of periods of the external torque.* 1.5 times"):
        family(1.0, 3)


def test_what_the_oscillator_refuses_is_an_error(large_fluctuation):
    with pytest.raises(ValueError, match="frequency: -1.0"):
        return_maps(large_fluctuation)(-1.0, 1)
