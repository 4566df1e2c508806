"""Points of a sweep that a search computes."""

import numpy as np
import pytest
import yaml

from gearwear.calibration.sampling import POINTS, points

GRID = np.linspace(0.1, 1.7, 401)


def window(low, high, sweep="mesh_frequency"):
    return {"kind": "window", "sweep": sweep, "range": [low, high], "class": ["P1"]}


def test_a_wide_window_gives_few_points_with_both_its_ends():
    chosen = GRID[points([window(0.5, 1.0)], "mesh_frequency", GRID)]
    assert len(chosen) == POINTS
    assert chosen[0] == pytest.approx(0.5) and chosen[-1] == pytest.approx(1.0)


def test_a_narrow_window_gives_all_its_points():
    chosen = GRID[points([window(1.0, 1.008)], "mesh_frequency", GRID)]
    np.testing.assert_allclose(chosen, [1.0, 1.004, 1.008])


def test_an_event_gives_every_other_point_around_it_cut_at_the_end_of_the_sweep():
    claim = {"kind": "numeric", "sweep": "mesh_frequency", "event": "P1->P2", "expected": 1.7}
    chosen = points([claim], "mesh_frequency", GRID)
    assert chosen.tolist() == list(range(400 - 2 * POINTS, 401, 2))


def test_claims_about_another_sweep_give_nothing():
    assert points([window(0.5, 1.0, "ste")], "mesh_frequency", GRID).size == 0


def test_every_claim_of_the_paper_has_points(repository):
    claims = yaml.safe_load((repository / "config/paper_claims.yaml").read_text())["claims"]
    for claim in claims:
        if claim["kind"] == "window":
            low, high = claim["range"]
            grid = {"mesh_frequency": GRID, "ste": np.linspace(0.1, 3, 581), "backlash": np.linspace(0.1, 1.5, 561)}
            swept = grid[claim["sweep"]]
            chosen = swept[points(claims, claim["sweep"], swept)]
            assert ((chosen >= low - 1e-9) & (chosen <= high + 1e-9)).any(), claim["id"]
