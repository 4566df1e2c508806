"""Flash temperature against the moving band source that Blok solved."""

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import minimize_scalar

from gearwear.contact.flash import contact_heat, flash_temperature

FLUX = {
    "uniform": lambda x: 1 / 2,
    "semi-ellipse": lambda x: 2 / np.pi * np.sqrt(max(1 - x * x, 0.0)),
    "parabola": lambda x: 3 / 4 * (1 - x * x),
}
EFFUSIVITY = np.sqrt(46.0 * 7850.0 * 470.0)
LUBRICANT = {"pressure_viscosity": 2.5e-8, "composite_roughness": 0.5e-6}
FRICTION = {"law": "load_sharing", "dry": 0.2, "boundary": 0.1}


def band_source(shape: str) -> float:
    """Return the peak of the surface temperature of a fast moving band source of unit half width.

    Linear conduction into a half space: T(x) = int q(y) / sqrt(pi (x - y)) dy, for unit total flux, effusivity and
    speed. With y = x - t^2 the integrand is regular.
    """

    def surface(x):
        kinks = [np.sqrt(x - 1)] if x > 1 else None
        low = kinks[0] if kinks else 0.0
        return 2 / np.sqrt(np.pi) * quad(lambda t: FLUX[shape](x - t * t), low, np.sqrt(x + 1), epsabs=1e-11)[0]

    peak = minimize_scalar(lambda x: -surface(x), bounds=(-0.5, 1.0), method="bounded", options={"xatol": 1e-9})
    return -peak.fun


def steel_contact(speed, load=2.0e5, radius=6.0e-3, factor=1.0, coefficient=0.83, friction=FRICTION):
    speed = np.asarray(speed, dtype=float).reshape(2, -1)
    return contact_heat(
        np.full(speed.shape[1], load),
        speed,
        np.full(speed.shape[1], radius),
        np.array([206e9, 206e9]),
        np.array([0.3, 0.3]),
        np.array([EFFUSIVITY, EFFUSIVITY]),
        0.0094,
        LUBRICANT,
        friction,
        coefficient,
        factor,
    )


@pytest.mark.parametrize(("shape", "constant"), [("uniform", 0.798), ("semi-ellipse", 0.786), ("parabola", 0.829)])
def test_constants_of_the_band_source_belong_to_the_half_width(shape, constant):
    assert band_source(shape) == pytest.approx(constant, abs=6e-4)


def test_uniform_constant_in_closed_form():
    assert band_source("uniform") == pytest.approx(np.sqrt(2 / np.pi), rel=1e-7, abs=0)


def test_constant_of_the_full_width_is_that_of_the_semi_ellipse():
    assert band_source("semi-ellipse") * np.sqrt(2) == pytest.approx(1.11, abs=2e-3)


def test_one_conducting_body_is_heated_like_a_half_space_under_the_band():
    # the gear insulates, so the pinion takes all the heat: an absolute number in kelvin
    heat = 0.05 * 2.0e5 * 3.0  # W/m
    scale = heat / (EFFUSIVITY * np.sqrt(8.0 * 1.2e-4))
    flash = flash_temperature(
        0.83, 0.05, 2.0e5, np.array([[8.0], [5.0]]), np.array([1.2e-4]), np.array([EFFUSIVITY, 0.0])
    )
    assert flash[0] == pytest.approx(band_source("parabola") * scale, rel=2e-3, abs=0)


def test_heat_parts_so_that_both_bodies_are_equally_hot():
    speed, effusivity, half_width = np.array([[8.0], [2.0]]), np.array([13e3, 9e3]), np.array([1e-4])
    alone = []
    for i in range(2):
        only = effusivity * (np.arange(2) == i)
        alone.append(flash_temperature(0.83, 0.05, 2e5, speed, half_width, only)[0])
    both = flash_temperature(0.83, 0.05, 2e5, speed, half_width, effusivity)[0]
    assert 1 / both == pytest.approx(1 / alone[0] + 1 / alone[1], rel=1e-12, abs=0)


def test_contact_heat_uses_the_half_width():
    contact = steel_contact([8.0, 5.0])
    half_width = np.sqrt(4 * 2.0e5 * 6.0e-3 * 2 * (1 - 0.09) / (np.pi * 206e9))
    assert contact.hertz_half_width[0] == pytest.approx(half_width, rel=1e-12, abs=0)
    released = contact.friction_coefficient[0] * 2.0e5 * 3.0
    carried_off = EFFUSIVITY * (np.sqrt(8.0) + np.sqrt(5.0))
    expected = band_source("parabola") * released / (carried_off * np.sqrt(half_width))
    assert contact.flash_temperature[0] == pytest.approx(expected, rel=2e-3, abs=0)
    full_width = expected / np.sqrt(2)
    assert contact.flash_temperature[0] > 1.4 * full_width  # 29 % too low would go unseen otherwise


def test_equal_steels_follow_the_difference_of_root_speeds():
    speed = np.array([[9.0, 4.0], [4.0, 9.0]])
    flash = flash_temperature(0.83, 0.04, 3e5, speed, np.full(2, 2e-4), np.array([13e3, 13e3]))
    expected = 0.83 * 0.04 * 3e5 * (3.0 - 2.0) / (13e3 * np.sqrt(2e-4))
    assert flash == pytest.approx([expected, expected], rel=1e-12, abs=0)


def test_rolling_without_sliding_stays_cold():
    assert steel_contact([7.0, 7.0]).flash_temperature[0] == 0.0
    slow, slower = (steel_contact([7.0 + slip, 7.0]).flash_temperature[0] for slip in (1e-5, 1e-6))
    assert 0 < slower < slow < 1e-3


def test_surfaces_at_rest_and_contacts_without_load_stay_cold_and_finite():
    effusivity = np.array([13e3, 13e3])
    assert flash_temperature(0.83, 0.1, 1e5, np.zeros((2, 1)), np.array([1e-4]), effusivity)[0] == 0.0
    unloaded = steel_contact([8.0, 5.0], load=0.0)
    assert unloaded.flash_temperature[0] == 0.0
    assert all(np.isfinite(value).all() for value in unloaded)


@pytest.mark.parametrize(
    ("change", "power"),
    [
        ({"coefficient": 2.0}, 1.0),
        ({"friction": 2.0}, 1.0),
        ({"load": 2.0}, 1.0),
        ({"speed": 2.0}, 0.5),
        ({"half_width": 2.0}, -0.5),
        ({"effusivity": 2.0}, -1.0),
    ],
)
def test_powers_of_the_formula(change, power):
    base = {"coefficient": 0.83, "friction": 0.05, "load": 2e5, "speed": 1.0, "half_width": 1.0, "effusivity": 1.0}

    def flash(coefficient, friction, load, speed, half_width, effusivity):
        speeds, widths = speed * np.array([[8.0], [5.0]]), half_width * np.array([1e-4])
        return flash_temperature(coefficient, friction, load, speeds, widths, effusivity * np.array([13e3, 12e3]))[0]

    raised = {name: value * change.get(name, 1.0) for name, value in base.items()}
    assert flash(**raised) / flash(**base) == pytest.approx(2.0**power, rel=1e-12, abs=0)


def test_friction_factor_raises_friction_and_flash_in_proportion():
    base, raised = steel_contact([8.0, 5.0]), steel_contact([8.0, 5.0], factor=1.1)
    assert raised.friction_coefficient[0] == pytest.approx(1.1 * base.friction_coefficient[0], rel=1e-12, abs=0)
    assert raised.flash_temperature[0] == pytest.approx(1.1 * base.flash_temperature[0], rel=1e-12, abs=0)


@pytest.mark.parametrize("sliding", [0.3, 0.6, 1.0, 1.6])
@pytest.mark.parametrize("rolling", [2.0, 5.0, 10.0, 20.0])
def test_more_load_heats_more(rolling, sliding):
    speed = rolling * np.array([1 + sliding / 2, 1 - sliding / 2])
    assert steel_contact(speed, load=2.2e5).flash_temperature[0] > steel_contact(speed).flash_temperature[0]


@pytest.mark.parametrize("sliding", [0.3, 0.6, 1.0, 1.6])
def test_more_speed_heats_more_but_less_than_its_root_as_the_film_thickens(sliding):
    speed = 5.0 * np.array([1 + sliding / 2, 1 - sliding / 2])
    base, faster = steel_contact(speed), steel_contact(1.1 * speed)
    assert faster.film_ratio[0] > base.film_ratio[0]
    assert faster.friction_coefficient[0] < base.friction_coefficient[0]
    assert 1 < faster.flash_temperature[0] / base.flash_temperature[0] < np.sqrt(1.1)


def test_zero_coefficient_switches_the_flash_off_but_not_the_friction():
    contact = steel_contact([8.0, 5.0], coefficient=0.0)
    assert contact.flash_temperature[0] == 0.0
    assert contact.friction_coefficient[0] > 0


def test_film_ratio_is_film_over_composite_roughness():
    modulus = 206e9 / (1 - 0.09)
    rolling, radius, load = 6.5, 6.0e-3, 2.0e5
    film = (
        3.63
        * radius
        * (0.0094 * rolling / (modulus * radius)) ** 0.68
        * (2.5e-8 * modulus) ** 0.49
        * (load / (modulus * radius)) ** -0.073
    )
    assert steel_contact([8.0, 5.0]).film_ratio[0] == pytest.approx(film / 0.5e-6, rel=1e-12, abs=0)
