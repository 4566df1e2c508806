"""Load sharing, transmission error and path of contact against hand calculations of two pairs.

The forces and errors follow from one linear balance (Chen and Shao, Mech. Mach. Theory 62 (2013)); the digits were
computed apart from this program and support a unit in the last place.
"""

import numpy as np
import pytest

from gearwear.mesh.sharing import Springs, share


def pairs(k1, k2):
    return Springs(np.array([k1, k2]), np.zeros(2), np.array([1, 0]))


@pytest.mark.parametrize(
    ("removed", "error", "first", "second"),
    [
        (0.0, 7.895, 1579, 1421),
        (8.0, 11.684, 2337, 663),
        (15.0, 15.000, 3000, 0),
        (20.0, 15.000, 3000, 0),
    ],
)
def test_two_pairs_under_three_kilonewtons(removed, error, first, second):
    """2.0e8 and 1.8e8 N/m, the second pair worn by `removed` um: error in um, forces in N."""
    found = share(pairs(2.0e8, 1.8e8), np.array([0.0, removed * 1e-6]), 3000.0)
    np.testing.assert_allclose(found.approach * 1e6, error, atol=5.1e-4)
    np.testing.assert_allclose(found.load_share * 3000, (first, second), atol=0.51)


def test_load_sharing_factors_of_two_worn_pairs():
    """3.0e8 and 2.5e8 N/m, 4 kN, worn by 2 and 5 um."""
    found = share(pairs(3.0e8, 2.5e8), np.array([2e-6, 5e-6]), 4000.0)
    np.testing.assert_allclose(found.approach * 1e6, 10.63636, atol=5e-6)
    np.testing.assert_allclose(found.load_share, (0.6477272727, 0.3522727273), atol=5e-11)


def test_second_pair_separates_at_thirteen_micrometres():
    for difference, loaded in ((13.333e-6, True), (13.334e-6, False)):
        found = share(pairs(3.0e8, 2.5e8), np.array([0.0, difference]), 4000.0)
        assert (found.load_share[1] > 0) == loaded


def test_path_of_contact(make_geometry):
    """25/40, module 3 mm, 20 deg; mm."""
    geometry = make_geometry((25, 40), 3e-3, 20e-3, (10e-3, 15e-3), mesh_cells=40)
    expected = {
        "line_of_action": 33.346964,
        "start_of_contact": 5.237891,
        "pitch_point": 12.825755,  # 37.5 sin 20 deg = 12.8257554
        "end_of_contact": 19.962465,
        "base_pitch": 8.856394,
    }
    for name, value in expected.items():
        assert float(geometry[name]) * 1e3 == pytest.approx(value, abs=5.1e-7), name
    assert float(geometry["contact_ratio"]) == pytest.approx(1.662592, abs=5.1e-7)


def test_path_of_contact_of_the_fzg_pair(make_geometry):
    """Type C: 16/24, module 4.5 mm, shift 0.1817/0.1715, centre distance 91.5 mm: contact ratio about 1.46."""
    shift = {"pinion": 0.1817, "gear": 0.1715}
    geometry = make_geometry(
        (16, 24), 4.5e-3, 14e-3, (10e-3, 10e-3), mesh_cells=40, profile_shift=shift, centre_distance=91.5e-3
    )
    assert float(geometry["contact_ratio"]) == pytest.approx(1.46, abs=0.005)
