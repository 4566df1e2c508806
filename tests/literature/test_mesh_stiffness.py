"""Mesh stiffness against an independent code and against ISO 6336-1.

The component values were computed for this project by a second, independent program (Gauss-Legendre quadrature,
200 points); they are cross-checks to the digits given, not measurements. ISO 6336-1 Method B is a fit to measured
single stiffness; it agrees with energy methods within some 25 per cent.
"""

import math

import numpy as np
import pytest

from gearwear.dynamics.harmonics import harmonics, mean_over_mesh
from gearwear.geometry.kinematics import curvature
from gearwear.mesh.cantilever import load_angle
from gearwear.mesh.foundation import foundation_factors
from gearwear.mesh.stiffness import Flanks, mesh_stiffness, pair_stiffness

BASE = {
    "cantilever": "base",
    "fillet_angle": "rack",
    "hertz": "linear",
    "profile_changes": "paper",
    "pairs": "plain",
    "foundation_coupling": 0.3,
}
PAIRS = {
    "25/30": {"teeth": (25, 30), "module": 2e-3, "face_width": 20e-3, "bore": (10e-3, 10e-3)},
    "19/48": {"teeth": (19, 48), "module": 3.175e-3, "face_width": 16e-3, "bore": (10e-3, 25e-3)},
}
MODULUS = {"25/30": 200e9, "19/48": 206.8e9}
DIMENSIONS = {
    "25/30": {
        "base_radius": (23.4923e-3, 28.1908e-3),
        "contact_ratio": 1.632583,
        "base_pitch": 5.90426e-3,
        "base_half_angle": np.radians((4.45396, 3.85396)),
        "rack_root_angle": (0.113233, 0.094361),
    },
    "19/48": {
        "base_radius": (28.3435e-3, 71.6046e-3),
        "contact_ratio": 1.645626,
        "base_pitch": 9.37302e-3,
        "base_half_angle": np.radians((5.59080, 2.72896)),
        "rack_root_angle": (0.148991, 0.058976),
    },
}
FOUNDATION = {
    "25/30": [(6.888564, 1.209700, 2.945148, 0.461381), (6.901496, 1.286882, 3.630355, 0.418405)],
    "19/48": [(6.887232, 1.340566, 3.289529, 0.409743), (6.919698, 1.208179, 4.066083, 0.435830)],
}
AT_PITCH_POINT = {
    "25/30": {
        "load_angle": np.radians((16.4, 17.0)),
        "foundation": (9.481403e8, 8.305269e8),
        "bending": (3.806260e10, 2.175070e10),
        "shear": (3.154957e9, 2.713244e9),
        "axial": (1.136371e11, 9.056605e10),
        "bending from the root": (5.899105e9, 6.756321e9),
    },
    "19/48": {
        "load_angle": np.radians((15.26316, 18.125)),
        "foundation": (6.991974e8, 6.517923e8),
        "bending": (7.400233e10, 4.710937e9),
        "shear": (3.286833e9, 1.540936e9),
        "axial": (1.377194e11, 4.487025e10),
        "bending from the root": (4.001827e9, 7.588395e9),
    },
}
HERTZ = {"25/30": 3.452300e9, "19/48": 2.855742e9}
PAIR = {"25/30": (2.062382e8, 3.006590e8, 2.135234e8), "19/48": (1.423467e8, 2.210850e8, 1.729483e8)}
MESH = {
    "25/30": {"mean": 4.39979e8, "range": (2.9413e8, 5.3018e8), "first": (1.3371e8, -1.9936), "root": 3.72334e8},
    "19/48": {"mean": 3.26827e8, "range": (2.1043e8, 3.9381e8), "first": (9.888e7, -2.0707), "root": 2.97283e8},
}


@pytest.fixture(params=PAIRS, scope="module")
def name(request):
    return request.param


@pytest.fixture(scope="module")
def geometry(name, make_geometry):
    return make_geometry(**PAIRS[name])


def of(geometry, modulus, **settings):
    none = Flanks(*np.zeros((2, 2, geometry.sizes["path"])))
    return pair_stiffness(geometry, np.full(2, modulus), np.full(2, 0.3), none, BASE | settings)


def mesh_of(geometry, modulus, **settings):
    return mesh_stiffness(of(geometry, modulus, **settings), geometry["entering"].values, geometry["leaving"].values)


def pitch_node(geometry):
    (node,) = np.flatnonzero(geometry["path"].values == float(geometry["pitch_point"]))
    return node


def test_dimensions(name, geometry):
    for quantity, expected in DIMENSIONS[name].items():
        np.testing.assert_allclose(geometry[quantity], expected, rtol=1e-5, err_msg=quantity)


def test_foundation_factors(name, geometry):
    for i, expected in enumerate(FOUNDATION[name]):
        ratio = float(geometry["root_radius"][i] / geometry["bore_radius"][i])
        found = foundation_factors(ratio, float(geometry["rack_root_angle"][i]))
        np.testing.assert_allclose(found, expected, rtol=1e-5)


def test_components_at_the_pitch_point(name, geometry):
    node, expected = pitch_node(geometry), AT_PITCH_POINT[name]
    found = of(geometry, MODULUS[name])
    for i in range(2):
        radius = curvature(geometry)[0][i, node]
        angle = load_angle(radius, float(geometry["base_radius"][i]), float(geometry["base_half_angle"][i]))
        assert angle == pytest.approx(expected["load_angle"][i], rel=1e-5)
    for part in ("foundation", "bending", "shear", "axial"):
        np.testing.assert_allclose(1 / getattr(found, part)[:, node], expected[part], rtol=1e-5, err_msg=part)
    assert 1 / found.hertz[node] == pytest.approx(HERTZ[name], rel=1e-5)
    rooted = of(geometry, MODULUS[name], cantilever="root")
    np.testing.assert_allclose(1 / rooted.bending[:, node], expected["bending from the root"], rtol=1e-5)


def test_pair_at_start_pitch_point_and_end_of_contact(name, geometry):
    found = of(geometry, MODULUS[name]).pair_stiffness[[0, pitch_node(geometry), -1]]
    np.testing.assert_allclose(found, PAIR[name], rtol=1e-5)


def test_mean_range_and_first_harmonic_of_the_mesh(name, geometry):
    k, expected = mesh_of(geometry, MODULUS[name]), MESH[name]
    phase, width = geometry["mesh_phase"].values, geometry["mesh_phase_width"].values
    assert mean_over_mesh(k, width) == pytest.approx(expected["mean"], rel=1e-3)
    np.testing.assert_allclose((k.min(), k.max()), expected["range"], rtol=1e-3)
    amplitude, angle = harmonics(k, phase, width, 1)
    assert amplitude[0] == pytest.approx(expected["first"][0], rel=1e-3)
    assert angle[0] == pytest.approx(expected["first"][1], abs=1e-3)


def test_mean_of_the_mesh_clamped_at_the_root(name, geometry):
    k = mesh_of(geometry, MODULUS[name], cantilever="root")
    assert mean_over_mesh(k, geometry["mesh_phase_width"].values) == pytest.approx(MESH[name]["root"], rel=1e-3)


def test_amplitude_exceeds_that_of_the_rectangular_wave_by_three_per_cent(name, geometry):
    k, double = mesh_of(geometry, MODULUS[name]), geometry["leaving"].values >= 0
    width = geometry["mesh_phase_width"].values
    step = k[double] @ width[double] / width[double].sum() - k[~double] @ width[~double] / width[~double].sum()
    rectangular = 2 / math.pi * step * math.sin(math.pi * (float(geometry["contact_ratio"]) - 1))
    amplitude = harmonics(k, geometry["mesh_phase"].values, width, 1)[0][0]
    assert amplitude / rectangular == pytest.approx(1.03, abs=5e-3)


@pytest.mark.parametrize(("name", "expected"), [("25/30", 1.17), ("19/48", 1.09)], indirect=["name"])
def test_clamp_at_the_base_circle_is_too_stiff_for_small_gears(name, geometry, expected):
    node = pitch_node(geometry)
    base, root = (of(geometry, 206e9, cantilever=clamp).pair_stiffness[node] for clamp in ("base", "root"))
    assert base / root == pytest.approx(expected, abs=0.0051)


@pytest.mark.parametrize(("teeth", "expected"), [((50, 50), 0.92), ((55, 75), 0.82)])
def test_clamp_at_the_base_circle_is_too_soft_above_41_teeth(make_geometry, teeth, expected):
    """The bores of these values are not stated: the foundation has its share, so a root over bore ratio is searched."""
    ratios = []
    for root_over_bore in (1.5, 4.0):
        geometry = make_geometry(teeth, 3e-3, 20e-3, bores_of(teeth, root_over_bore), mesh_cells=40)
        node = pitch_node(geometry)
        base, root = (of(geometry, 206e9, cantilever=clamp).pair_stiffness[node] for clamp in ("base", "root"))
        ratios.append(base / root)
    assert ratios[0] < expected < ratios[1] < 1


def bores_of(teeth, root_over_bore):
    """Return the bore radii of standard gears of module 3 mm."""
    return tuple((z - 2.5) * 1.5e-3 / root_over_bore for z in teeth)


def iso_compliance(teeth, shift=(0.0, 0.0)):
    """Return q' in mm um/N: ISO 6336-1 (2006), Eq. 84, Method B, pair of virtual numbers of teeth."""
    (z1, z2), (x1, x2) = teeth, shift
    constant = 0.04723 + 0.15551 / z1 + 0.25791 / z2 - 0.00635 * x1 - 0.11654 * x1 / z1
    return constant - 0.00193 * x2 - 0.24188 * x2 / z2 + 0.00529 * x1**2 + 0.00182 * x2**2


def iso_single(teeth, shift=(0.0, 0.0), dedendum=1.25, helix=0.0, modulus=206e9):
    """Return c' in N/(um mm) of solid discs, 20 deg racks."""
    rack = 1 + 0.5 * (1.2 - dedendum)
    return 0.8 * rack * math.cos(math.radians(helix)) * modulus / 206e9 / iso_compliance(teeth, shift)


def iso_mesh(single, contact_ratio):
    """Return c_gamma_alpha in N/(um mm), the mean mesh stiffness over the face width."""
    return single * (0.75 * contact_ratio + 0.25)


def test_iso_formula_on_the_first_example_of_its_technical_report():
    """ISO/TR 6336-30, example 1: helical 17/103, shift 0.145/0, dedendum 1.40; eps 1.5491 follows from its c_gamma."""
    teeth, shift = (18.905, 114.543), (0.145, 0.0)
    assert 1 / iso_compliance(teeth, shift) == pytest.approx(17.85584, rel=2e-5)
    single = iso_single(teeth, shift, dedendum=1.40, helix=15.8)
    assert single == pytest.approx(12.37047, rel=2e-5)
    assert iso_mesh(single, 1.5491) == pytest.approx(17.46485, rel=1e-4)


def test_iso_formula_on_an_unshifted_spur_pair(make_geometry):
    """17/43, 206 GPa: q' 0.062376, c'_th 16.032, C_B 0.975, c' 12.505, contact ratio 1.6211, c_gamma 18.330."""
    geometry = make_geometry((17, 43), 3e-3, 20e-3, (8e-3, 20e-3), mesh_cells=40)
    ratio = float(geometry["contact_ratio"])
    assert ratio == pytest.approx(1.6211, abs=5e-5)
    assert iso_compliance((17, 43)) == pytest.approx(0.062376, abs=5e-7)
    assert 1 / iso_compliance((17, 43)) == pytest.approx(16.032, abs=5e-4)
    assert iso_single((17, 43)) == pytest.approx(12.505, abs=5e-4)
    assert iso_mesh(iso_single((17, 43)), ratio) == pytest.approx(18.330, abs=1e-3)


def over_iso(make_geometry, teeth, root_over_bore):
    """Return the mean mesh stiffness of the root model over that of ISO."""
    width = 20e-3
    geometry = make_geometry(teeth, 3e-3, width, bores_of(teeth, root_over_bore), mesh_cells=80)
    k = mesh_of(geometry, 206e9, cantilever="root")
    mean = mean_over_mesh(k, geometry["mesh_phase_width"].values) / width * 1e-9
    return mean / iso_mesh(iso_single(teeth), float(geometry["contact_ratio"]))


@pytest.mark.parametrize("teeth", [(17, 43), (19, 48), (25, 30), (30, 60), (50, 50)])
def test_root_model_agrees_with_iso_within_a_quarter(make_geometry, teeth):
    ratios = [over_iso(make_geometry, teeth, root_over_bore) for root_over_bore in (1.5, 2.5, 4.0)]
    assert 1.25 > ratios[0] > ratios[1] > ratios[2] > 0.75


@pytest.mark.parametrize("teeth", [(55, 75), (80, 100)])
def test_root_model_agrees_with_iso_for_large_gears_on_wider_bores(make_geometry, teeth):
    """Below root over bore 3; at 4 the foundation fit leaves 0.75 for 55/75 and 0.72 for 80/100."""
    ratios = [over_iso(make_geometry, teeth, root_over_bore) for root_over_bore in (1.5, 3.0)]
    assert 1.25 > ratios[0] > ratios[1] > 0.75


def test_preset_clamped_at_the_root_is_within_five_per_cent_of_iso(make_geometry):
    geometry = make_geometry(**PAIRS["19/48"])
    k = mesh_of(geometry, 206e9, cantilever="root")
    mean = mean_over_mesh(k, geometry["mesh_phase_width"].values) / 16e-3 * 1e-9
    assert mean / iso_mesh(iso_single((19, 48)), float(geometry["contact_ratio"])) == pytest.approx(0.972, abs=5e-3)
