"""Hertz line contact, film thickness and viscosity."""

import numpy as np
import pytest
from scipy.integrate import quad

from gearwear.contact.film import film_thickness
from gearwear.contact.hertz import contact_modulus, hertz_half_width, hertz_peak_pressure
from gearwear.contact.oil import dynamic_viscosity

OIL = {"viscosity_law": "vogel", "dynamic_viscosity": 0.0094, "dynamic_viscosity_40": 0.0885}


def test_contact_modulus_of_equal_steels_is_the_plane_strain_modulus():
    steel = contact_modulus(np.array([206e9, 206e9]), np.array([0.3, 0.3]))
    assert steel == pytest.approx(206e9 / 0.91, rel=1e-14, abs=0)
    assert steel == pytest.approx(226.37e9, rel=1e-4, abs=0)


def test_contact_modulus_is_twice_the_modulus_of_hertz():
    softness = (1 - 0.28**2) / 206e9 + (1 - 0.34**2) / 110e9
    assert contact_modulus(np.array([206e9, 110e9]), np.array([0.28, 0.34])) == pytest.approx(
        2 / softness, rel=1e-14, abs=0
    )


def test_rigid_mate_doubles_the_contact_modulus():
    assert contact_modulus(np.array([206e9, 1e30]), np.array([0.3, 0.3])) == pytest.approx(
        2 * 206e9 / 0.91, rel=1e-12, abs=0
    )


def test_pressure_over_the_contact_carries_the_load():
    load, radius, modulus = 2.9e5, 7e-3, 2.26e11
    half_width, peak = (f(load, radius, modulus) for f in (hertz_half_width, hertz_peak_pressure))
    carried = quad(lambda y: peak * np.sqrt(1 - y * y), -1, 1)[0] * half_width
    assert carried == pytest.approx(load, rel=1e-9, abs=0)
    assert peak == pytest.approx(4 / np.pi * load / (2 * half_width), rel=1e-12, abs=0)


def test_half_width_and_peak_fit_the_curvature_of_the_cylinder():
    # Hertz: a = 4 p_max R / E' = 2 p_max R / E*
    load, radius, modulus = 2.9e5, 7e-3, 2.26e11
    peak = hertz_peak_pressure(load, radius, modulus)
    assert hertz_half_width(load, radius, modulus) == pytest.approx(4 * peak * radius / modulus, rel=1e-12, abs=0)


@pytest.mark.parametrize(
    ("argument", "power"),
    [(0, 0.68), (1, 1 - 0.68 + 0.073), (2, -0.073), (3, -0.68 + 0.49 + 0.073), (4, 0.68), (5, 0.49)],
)
def test_powers_of_the_film(argument, power):
    # rolling speed, radius, load, contact modulus, viscosity, pressure viscosity
    base = [5.0, 8e-3, 2e5, 2.26e11, 0.01, 2e-8]
    raised = [2 * value if i == argument else value for i, value in enumerate(base)]
    assert film_thickness(*raised) / film_thickness(*base) == pytest.approx(2**power, rel=1e-12, abs=0)


def test_film_without_load_is_finite_and_thicker():
    loaded, unloaded = film_thickness(5.0, 8e-3, np.array([2e5, 0.0]), 2.26e11, 0.01, 2e-8)
    assert np.isfinite(unloaded)
    assert unloaded > loaded > 0


@pytest.mark.parametrize("temperature", [20.0, 60.0, 100.0, 150.0])
def test_fixed_viscosity(temperature):
    assert dynamic_viscosity(temperature, OIL | {"viscosity_law": "fixed"}) == 0.0094


def test_vogel_goes_through_both_given_values():
    assert dynamic_viscosity(40.0, OIL) == pytest.approx(0.0885, rel=1e-12, abs=0)
    assert dynamic_viscosity(100.0, OIL) == pytest.approx(0.0094, rel=1e-12, abs=0)


def test_vogel_is_the_law_of_vogel():
    # ln eta is straight over 1/(T + 95)
    temperature = np.array([20.0, 55.0, 120.0])
    log = np.log([dynamic_viscosity(t, OIL) for t in temperature])
    slopes = np.diff(log) / np.diff(1 / (temperature + 95))
    assert slopes[0] == pytest.approx(slopes[1], rel=1e-12, abs=0)
    assert log[0] > log[1] > log[2]
