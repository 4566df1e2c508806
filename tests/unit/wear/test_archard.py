"""Archard wear of one passage of the contact."""

import numpy as np
import pytest

from gearwear.contact.hertz import hertz_half_width, hertz_peak_pressure
from gearwear.wear.archard import boundary_wear_coefficient, film_factor, wear_per_revolution

MODULUS, WIDTH, VISCOSITY = 2.2637e11, 16e-3, 0.0094
LUBRICANT = {"pressure_viscosity": 2.0e-8, "composite_roughness": 0.5e-6}
LENGTH = 33.346964e-3
PATH = np.array([5.3e-3, 9e-3, 12.825756e-3, 16e-3, 19.9e-3])
RADIUS = PATH * (LENGTH - PATH) / LENGTH
SPEED = np.stack([314.159 * PATH, 314.159 * 25 / 40 * (LENGTH - PATH)])


def wear(load=3000.0, law="janakiraman", pressure="mean", coefficient=1e-20, **changed):
    values = {"surface_speed": SPEED, "radius": RADIUS, "contact_modulus": MODULUS, "viscosity": VISCOSITY} | changed
    return wear_per_revolution(
        load=np.broadcast_to(load, np.broadcast_shapes(np.shape(load), PATH.shape)),
        face_width=WIDTH,
        lubricant=changed.pop("lubricant", LUBRICANT),
        law=law,
        coefficient=coefficient,
        pressure=pressure,
        **{name: value for name, value in values.items() if name != "lubricant"},
    )


@pytest.mark.parametrize(
    ("film_ratio", "expected"),
    [(0.0, 1.0), (0.499, 1.0), (0.5, 1.0), (1.0, 6 / 7), (2.0, 4 / 7), (3.0, 2 / 7), (4.0, 0.0), (9.0, 0.0)],
)
def test_film_factor(film_ratio, expected):
    assert film_factor(film_ratio) == pytest.approx(expected, abs=1e-15)


def test_film_factor_has_no_jump_and_never_rises():
    factor = film_factor(np.linspace(0, 5, 50001))
    assert np.diff(factor).max() <= 0
    assert -np.diff(factor).min() < 1.01 * 2 / 7 * 1e-4


@pytest.mark.parametrize(
    ("argument", "power"),
    [
        ("load_per_width", 1.219),
        ("radius", -2.808),
        ("contact_modulus", -9.596),
        ("pressure_viscosity", -7.377),
        ("roughness", 1.589),
    ],
)
def test_powers_of_the_boundary_coefficient(argument, power):
    base = {
        "load_per_width": 2e5,
        "radius": 6e-3,
        "contact_modulus": MODULUS,
        "pressure_viscosity": 2e-8,
        "roughness": 0.5e-6,
    }
    ratio = boundary_wear_coefficient(**base | {argument: 2 * base[argument]}) / boundary_wear_coefficient(**base)
    assert ratio == pytest.approx(2**power, rel=1e-12, abs=0)


def test_half_the_contact_modulus_by_mistake_is_a_factor_of_774():
    args = (2e5, 6e-3), (2e-8, 0.5e-6)
    mistaken = boundary_wear_coefficient(*args[0], MODULUS / 2, *args[1])
    assert mistaken / boundary_wear_coefficient(*args[0], MODULUS, *args[1]) == pytest.approx(774, abs=1)


def test_nothing_wears_at_the_pitch_point():
    speed = np.array([[4.0], [4.0]])
    assert wear(surface_speed=speed, radius=np.array([6e-3]), load=np.array([3000.0]))[:, 0].tolist() == [0.0, 0.0]


def test_both_flanks_wear_on_both_sides_of_the_pitch_point():
    depth = wear()
    assert (depth[:, [0, 1, 3, 4]] > 0).all()
    assert depth[:, 2] == pytest.approx([0, 0], abs=1e-5 * depth.max())


def test_slower_flank_wears_in_the_ratio_of_the_speeds():
    # the same sliding distance per time acts longer on the flank that moves slower through the contact
    depth = wear()
    assert depth[0] / depth[1] == pytest.approx(SPEED[1] / SPEED[0], rel=1e-6, abs=0)


def test_constant_coefficient_gives_archard_without_hertz():
    depth = wear(law="constant")
    per_width = 3000.0 / WIDTH
    assert depth[0] == pytest.approx(1e-20 * per_width * np.abs(1 - SPEED[1] / SPEED[0]), rel=1e-12, abs=0)
    assert depth[1] == pytest.approx(1e-20 * per_width * np.abs(1 - SPEED[0] / SPEED[1]), rel=1e-12, abs=0)


@pytest.mark.parametrize("changed", [{"contact_modulus": 3 * MODULUS}, {"radius": 2 * RADIUS}, {"viscosity": 0.1}])
def test_constant_coefficient_forgets_the_contact(changed):
    assert wear(law="constant", **changed) == pytest.approx(wear(law="constant"), rel=1e-12, abs=0)


def test_one_passage_is_the_integral_of_the_pressure_over_sliding():
    # follow a point of the pinion flank through the band: dh = k p |sliding velocity| dt, in small steps of time
    load, i = 3000.0 / WIDTH, 0
    half_width = hertz_half_width(load, RADIUS[i], MODULUS)
    peak = hertz_peak_pressure(load, RADIUS[i], MODULUS)
    steps = 200000
    for gear in range(2):
        own, mate = SPEED[gear, i], SPEED[1 - gear, i]
        stay = 2 * half_width / own
        place = half_width * (2 * (np.arange(steps) + 0.5) / steps - 1)
        pressure = peak * np.sqrt(1 - (place / half_width) ** 2)
        passage = (1e-20 * pressure * abs(mate - own) * stay / steps).sum()
        assert wear(law="constant")[gear, i] == pytest.approx(passage, rel=1e-7, abs=0)


@pytest.mark.parametrize("law", ["janakiraman", "constant"])
def test_peak_pressure_overstates_by_four_over_pi(law):
    assert wear(law=law, pressure="peak") == pytest.approx(4 / np.pi * wear(law=law), rel=1e-12, abs=0)


def test_coefficient_acts_in_proportion_and_under_its_law_only():
    assert wear(law="constant", coefficient=3e-20) == pytest.approx(3 * wear(law="constant"), rel=1e-12, abs=0)
    assert np.array_equal(wear(coefficient=3e-20), wear())


def test_wear_grows_with_the_power_of_load_in_thin_films():
    # film ratio far below 1/2: dh ~ F^(1 + 1.219)
    thin = {"viscosity": 1e-4}
    assert wear(6000.0, **thin) / np.where(wear(3000.0, **thin) > 0, wear(3000.0, **thin), 1) == pytest.approx(
        np.full((2, 5), 2**2.219), rel=1e-9, abs=0
    )


def test_thick_film_stops_the_wear():
    assert not wear(viscosity=1.0).any()


def test_thicker_film_wears_less():
    thin, thick = wear(viscosity=0.0094), wear(viscosity=0.05)
    assert (thick[:, [0, 1, 3, 4]] < thin[:, [0, 1, 3, 4]]).all()


def test_no_load_no_wear():
    for law in ("janakiraman", "constant"):
        depth = wear(np.array([0.0, 3000.0, 3000.0, 3000.0, 0.0]), law=law)
        assert np.isfinite(depth).all()
        assert not depth[:, [0, 4]].any()
        assert (depth[:, [1, 3]] > 0).all()


def test_many_periods_are_worn_one_by_one():
    loads = np.array([[1000.0] * 5, [3000.0] * 5, [5000.0] * 5])
    together = wear(loads)
    assert together.shape == (2, 3, 5)
    for j, load in enumerate(loads):
        assert together[:, j] == pytest.approx(wear(load), rel=1e-13, abs=0)
    # the mean of the wear exceeds the wear of the mean: wear is convex in the load
    assert (together.mean(axis=1) > wear(3000.0))[:, [0, 1, 3, 4]].all()
