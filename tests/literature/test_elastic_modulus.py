"""Elastic modulus of hot steel; the tabulated values are in config/validation.yaml."""

import numpy as np
import pytest

from gearwear.contact.modulus import modulus_ratio


def test_default_laws_agree_at_gear_temperatures():
    temperature = np.linspace(20, 200, 50)
    laws = [modulus_ratio(temperature, law) for law in ("li", "linear", "table")]
    assert np.ptp(laws, axis=0).max() < 3e-3


@pytest.mark.parametrize(("temperature", "loss"), [(100.0, 0.026), (120.0, 0.032), (200.0, 0.060)])
def test_loss_of_stiffness_of_hot_gears(temperature, loss):
    assert 1 - modulus_ratio(temperature, "li") == pytest.approx(loss, abs=7e-4)


def test_uncalibrated_heat_of_evaporation_is_far_too_weak():
    weak, steel = (1 - modulus_ratio(100.0, "li", 1.18e-5, calibration) for calibration in (1.0, 5.3))
    assert steel / weak == pytest.approx(3.5, abs=0.4)
