"""Film and wear coefficient against other published regressions and values.

Steel on steel, radii 8 and 24 mm, 200 N/mm, hot mineral oil. The numbers of this contact are in config/validation.yaml.
"""

import pytest

from gearwear.contact.film import film_thickness
from gearwear.validation.wear import STEEL as MODULUS
from gearwear.wear.archard import boundary_wear_coefficient

RADIUS, LOAD, VISCOSITY, PRESSURE_VISCOSITY = 6e-3, 2.0e5, 0.0094, 2.0e-8


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
