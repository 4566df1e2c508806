"""Elastic modulus against tabulated steel."""

import numpy as np
import pytest

from gearwear.heat.modulus import modulus_ratio

# Carbon steel, carbon up to 0.3 % (ASME B31.3, table C-6): degC, GPa
TABLE = {21: 203.4, 93: 198.6, 149: 195.1, 204: 191.0, 260: 188.2}


@pytest.mark.parametrize("law", ["li", "linear", "table"])
def test_carbon_steel_at_93_and_204_degrees(law):
    cold = modulus_ratio(21.0, law)
    assert modulus_ratio(93.0, law) / cold == pytest.approx(0.976, abs=3e-3)
    assert modulus_ratio(204.0, law) / cold == pytest.approx(0.939, abs=4e-3)


@pytest.mark.parametrize(
    ("law", "warmest", "limit"),
    [("table", 260, 1e-12), ("linear", 204, 2e-3), ("linear", 260, 3e-3), ("li", 204, 2e-3)],
)
def test_entries_of_the_table(law, warmest, limit):
    # the calibration of law li was made for 20 to 200 degC
    for temperature in (entry for entry in TABLE if entry <= warmest):
        computed = modulus_ratio(temperature, law) / modulus_ratio(21.0, law)
        assert computed == pytest.approx(TABLE[temperature] / TABLE[21], abs=limit)


@pytest.mark.parametrize(
    ("law", "calibration", "expected"),
    [
        ("li", 5.3, [0.987, 0.981, 0.974, 0.968, 0.958, 0.9405]),
        ("li", 1.0, [0.997, 0.995, 0.993, 0.991, 0.988, 0.983]),
        ("table", 5.3, [0.987, 0.980, 0.974, 0.968, 0.9585, 0.940]),
    ],
)
def test_worked_values(law, calibration, expected):
    # independent evaluation at l = 1.18e-5 1/K for 60, 80, 100, 120, 150, 200 degC, three digits
    computed = modulus_ratio(np.array([60.0, 80.0, 100.0, 120.0, 150.0, 200.0]), law, 1.18e-5, calibration)
    assert computed == pytest.approx(expected, abs=1e-3)


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
