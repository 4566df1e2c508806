"""Growth of the base circle against one-dimensional finite elements written here.

The flank against two-dimensional elements is in config/validation.yaml.
"""

import numpy as np
import pytest

from gearwear.heat.growth import base_circle_growth

EXPANSION, BORE, BASE = 1.1e-5, 15e-3, 35.24e-3
POINTS, WEIGHTS = np.polynomial.legendre.leggauss(5)


def disc_growth(rise, inner: float, outer: float, poisson_ratio: float, breaks: int = 120) -> float:
    """Return the displacement (m) of the rim of a disc in plane stress, free of traction, by quadratic elements.

    Principle of virtual work, int (s_r du' + s_t du/r) r dr = 0 with s = D (strain - l rise); unit modulus. An inner
    radius of zero means a full disc, u(0) = 0.
    """
    ends = np.linspace(inner, outer, breaks + 1)
    if inner < BORE < outer:
        ends = np.union1d(np.linspace(inner, BORE, breaks + 1), np.linspace(BORE, outer, breaks + 1))
    nodes = 2 * (len(ends) - 1) + 1
    stiffness, load = np.zeros((nodes, nodes)), np.zeros(nodes)
    elastic = np.array([[1, poisson_ratio], [poisson_ratio, 1]]) / (1 - poisson_ratio**2)
    for element, (low, high) in enumerate(zip(ends[:-1], ends[1:], strict=True)):
        own = slice(2 * element, 2 * element + 3)
        for x, weight in zip(POINTS, WEIGHTS, strict=True):
            r = (low + high) / 2 + x * (high - low) / 2
            shape = np.array([x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2])
            slope = np.array([x - 0.5, -2 * x, x + 0.5]) * 2 / (high - low)
            strain = np.stack([slope, shape / r])
            volume = weight * r * (high - low) / 2
            stiffness[own, own] += volume * strain.T @ elastic @ strain
            load[own] += volume * strain.T @ elastic @ np.full(2, EXPANSION * rise(r))
    free = np.arange(nodes) if inner > 0 else np.arange(1, nodes)
    return np.linalg.solve(stiffness[np.ix_(free, free)], load[free])[-1]


def conducted(shaft: float, rim: float, inner: float = BORE):
    """Return the rise of steady radial conduction; inside the bore that of the shaft."""
    return lambda r: shaft + (rim - shaft) * np.log(max(r, inner) / inner) / np.log(BASE / inner)


@pytest.mark.parametrize("poisson_ratio", [0.0, 0.3, 0.45])
@pytest.mark.parametrize(("shaft", "rim"), [(40.0, 80.0), (80.0, 40.0), (0.0, 80.0), (80.0, 80.0)])
def test_free_disc(shaft, rim, poisson_ratio):
    finite_elements = disc_growth(conducted(shaft, rim), BORE, BASE, poisson_ratio)
    closed = base_circle_growth(shaft, rim, BORE, BASE, EXPANSION, "free_bore")
    assert closed == pytest.approx(finite_elements, rel=1e-6, abs=0)


@pytest.mark.parametrize(("shaft", "rim"), [(40.0, 80.0), (80.0, 40.0), (80.0, 80.0)])
def test_disc_on_a_shaft_of_the_same_steel(shaft, rim):
    finite_elements = disc_growth(conducted(shaft, rim), 0.0, BASE, 0.3)
    closed = base_circle_growth(shaft, rim, BORE, BASE, EXPANSION, "solid_shaft")
    assert closed == pytest.approx(finite_elements, rel=1e-6, abs=0)


@pytest.mark.parametrize("bore", [3e-3, 34e-3])
def test_small_bore_and_thin_ring(bore):
    finite_elements = disc_growth(conducted(40.0, 80.0, bore), bore, BASE, 0.3, 400)
    closed = base_circle_growth(40.0, 80.0, bore, BASE, EXPANSION, "free_bore")
    assert closed == pytest.approx(finite_elements, rel=1e-6, abs=0)
