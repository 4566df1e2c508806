"""Compliance of the gear body: geometry of its arguments, scaling and the range of the fit."""

import math

import numpy as np
import pytest

from gearwear.mesh.foundation import foundation_compliance, foundation_factors


def test_factors_are_the_published_polynomial():
    """Evaluated by hand at h = 2, theta = 0.1 from the table of Chaari et al. (2009)."""
    expected = [
        -5.574e-3 - 7.9944e-3 - 4.603e-3 + 0.047702 + 0.0542 + 6.8045,
        0.060111 + 0.1124 - 0.166862 - 0.099256 + 0.3248 + 0.9086,
        -0.050952 + 0.742 + 0.0001076 + 0.533 + 0.579 + 0.9236,
        -0.0062042 + 0.0363556 - 0.0081928 + 0.078297 - 0.2944 + 0.6904,
    ]
    np.testing.assert_allclose(foundation_factors(2.0, 0.1), expected, rtol=1e-12)


def test_compliance_is_the_formula_with_the_axis_crossing_of_the_load():
    """The load line, tangent to the base circle, is intersected with the tooth axis numerically."""
    base, root, bore, theta = 30e-3, 28.5e-3, 10e-3, 0.11
    for a1 in np.radians([-1.0, 5.0, 18.0, 27.0]):
        tangent_point = base * np.array([math.sin(a1), math.cos(a1)])
        direction = np.array([-math.cos(a1), math.sin(a1)])
        crossing = (tangent_point - direction * tangent_point[0] / direction[0])[1]
        u = (crossing - root) / (2 * root * theta)
        lead, mixed, constant, shear = foundation_factors(root / bore, theta)
        expected = math.cos(a1) ** 2 * (lead * u**2 + mixed * u + constant * (1 + shear * math.tan(a1) ** 2))
        found = foundation_compliance(np.array([a1]), base, root, bore, theta)
        assert found == pytest.approx(expected, rel=1e-12)


def test_compliance_does_not_depend_on_the_size_of_the_gear():
    a1 = np.radians([2.0, 15.0, 25.0])
    small = foundation_compliance(a1, 30e-3, 28.5e-3, 10e-3, 0.11)
    np.testing.assert_allclose(foundation_compliance(a1, 90e-3, 85.5e-3, 30e-3, 0.11), small, rtol=1e-12)
