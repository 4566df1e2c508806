"""Thermal growth of base circle and flank."""

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from gearwear.geometry.contact_path import contact_path
from gearwear.geometry.involute import gear_pair, involute
from gearwear.heat.growth import base_circle_growth, flank_growth

EXPANSION = 1.1e-5
HUBS = ("free_bore", "solid_shaft")
MODES = ("paper", "consistent", "eulerian")
PAIRS = [(25, 50, 3e-3), (25, 37, 4e-3), (20, 40, 6e-3), (19, 48, 3.175e-3)]


def two(pinion, gear=None):
    return {"pinion": pinion, "gear": pinion if gear is None else gear}


def spur_pair(pinion, gear, module, shift=0.0):
    bores = two(0.175 * pinion * module, 0.175 * gear * module)  # 0.35 of the reference radius
    return gear_pair(two(pinion, gear), module, 20e-3, 20.0, two(1.0), 0.25, two(shift, -shift), None, bores)


def along_path(pair, points=41):
    """Return the radii of curvature of both flanks from the start to the end of contact, (2, points)."""
    mesh = contact_path(pair, 16)
    path = np.linspace(mesh.start_of_contact, mesh.end_of_contact, points)
    return np.stack([path, mesh.line_of_action - path])


def grown(pair, i, curvature, mode, rise=80.0, shaft=None, hub="free_bore"):
    shaft = rise if shaft is None else shaft
    rim = base_circle_growth(shaft, rise, pair.bore_radius[i], pair.base_radius[i], EXPANSION, hub)
    return flank_growth(curvature, pair.base_radius[i], pair.base_half_angle[i], rise, rim, EXPANSION, mode)


@pytest.mark.parametrize(("shaft", "rim"), [(40.0, 80.0), (80.0, 40.0), (0.0, 80.0), (-10.0, 5.0)])
def test_base_circle_grows_by_the_area_mean_of_the_temperature(shaft, rim):
    inner, outer = 15e-3, 35.24e-3

    def rise(r):
        return shaft + (rim - shaft) * np.log(r / inner) / np.log(outer / inner)

    moment = quad(lambda r: rise(r) * r, inner, outer, epsabs=1e-16)[0]
    free = base_circle_growth(shaft, rim, inner, outer, EXPANSION, "free_bore")
    assert free == pytest.approx(2 * EXPANSION * outer * moment / (outer**2 - inner**2), rel=1e-10, abs=0)
    filled = base_circle_growth(shaft, rim, inner, outer, EXPANSION, "solid_shaft")
    assert filled == pytest.approx(2 * EXPANSION / outer * (shaft * inner**2 / 2 + moment), rel=1e-10, abs=0)


@pytest.mark.parametrize("hub", HUBS)
def test_uniform_heating_expands_the_base_circle_freely(hub):
    assert base_circle_growth(80.0, 80.0, 15e-3, 35e-3, EXPANSION, hub) == pytest.approx(
        EXPANSION * 35e-3 * 80.0, rel=1e-13, abs=0
    )


@pytest.mark.parametrize("hub", HUBS)
def test_no_heating_no_growth(hub):
    assert base_circle_growth(0.0, 0.0, 15e-3, 35e-3, EXPANSION, hub) == 0.0


@pytest.mark.parametrize("hub", HUBS)
def test_vanishing_bore_leaves_the_rim_temperature(hub):
    # the cool core shrinks to nothing, but only as 1/ln(r_b/r_s)
    free = EXPANSION * 35e-3 * 80.0
    lacking = []
    for ratio in (1e3, 1e12, 1e60, 1e300):
        growth = base_circle_growth(40.0, 80.0, 35e-3 / ratio, 35e-3, EXPANSION, hub)
        lacking.append(1 - growth / free)
        assert lacking[-1] == pytest.approx(0.5 / (2 * np.log(ratio)), rel=1e-4, abs=0)
    assert lacking == sorted(lacking, reverse=True)
    assert lacking[-1] < 4e-4


def test_thin_ring_has_the_mean_of_both_temperatures():
    growth = base_circle_growth(40.0, 80.0, 34.99e-3, 35e-3, EXPANSION, "free_bore")
    assert growth == pytest.approx(EXPANSION * 35e-3 * 60.0, rel=1e-4, abs=0)


@pytest.mark.parametrize(("shaft", "stiffer"), [(40.0, -1), (100.0, 1)])
def test_shaft_in_the_bore_pulls_the_rim_to_its_own_temperature(shaft, stiffer):
    free, filled = (base_circle_growth(shaft, 80.0, 15e-3, 35e-3, EXPANSION, hub) for hub in HUBS)
    assert np.sign(filled - free) == stiffer


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("teeth", PAIRS)
def test_no_heating_leaves_the_flank(teeth, mode):
    pair = spur_pair(*teeth)
    for i, curvature in enumerate(along_path(pair)):
        result = grown(pair, i, curvature, mode, rise=0.0)
        assert np.abs(result.growth).max() < 1e-16
        assert np.abs(result.involute_error).max() < 1e-16


@pytest.mark.parametrize("teeth", PAIRS)
def test_uniform_heating_keeps_an_involute(teeth):
    pair = spur_pair(*teeth)
    for i, curvature in enumerate(along_path(pair)):
        result = grown(pair, i, curvature, "consistent")
        assert np.abs(result.involute_error).max() < 1e-15
        pressure = np.arctan(curvature / pair.base_radius[i])
        radius = pair.base_radius[i] / np.cos(pressure)
        reference = pair.reference_radius[i]
        thickness = pair.tooth_thickness[i] * radius / reference - 2 * radius * (
            involute(pressure) - involute(np.radians(20.0))
        )
        expected = EXPANSION * 80.0 * thickness * np.cos(pressure) / 2
        assert result.growth == pytest.approx(expected, rel=1e-9, abs=0)


def test_uniform_heating_in_the_way_of_the_paper_counts_the_radius_twice():
    pair = spur_pair(25, 50, 3e-3)
    curvature = along_path(pair)[0]
    paper, consistent = (grown(pair, 0, curvature, mode) for mode in ("paper", "consistent"))
    assert paper.growth == pytest.approx(2 * consistent.growth, rel=2e-3, abs=0)
    assert paper.involute_error.min() < -2.3e-6


@pytest.mark.parametrize("mode", ["paper", "consistent"])
@pytest.mark.parametrize("teeth", PAIRS)
@pytest.mark.parametrize("hub", HUBS)
def test_growth_falls_from_dedendum_to_addendum_on_both_gears(teeth, mode, hub):
    pair = spur_pair(*teeth)
    for i, curvature in enumerate(along_path(pair)):
        growth = grown(pair, i, np.sort(curvature), mode, shaft=60.0, hub=hub).growth
        assert (np.diff(growth) < 0).all()
        assert growth.min() > 0


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("teeth", PAIRS)
def test_cooler_shaft_leaves_the_flank_outside_the_hot_involute(teeth, mode):
    pair = spur_pair(*teeth)
    for i, curvature in enumerate(along_path(pair)):
        assert grown(pair, i, curvature, mode, shaft=60.0).involute_error.max() < 0


@pytest.mark.parametrize("mode", MODES)
def test_hotter_teeth_grow_more_everywhere(mode):
    pair = spur_pair(19, 48, 3.175e-3)
    for i, curvature in enumerate(along_path(pair)):
        growths = [grown(pair, i, curvature, mode, rise=rise, shaft=rise - 20).growth for rise in (20, 40, 60, 80)]
        assert (np.diff(growths, axis=0) > 0).all()


@pytest.mark.parametrize("teeth", PAIRS)
def test_first_order_forms(teeth):
    pair = spur_pair(*teeth)
    for i, curvature in enumerate(along_path(pair)):
        base = pair.base_radius[i]
        pressure = np.arctan(curvature / base)
        half = pair.base_half_angle[i] - involute(pressure)
        for mode in MODES:
            result = grown(pair, i, curvature, mode, shaft=60.0)
            strain, rim = EXPANSION * 80.0, result.base_circle_growth
            mismatch = strain - rim / base
            lift = np.tan(pressure) * (1 - np.cos(pressure))
            turn = half * strain if mode == "paper" else half * np.cos(pressure) * mismatch
            error = -base * (turn + mismatch * lift)
            growth = half * rim - error
            if mode == "eulerian":
                radius = base / np.cos(pressure)
                radial = rim + strain * (radius - base)
                growth = base * (turn + np.tan(pressure) * radial / radius)
            # second order: strain times the growth itself, and the coordinate of the hot involute
            assert result.involute_error == pytest.approx(error, abs=1.2e-8)
            assert result.growth == pytest.approx(growth, abs=2e-8)


def test_involute_error_is_the_distance_to_the_hot_involute():
    # least distance from the hot point to the involute of the grown base circle, by search along that involute
    pair = spur_pair(25, 50, 3e-3)
    base, half, rise = pair.base_radius[0], pair.base_half_angle[0], 80.0
    rim = base_circle_growth(60.0, rise, pair.bore_radius[0], base, EXPANSION, "free_bore")
    for mode in ("paper", "consistent"):
        for curvature in (6e-3, 12e-3, 19e-3):
            result = flank_growth(np.array([curvature]), base, half, rise, rim, EXPANSION, mode)
            pressure = np.arctan(curvature / base)
            radius = base / np.cos(pressure)
            radial = rim + EXPANSION * rise * (radius - base)
            psi = half - involute(pressure)
            grown_psi = psi * (1 + EXPANSION * rise)
            if mode == "consistent":
                grown_psi = psi * (1 + EXPANSION * rise) * radius / (radius + radial)
            polar = involute(pressure) - (grown_psi - psi)
            point = (radius + radial) * np.array([np.cos(polar), np.sin(polar)])
            hot_base = base + rim

            def tangency(roll, point=point, hot_base=hot_base):
                # the involute at roll angle t has the direction (cos t, sin t); its foot point is orthogonal to it
                x = hot_base * (np.cos(roll) + roll * np.sin(roll))
                y = hot_base * (np.sin(roll) - roll * np.cos(roll))
                return (point[0] - x) * np.cos(roll) + (point[1] - y) * np.sin(roll)

            roll = brentq(tangency, np.tan(pressure) - 0.05, np.tan(pressure) + 0.05, xtol=1e-15)
            foot = hot_base * np.array([np.cos(roll) + roll * np.sin(roll), np.sin(roll) - roll * np.cos(roll)])
            # normal to the flank, away from the tooth, whose centre line lies at a greater polar angle
            normal = np.array([np.sin(roll), -np.cos(roll)])
            assert -(point - foot) @ normal == pytest.approx(result.involute_error[0], abs=2e-11)


def exact_shift(pair, i, curvature, rise, shaft):
    """Return r_b (half angle of the hot tooth less that of the cold one) at one fixed radius, and the first order."""
    base, half = pair.base_radius[i], pair.base_half_angle[i]
    result = grown(pair, i, np.array([curvature]), "eulerian", rise, shaft)
    strain = EXPANSION * rise

    def hot(roll):  # radius and half angle of the hot material point of roll angle `roll`
        radius = base * np.hypot(1, roll)
        radial = result.base_circle_growth + strain * (radius - base)
        return radius + radial, (half - roll + np.arctan(roll)) * (1 + strain) * radius / (radius + radial)

    fixed, roll = np.hypot(base, curvature), curvature / base
    source = brentq(lambda t: hot(t)[0] - fixed, 0.0, roll, xtol=1e-16)
    return base * (hot(source)[1] - (half - roll + np.arctan(roll))), result.growth[0]


@pytest.mark.parametrize("teeth", PAIRS)
def test_eulerian_shift_is_the_change_of_the_half_angle_at_a_fixed_radius(teeth):
    pair = spur_pair(*teeth)
    for i, curvatures in enumerate(along_path(pair, 9)):
        for curvature in curvatures:
            exact, first_order = exact_shift(pair, i, curvature, 4.0, 3.0)
            assert first_order == pytest.approx(exact, rel=6e-3, abs=0)
            # what is left out is of second order: half the square of the radial shift over the curvature
            exact, first_order = exact_shift(pair, i, curvature, 80.0, 60.0)
            radial = EXPANSION * 80.0 * np.hypot(pair.base_radius[i], curvature)
            assert 0 < first_order - exact < pair.base_radius[i] ** 2 / curvature**3 * radial**2


@pytest.mark.parametrize("teeth", PAIRS)
def test_exact_eulerian_shifts_add_up_to_the_closed_form_within_one_per_cent(teeth):
    pair = spur_pair(*teeth)
    expected = EXPANSION * 80.0 * pair.centre_distance * np.sin(pair.working_pressure_angle)
    for curvatures in along_path(pair, 9).T:
        assert sum(exact_shift(pair, i, curvatures[i], 80.0, 80.0)[0] for i in range(2)) == pytest.approx(
            expected, rel=1e-2, abs=0
        )


@pytest.mark.parametrize("teeth", PAIRS)
def test_eulerian_shifts_of_uniform_heating_add_up_to_a_constant(teeth):
    pair = spur_pair(*teeth)
    shifts = [grown(pair, i, curvature, "eulerian").growth for i, curvature in enumerate(along_path(pair))]
    expected = EXPANSION * 80.0 * pair.centre_distance * np.sin(pair.working_pressure_angle)
    assert sum(shifts) == pytest.approx(np.full(41, expected), rel=1e-9, abs=0)
    for i, curvature in enumerate(along_path(pair)):
        assert shifts[i] == pytest.approx(EXPANSION * 80.0 * curvature, rel=1e-9, abs=0)


def test_eulerian_shift_grows_to_the_tip():
    pair = spur_pair(25, 50, 3e-3)
    curvature = along_path(pair)[0]
    assert (np.diff(grown(pair, 0, curvature, "eulerian", shaft=60.0).growth) > 0).all()


@pytest.mark.parametrize("mode", MODES)
def test_rise_may_vary_along_the_flank(mode):
    pair = spur_pair(19, 48, 3.175e-3)
    curvature = along_path(pair, 5)[0]
    rim = base_circle_growth(60.0, 80.0, pair.bore_radius[0], pair.base_radius[0], EXPANSION, "free_bore")
    rises = np.array([80.0, 95.0, 80.0, 85.0, 99.0])
    flank = (pair.base_radius[0], pair.base_half_angle[0])
    together = flank_growth(curvature, *flank, rises, rim, EXPANSION, mode).growth
    for j, rise in enumerate(rises):
        alone = flank_growth(curvature[j : j + 1], *flank, rise, rim, EXPANSION, mode).growth[0]
        assert together[j] == pytest.approx(alone, rel=1e-14, abs=0)


@pytest.mark.parametrize("mode", MODES)
def test_shifted_teeth_grow_with_their_own_thickness(mode):
    plain, shifted = spur_pair(25, 50, 3e-3), spur_pair(25, 50, 3e-3, shift=0.2)
    curvature = np.array([9e-3, 12e-3])
    thicker = (
        grown(shifted, 0, curvature, mode, shaft=60.0).growth - grown(plain, 0, curvature, mode, shaft=60.0).growth
    )
    assert (thicker > 0).all()
