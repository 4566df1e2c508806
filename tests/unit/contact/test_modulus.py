"""Elastic modulus of hot steel."""

import numpy as np
import pytest
from scipy.integrate import quad

from gearwear.contact.modulus import hot_modulus, modulus_ratio

LAWS = ("li", "linear", "table", "constant")


@pytest.mark.parametrize("law", LAWS)
def test_modulus_of_the_configuration_holds_at_20_degrees(law):
    assert modulus_ratio(20.0, law) == pytest.approx(1.0, rel=1e-14, abs=0)


@pytest.mark.parametrize("law", ["li", "linear", "table"])
def test_hotter_steel_is_softer(law):
    ratio = modulus_ratio(np.linspace(21.0, 260.0, 100), law)
    assert (np.diff(ratio) < 0).all()


def test_constant_law_ignores_the_temperature():
    assert np.array_equal(modulus_ratio(np.array([-40.0, 20.0, 300.0]), "constant"), np.ones(3))


def test_li_form_from_heat_and_expansion():
    # E/E20 = (1 + l dT)^-3 (1 - K int C dT / H*), heat capacity of iron integrated by quadrature
    def heat_capacity(kelvin):
        t = kelvin / 1000
        return 18.42868 + 24.64301 * t - 8.913720 * t**2 + 9.664706 * t**3 - 0.012643 / t**2

    assert heat_capacity(300.0) == pytest.approx(25.14, abs=0.05)
    latent = 473.4e3
    for temperature in (60.0, 100.0, 200.0):
        content = quad(heat_capacity, 293.15, temperature + 273.15)[0]
        expected = (1 + 1.2e-5 * (temperature - 20)) ** -3 * (1 - 5.3 * content / latent)
        assert modulus_ratio(temperature, "li", 1.2e-5, 5.3) == pytest.approx(expected, rel=2e-5, abs=0)


def test_calibration_zero_leaves_the_expansion_alone():
    assert modulus_ratio(120.0, "li", 1e-5, 0.0) == pytest.approx(1.001**-3, rel=1e-12, abs=0)


def test_calibration_scales_the_heat_term():
    losses = [1 - modulus_ratio(100.0, "li", 0.0, calibration) for calibration in (1.0, 2.0, 5.3)]
    assert losses == pytest.approx([losses[0], 2 * losses[0], 5.3 * losses[0]], rel=1e-10, abs=0)


def test_linear_law():
    assert modulus_ratio(120.0, "linear") == pytest.approx(1 - 0.0325, rel=1e-14, abs=0)


def test_table_meets_its_entries_and_is_straight_between():
    entries = modulus_ratio(np.array([93.0, 121.0, 149.0]), "table")
    assert entries[[0, 2]] == pytest.approx([198.6 / 203.4, 195.1 / 203.4], rel=1e-14, abs=0)
    assert entries[1] == pytest.approx((entries[0] + entries[2]) / 2, rel=1e-14, abs=0)


@pytest.mark.parametrize("temperature", [19.9, 260.1])
def test_table_refuses_what_it_does_not_hold(temperature):
    with pytest.raises(ValueError, match="20 to 260 degC") as refused:
        modulus_ratio(np.array([100.0, temperature]), "table")
    assert str(temperature) in str(refused.value)
    assert "linear" in str(refused.value)


def test_unknown_law_is_refused_by_name():
    with pytest.raises(ValueError, match="'quadratic' is unknown; use li, linear, table or constant"):
        modulus_ratio(100.0, "quadratic")


def test_hot_modulus_of_unlike_gears():
    material = {
        "pinion": {"youngs_modulus": 206e9, "thermal_expansion": 1.0e-5},
        "gear": {"youngs_modulus": 110e9, "thermal_expansion": 2.0e-5},
    }
    hot = hot_modulus(material, {"law": "li", "calibration": 5.3}, 100.0)
    expected = [206e9 * modulus_ratio(100.0, "li", 1.0e-5), 110e9 * modulus_ratio(100.0, "li", 2.0e-5)]
    assert hot == pytest.approx(expected, rel=1e-14, abs=0)
    assert hot[1] / 110e9 < hot[0] / 206e9 < 1
    cold = hot_modulus(material, {"law": "li", "calibration": 5.3}, 20.0)
    assert cold == pytest.approx([206e9, 110e9], rel=1e-14, abs=0)
