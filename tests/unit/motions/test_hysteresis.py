"""Where two sweeps differ."""

import numpy as np
import pytest

from gearwear.codes.motion_class import CHAOTIC, NOT_CONVERGED, QUASI_PERIODIC
from gearwear.motions.hysteresis import differing, distance

ORBIT = np.array([[0.1, 0.0], [0.2, 0.1], [0.4, -0.1]])


def section(orbit, begin=0, samples=20):
    return orbit[(begin + np.arange(samples)) % len(orbit)]


@pytest.mark.parametrize(
    ("one", "other", "apart", "differs"),
    [
        (1, 2, 0.0, True),
        (3, CHAOTIC, 0.0, True),
        (QUASI_PERIODIC, CHAOTIC, 0.0, True),
        (CHAOTIC, CHAOTIC, 0.5, False),
        (QUASI_PERIODIC, QUASI_PERIODIC, 0.5, False),
        (NOT_CONVERGED, 3, 0.5, False),
        (CHAOTIC, NOT_CONVERGED, 0.5, False),
        (3, 3, 1.9e-3, False),
        (3, 3, 2.1e-3, True),
    ],
)
def test_classes_and_orbits_decide(one, other, apart, differs):
    sections = np.stack([section(ORBIT), section(ORBIT) + [0.0, apart]])[:, None]
    assert differing([[one], [other]], sections).tolist() == [differs]
    assert differing([[other], [one]], sections[::-1]).tolist() == [differs]


@pytest.mark.parametrize("begin", [0, 1, 2])
def test_the_mesh_period_an_orbit_begins_with_does_not_matter(begin):
    sections = np.stack([section(ORBIT), section(ORBIT, begin)])[:, None]
    assert not differing([[3], [3]], sections).any()


def test_orbits_of_the_same_points_in_another_order_differ():
    assert distance(ORBIT, ORBIT[::-1]) == pytest.approx(0.1)
    assert distance(ORBIT, np.roll(ORBIT, 2, axis=0)) == 0.0


def test_points_are_judged_one_by_one_and_lost_motions_show_nothing():
    lost = np.full((20, 2), np.nan)
    one = np.stack([section(ORBIT), section(ORBIT), lost])
    other = np.stack([section(ORBIT), section(ORBIT) + 0.1, section(ORBIT)])
    found = differing([[3, 3, NOT_CONVERGED], [3, 3, 3]], np.stack([one, other]))
    assert found.tolist() == [False, True, False]
