"""The members of the ensemble: its faces, the points inside, and what they override."""

import numpy as np
import pytest
from scipy.stats import qmc

from gearwear.config.ensemble import PLACES, factors, overrides, radical_inverse

BOX = {name: {"low": 0.9 - i / 100, "high": 1.1 + i / 100} for i, name in enumerate(PLACES)}


def settings(members=0, **box):
    return {"members": members, "box": {**BOX, **box}}


def test_every_parameter_stands_alone_at_either_end():
    found = factors(settings())
    assert list(found) == [f"{name}_{end}" for name in PLACES for end in ("low", "high")]
    for name in PLACES:
        for end in ("low", "high"):
            assert found[f"{name}_{end}"] == dict.fromkeys(PLACES, 1.0) | {name: BOX[name][end]}


def test_an_end_that_changes_nothing_makes_no_member():
    found = factors(settings(bore_radius={"low": 1.0, "high": 1.2}))
    assert "bore_radius_low" not in found and found["bore_radius_high"]["bore_radius"] == 1.2
    assert len(found) == 7


def test_points_are_those_of_halton_in_the_box():
    found = factors(settings(members=40))
    drawn = np.array([list(found[f"box_{i:03d}"].values()) for i in range(1, 41)])
    low, high = np.array([[BOX[name][end] for name in PLACES] for end in ("low", "high")])
    expected = qmc.Halton(len(PLACES), scramble=False).random(41)[1:]
    assert drawn == pytest.approx(low + expected * (high - low), abs=1e-14)


def test_more_members_leave_those_before_them():
    few, many = factors(settings(members=3)), factors(settings(members=9))
    assert {name: many[name] for name in few} == few
    assert len(many) == len(few) + 6


def test_points_fill_the_box_more_evenly_than_chance():
    points = np.array([[radical_inverse(i, base) for base in (2, 3, 5, 7)] for i in range(1, 33)])
    chance = [qmc.discrepancy(np.random.default_rng(seed).random((32, 4))) for seed in range(20)]
    assert qmc.discrepancy(points) < min(chance)


def test_overrides_scale_values_and_pairs_of_values():
    config = {
        "onsets": settings(bore_radius={"low": 0.5, "high": 2.0}),
        "dynamics": {"damping_ratio": 0.08, "tolerance": 1e-10},
        "gear_pair": {"bore_radius": {"pinion": 0.01, "gear": 0.03}},
        "operation": {"pinion_torque": 100.0},
        "lubricant": {"pressure_viscosity": 2e-8},
    }
    found = overrides(config)
    assert found["bore_radius_high"] == {
        "dynamics": {"damping_ratio": 0.08},
        "gear_pair": {"bore_radius": {"pinion": 0.02, "gear": 0.06}},
        "operation": {"pinion_torque": 100.0},
        "lubricant": {"pressure_viscosity": 2e-8},
    }
    assert found["damping_ratio_low"]["dynamics"] == {"damping_ratio": pytest.approx(0.072)}
