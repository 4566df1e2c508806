"""Friction coefficient from dry to full film."""

import math

import numpy as np
import pytest

from gearwear.contact.friction import elastohydrodynamic_friction, friction_coefficient

LAWS = ("load_sharing", "thresholds")
COEFFICIENTS = {"dry": 0.2, "boundary": 0.1}


def friction(film_ratio, law="load_sharing", full_film=0.035, **changed):
    return friction_coefficient(np.asarray(film_ratio), full_film, law, **(COEFFICIENTS | changed))


def test_regression_of_the_full_film_at_one_contact():
    # 1.2 GPa, slide to roll 0.4, 8 m/s, 10 mPa s, 9 mm, 0.5 um, term by term
    strain = 0.4 * 1.2 * math.log10(10.0)
    exponent = -8.916465 - 0.354068 * strain + 2.812084 * math.exp(-strain) + 0.620305 * math.exp(0.5)
    expected = math.exp(exponent) * 1.2**1.03303 * 0.4**1.036077 * 8**-0.100601 * 10**0.752755 * 0.009**-0.390958
    assert elastohydrodynamic_friction(1.2e9, 0.4, 8.0, 0.010, 9e-3, 0.5e-6) == pytest.approx(
        expected, rel=1e-12, abs=0
    )


def test_full_film_is_of_the_size_of_gears_and_nonsense_in_megapascal():
    # the regression wants GPa: a thousand times the pressure drives the exponent to some -35 and beyond
    assert 0.01 < elastohydrodynamic_friction(1.0e9, 0.3, 10.0, 0.010, 8e-3, 0.5e-6) < 0.08
    assert elastohydrodynamic_friction(1.0e12, 0.3, 10.0, 0.010, 8e-3, 0.5e-6) < 1e-10


def test_full_film_vanishes_at_the_pitch_point_with_its_power_of_sliding():
    slow = elastohydrodynamic_friction(1e9, np.array([0.0, 1e-8, 1e-7]), 10.0, 0.010, 8e-3, 0.5e-6)
    assert slow[0] == 0.0
    assert math.log10(slow[2] / slow[1]) == pytest.approx(1.036077, abs=1e-6)


def test_direction_of_sliding_does_not_matter():
    both = elastohydrodynamic_friction(1e9, np.array([-0.3, 0.3]), 10.0, 0.010, 8e-3, 0.5e-6)
    assert both[0] == both[1]


@pytest.mark.parametrize(
    ("film_ratio", "expected"),
    [(0.01, 0.177), (0.1, 0.080), (0.2, 0.071), (0.4, 0.059), (0.7, 0.048), (1.0, 0.042), (1.5, 0.037), (2.0, 0.035)],
)
def test_load_sharing_between_dry_and_full_film(film_ratio, expected):
    assert friction(film_ratio) == pytest.approx(expected, abs=6e-4)


def test_mixed_branch_follows_castro_and_seabra():
    for ratio in (0.06, 0.3, 0.9, 1.7):
        share = 1.21 * ratio**0.64 / (1 + 0.37 * ratio**1.26)
        expected = 0.035 * share**1.2 + 0.1 * (1 - share)
        assert friction(ratio) == pytest.approx(expected, abs=3e-4 * 0.1)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("full_film", [0.0, 0.035, 0.12])
def test_no_jump_anywhere(law, full_film):
    ratio = np.concatenate([np.logspace(-6, -1, 40001), np.linspace(0.1, 5.0, 80001)[1:]])
    values = friction(ratio, law, full_film)
    assert np.isfinite(values).all()
    assert np.abs(np.diff(values)).max() < 1e-3 * values.max()


@pytest.mark.parametrize("law", LAWS)
def test_friction_falls_as_the_film_thickens(law):
    values = friction(np.linspace(0.0, 5.0, 5001), law)
    assert np.diff(values).max() <= 1e-15


def test_share_joins_the_full_film_without_a_step():
    below, above = friction(np.array([2 - 1e-9, 2 + 1e-9]))
    assert abs(below - above) < 1e-9
    # the printed function alone would leave a step of 3e-4 there
    assert pytest.approx(0.9997, abs=5e-5) == 1.21 * 2**0.64 / (1 + 0.37 * 2**1.26)


@pytest.mark.parametrize(("law", "ratio"), [("load_sharing", 2.0), ("load_sharing", 4.0), ("thresholds", 3.0)])
def test_thick_film_has_the_friction_of_the_full_film(law, ratio):
    assert friction(ratio, law) == pytest.approx(0.035, rel=1e-14, abs=0)


@pytest.mark.parametrize(("law", "ratio"), [("load_sharing", 0.005), ("thresholds", 0.2)])
def test_no_film_has_dry_friction(law, ratio):
    assert friction(np.array([0.0, ratio]), law) == pytest.approx([0.2, 0.2], rel=1e-14, abs=0)


def test_dry_friction_plays_no_part_above_a_film_ratio_of_one_twentieth():
    ratio = np.linspace(0.05, 5.0, 200)
    assert np.array_equal(friction(ratio), friction(ratio, dry=0.9))
    assert friction(0.02, dry=0.9) > friction(0.02)


def test_thresholds_keep_boundary_friction_between_0_4_and_1():
    assert friction(np.array([0.4, 0.7, 1.0]), "thresholds") == pytest.approx([0.1] * 3, rel=1e-14, abs=0)
    assert friction(0.3, "thresholds") == pytest.approx(0.15, rel=1e-14, abs=0)
    assert friction(2.0, "thresholds") == pytest.approx((0.1 + 0.035) / 2, rel=1e-14, abs=0)


def test_thresholds_are_smooth():
    step = 1e-5
    ratio = np.arange(0.1, 4.0, step)
    slope = np.diff(friction(ratio, "thresholds")) / step
    # second derivative of the two smoothsteps: 6 drop / width^2
    assert np.abs(np.diff(slope)).max() < 1.01 * step * 6 * 0.1 / 0.2**2


def test_thresholds_exceed_load_sharing_where_gears_run():
    ratio = np.linspace(0.2, 0.9, 50)
    assert (friction(ratio, "thresholds") > friction(ratio)).all()


def test_friction_takes_the_full_film_place_by_place():
    full_film = np.array([0.0, 0.02, 0.04])
    assert friction_coefficient(np.full(3, 5.0), full_film, "load_sharing", 0.2, 0.1) == pytest.approx(full_film)


def test_rough_flanks_rub_no_harder_than_boundary_contact():
    rough = elastohydrodynamic_friction(1.0e9, 0.5, 5.0, 0.01, 0.01, 1e-5)
    assert np.isfinite(rough)
    for law in ("load_sharing", "thresholds"):
        assert friction_coefficient(5.0, 3.0, law, 0.2, 0.1) == pytest.approx(0.1, rel=1e-12)
