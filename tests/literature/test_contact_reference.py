"""Numbers of one steel contact, evaluated by hand from the published formulas in double precision.

Steel on steel, radii 8 and 24 mm, 200 N/mm, 3000 rpm at a ratio of 25/40, hot mineral oil, 0.5 um.
"""

import numpy as np
import pytest

from gearwear.wear.archard import boundary_wear_coefficient, film_factor, wear_per_revolution
from gearwear.wear.film import contact_modulus, film_thickness, hertz_half_width, hertz_peak_pressure

MODULUS = contact_modulus(np.array([206e9, 206e9]), np.array([0.3, 0.3]))
RADII = np.array([8e-3, 24e-3])
RADIUS = RADII.prod() / RADII.sum()
SPEED = 2 * np.pi * 3000 / 60 * np.array([1, 25 / 40]) * RADII
LOAD, VISCOSITY, PRESSURE_VISCOSITY, ROUGHNESS = 2.0e5, 0.0094, 2.0e-8, 0.5e-6
DIGITS = 6e-10


def reference(value):
    return pytest.approx(value, rel=DIGITS, abs=0)


def test_contact_modulus_and_radius():
    assert reference(2.263736264e11) == MODULUS
    assert reference(6.0e-3) == RADIUS


def test_hertz_contact():
    half_width = hertz_half_width(LOAD, RADIUS, MODULUS)
    assert half_width == reference(1.161843857e-4)
    assert hertz_peak_pressure(LOAD, RADIUS, MODULUS) == reference(1.095878363e9)
    assert LOAD / (2 * half_width) == reference(8.607008540e8)


def test_speeds_and_sliding_distance():
    assert pytest.approx([2.513274123, 4.712388980], rel=DIGITS, abs=0) == SPEED
    assert SPEED.mean() == reference(3.612831552)
    band = 2 * hertz_half_width(LOAD, RADIUS, MODULUS)
    assert band * abs(1 - SPEED[::-1] / SPEED) == pytest.approx([2.033226750e-4, 1.084387600e-4], rel=DIGITS, abs=0)


def test_dimensionless_groups():
    assert VISCOSITY * SPEED.mean() / (MODULUS * RADIUS) == reference(2.500336658e-11)
    assert reference(4527.472527) == PRESSURE_VISCOSITY * MODULUS
    assert reference(1.472491909e-4) == LOAD / (MODULUS * RADIUS)
    assert reference(8.333333333e-5) == ROUGHNESS / RADIUS


def test_film_of_hamrock_and_dowson():
    film = film_thickness(SPEED.mean(), RADIUS, LOAD, MODULUS, VISCOSITY, PRESSURE_VISCOSITY)
    assert film == reference(1.584157428e-7)
    assert film / ROUGHNESS == reference(0.3168314856)
    assert film_factor(film / ROUGHNESS) == 1.0


def test_boundary_wear_coefficient():
    coefficient = boundary_wear_coefficient(LOAD, RADIUS, MODULUS, PRESSURE_VISCOSITY, ROUGHNESS)
    assert coefficient == reference(1.327258282e-20)


def test_wear_of_one_passage():
    depth = wear_per_revolution(
        np.array([LOAD * 16e-3]),
        SPEED[:, None],
        np.array([RADIUS]),
        16e-3,
        MODULUS,
        VISCOSITY,
        {"pressure_viscosity": PRESSURE_VISCOSITY, "composite_roughness": ROUGHNESS},
        "janakiraman",
        0.0,
        "mean",
    )
    assert depth[:, 0] == pytest.approx([2.322701994e-15, 1.238774397e-15], rel=DIGITS, abs=0)


@pytest.mark.parametrize(("film_ratio", "factor"), [(0, 1), (0.5, 1), (1, 6 / 7), (2, 4 / 7), (4, 0)])
def test_film_factor_of_ding_and_kahraman(film_ratio, factor):
    assert film_factor(film_ratio) == pytest.approx(factor, abs=1e-15)


# 1e-21 m2/N; rows pressure-viscosity 1e-8/Pa, columns roughness 0.3, 0.5, 1.0 um with 100, 200, 400 N/mm each
MAGNITUDES = {
    1.0: [100, 230, 540, 230, 530, 1200, 680, 1600, 3700],
    1.3: [15, 34, 78, 33, 76, 180, 98, 230, 530],
    1.5: [5.0, 12, 27, 11, 26, 61, 34, 79, 190],
    2.0: [0.60, 1.4, 3.3, 1.4, 3.2, 7.4, 4.1, 9.5, 22],
    2.2: [0.30, 0.69, 1.6, 0.67, 1.6, 3.6, 2.0, 4.7, 11],
}


@pytest.mark.parametrize("pressure_viscosity", MAGNITUDES)
def test_size_of_the_wear_coefficient_of_steel_gears(pressure_viscosity):
    # 10 mm effective radius; the values have two digits, a rounding of up to 5 %
    computed = [
        boundary_wear_coefficient(load, 10e-3, MODULUS, 1e-8 * pressure_viscosity, roughness) / 1e-21
        for roughness in (0.3e-6, 0.5e-6, 1.0e-6)
        for load in (1e5, 2e5, 4e5)
    ]
    assert computed == pytest.approx(MAGNITUDES[pressure_viscosity], rel=0.05, abs=0)


@pytest.mark.parametrize(("relative_roughness", "group"), [(5e-5, 2200), (1e-4, 2600)])
def test_known_constant_coefficient_is_that_of_hot_thin_oil(relative_roughness, group):
    # 9.65e-19 m2/N: Bajpai, Kahraman and Anderson, J. Tribol. 126 (2004); group = alpha E' that gives it
    radius, load = 10e-3, 1.3e-4 * MODULUS * 10e-3
    at_2400 = boundary_wear_coefficient(load, radius, MODULUS, 2400 / MODULUS, relative_roughness * radius)
    assert 2400 * (at_2400 / 9.65e-19) ** (1 / 7.377) == pytest.approx(group, rel=0.03, abs=0)


@pytest.mark.parametrize("viscosity", [6.5e-3, 16e-3, 40e-3])
@pytest.mark.parametrize("speed", [1.0, 5.0, 20.0])
def test_line_contact_film_of_dowson_and_higginson_is_near(viscosity, speed):
    # another regression, for line contacts: 2.65 R U^0.7 G^0.54 L^-0.13; some 7 to 20 % thicker in this contact
    line = (
        2.65
        * RADIUS
        * (viscosity * speed / (MODULUS * RADIUS)) ** 0.7
        * (PRESSURE_VISCOSITY * MODULUS) ** 0.54
        * (LOAD / (MODULUS * RADIUS)) ** -0.13
    )
    film = film_thickness(speed, RADIUS, LOAD, MODULUS, viscosity, PRESSURE_VISCOSITY)
    assert 1.07 < line / film < 1.21


def test_point_load_group_would_change_the_film_by_five_per_cent():
    film = film_thickness(5.0, 10e-3, LOAD, MODULUS, VISCOSITY, PRESSURE_VISCOSITY)
    width = 20e-3
    group = LOAD * width / (MODULUS * 10e-3**2)
    point = (
        3.63
        * 10e-3
        * (VISCOSITY * 5.0 / (MODULUS * 10e-3)) ** 0.68
        * (PRESSURE_VISCOSITY * MODULUS) ** 0.49
        * group**-0.073
    )
    assert film / point == pytest.approx(1.05, abs=0.005)
