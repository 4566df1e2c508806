"""Tooth compliances against integrals along the height of a drawn tooth, limits and scaling."""

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from gearwear.mesh.cantilever import load_angle, tooth_compliance

ALPHA = math.radians(20)
POISSON = 0.3


def half_on_base(teeth):
    return math.pi / 2 / teeth + math.tan(ALPHA) - ALPHA


def flank(roll, half):
    """Point of the involute in a frame on the tooth axis, base radius 1: half thickness and height."""
    radius, angle = math.hypot(1, roll), half - (roll - math.atan(roll))
    return radius * math.sin(angle), radius * math.cos(angle)


def drawn_tooth(a1, half, root_ratio=1.0, arm=0.0):
    """Compliances times E B by quadrature over the height, from coordinates of the drawn tooth; base radius 1."""
    contact_roll = a1 + half
    contact = np.array(flank(contact_roll, half))
    force = np.array([-math.cos(a1), -math.sin(a1)])
    foot_of_flank = flank(max(0.0, math.sqrt(max(root_ratio**2 - 1, 0))), half)
    bottom = foot_of_flank[1]
    if root_ratio < 1:
        bottom = root_ratio * math.cos(math.asin(math.sin(half) / root_ratio))

    def thickness(height):
        if height <= foot_of_flank[1]:
            return foot_of_flank[0]
        return flank(brentq(lambda roll: flank(roll, half)[1] - height, 0, contact_roll, xtol=1e-15), half)[0]

    def moment(height):
        lever = contact - np.array([0.0, height])
        return lever[0] * force[1] - lever[1] * force[0] - arm

    def integral(of):
        pieces = sorted({bottom, foot_of_flank[1], contact[1]})
        return sum(
            quad(of, low, high, epsabs=0, epsrel=1e-10)[0] for low, high in zip(pieces, pieces[1:], strict=False)
        )

    bending = integral(lambda y: moment(y) ** 2 / (2 / 3 * thickness(y) ** 3))
    area = integral(lambda y: 1 / (2 * thickness(y)))
    return bending, 1.2 * 2 * (1 + POISSON) * math.cos(a1) ** 2 * area, math.sin(a1) ** 2 * area


@pytest.mark.parametrize("teeth", [19, 25, 48, 80])
@pytest.mark.parametrize("degrees", [3.0, 12.0, 25.0])
def test_angular_integrals_equal_integrals_over_the_height_of_the_drawn_tooth(teeth, degrees):
    half, a1 = half_on_base(teeth), math.radians(degrees)
    found = tooth_compliance(np.array([a1]), half, POISSON)
    np.testing.assert_allclose(np.ravel(found), drawn_tooth(a1, half), rtol=1e-8)


@pytest.mark.parametrize(("teeth", "root_ratio"), [(19, 0.924), (25, 0.96), (48, 1.0088), (80, 1.031)])
@pytest.mark.parametrize("degrees", [14.0, 19.0, 24.0])
def test_tooth_clamped_at_the_root_equals_the_drawn_tooth_down_to_the_root(teeth, root_ratio, degrees):
    half, a1 = half_on_base(teeth), math.radians(degrees)
    found = tooth_compliance(np.array([a1]), half, POISSON, root_ratio=root_ratio)
    np.testing.assert_allclose(np.ravel(found), drawn_tooth(a1, half, root_ratio), rtol=1e-8)


@pytest.mark.parametrize("root_ratio", [0.924, 1.0, 1.01])
@pytest.mark.parametrize("arm", [-0.02, 0.01])
def test_change_of_the_moment_arm_bends_the_whole_tooth(root_ratio, arm):
    half, a1 = half_on_base(25), math.radians(19)
    found = tooth_compliance(np.array([a1]), half, POISSON, np.array([arm]), None, root_ratio)
    np.testing.assert_allclose(np.ravel(found), drawn_tooth(a1, half, root_ratio, arm), rtol=1e-8)


def test_moment_of_the_load_is_force_times_base_radius_less_height_times_cosine():
    rng = np.random.default_rng(1)
    for half, roll, height in zip(
        rng.uniform(0.04, 0.1, 50), rng.uniform(0.1, 0.7, 50), rng.uniform(0, 1, 50), strict=True
    ):
        a1 = roll - half
        x, y = flank(roll, half)
        moment = -x * math.sin(a1) + (y - height) * math.cos(a1)
        assert moment == pytest.approx(1 - height * math.cos(a1), abs=1e-13)


def test_load_angle_is_that_of_the_flank_normal_with_the_normal_to_the_axis():
    half, roll, step = half_on_base(25), 0.4, 1e-6
    below, above = np.array(flank(roll - step, half)), np.array(flank(roll + step, half))
    along = (above - below) / np.hypot(*(above - below))
    angle = math.atan2(-along[0], along[1])
    assert float(load_angle(np.array(roll * 30e-3), 30e-3, half)) == pytest.approx(angle, abs=1e-9)


def test_load_square_to_the_axis_compresses_nothing():
    found = tooth_compliance(np.array([0.0, 0.1]), half_on_base(25), POISSON)
    assert found.axial[0] == 0
    assert found.axial[1] > 0


def test_slightly_negative_load_angles_are_valid():
    half = half_on_base(19)
    a1 = math.radians(-1.29)
    np.testing.assert_allclose(
        np.ravel(tooth_compliance(np.array([a1]), half, POISSON)), drawn_tooth(a1, half), rtol=1e-8
    )


def test_compliance_grows_with_the_height_of_the_contact():
    found = tooth_compliance(np.radians([5.0, 10.0, 15.0, 20.0, 25.0]), half_on_base(25), POISSON)
    assert (np.diff(found.bending) > 0).all()


@pytest.mark.parametrize("side", [-1, 1])
def test_root_model_meets_the_base_model_where_both_circles_meet(side):
    """Teeth number 2 (1 + 0.25)/(1 - cos 20 deg) = 41.45, approached from either side."""
    meeting = 2.5 / (1 - math.cos(ALPHA))
    assert meeting == pytest.approx(41.45, abs=0.01)
    gaps = []
    for distance in (1e-2, 1e-4, 1e-6):
        teeth = meeting + side * distance
        half, a1 = half_on_base(teeth), np.radians([5.0, 15.0, 25.0])
        root_ratio = (teeth - 2.5) / (teeth * math.cos(ALPHA))
        assert (root_ratio > 1) == (side > 0)
        base = np.array(tooth_compliance(a1, half, POISSON))
        gaps.append(np.abs(np.array(tooth_compliance(a1, half, POISSON, root_ratio=root_ratio)) / base - 1).max())
    assert gaps[2] < 1e-6
    assert gaps[0] > 50 * gaps[1] > 2500 * gaps[2]


def test_zero_changes_of_the_profile_change_nothing():
    a1, half = np.radians([2.0, 12.0, 22.0]), half_on_base(25)
    for root_ratio in (None, 0.96):
        plain = tooth_compliance(a1, half, POISSON, root_ratio=root_ratio)
        same = tooth_compliance(a1, half, POISSON, np.zeros(3), np.zeros_like, root_ratio)
        np.testing.assert_array_equal(np.array(plain), np.array(same))


def relative_change(removed, grown, mode):
    """Change of the compliances (per cent) at load angles 5, 15, 25 deg, 25 teeth of module 3 mm; D, H of the text."""
    base, half, a1 = 25 * 1.5e-3 * math.cos(ALPHA), half_on_base(25), np.radians([5.0, 15.0, 25.0])
    if mode == "paper":
        arm = (removed + 2 * grown * np.cos(a1)) * np.sin(a1) / base
    else:
        arm = -removed * np.sin(a1) / (2 * base)

    def section(a):
        change = (removed + 2 * grown * np.cos(a)) / (2 * base)
        return change * np.cos(a) if mode == "paper" else change

    new, old = tooth_compliance(a1, half, POISSON, arm, section), tooth_compliance(a1, half, POISSON)
    return [100 * (a / b - 1) for a, b in zip(new, old, strict=True)]


@pytest.mark.parametrize(
    ("mode", "removed", "grown", "bending"),
    [
        ("paper", -50e-6, 0.0, (2.93, 4.74, 4.74)),
        ("exact", -50e-6, 0.0, (2.80, 1.92, 2.12)),
        ("paper", 0.0, 10e-6, (-1.08, -1.78, -1.74)),
        ("exact", 0.0, 10e-6, (-1.09, -1.10, -1.14)),
    ],
)
def test_size_of_the_profile_corrections_in_bending(mode, removed, grown, bending):
    np.testing.assert_allclose(relative_change(removed, grown, mode)[0], bending, atol=0.0051)


def test_size_of_the_profile_corrections_in_shear_and_compression():
    _, shear, axial = relative_change(-50e-6, 0.0, "paper")
    np.testing.assert_allclose(shear, (0.92, 0.95, 1.11), atol=0.0051)
    np.testing.assert_allclose(axial, shear, rtol=1e-12)
