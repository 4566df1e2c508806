"""Force and speeds of the mesh against rigid-body kinematics."""

import math

import numpy as np
import pytest

from gearwear.geometry.kinematics import angular_speed, curvature, mesh_force, surface_speed


def test_mesh_force_balances_the_torque_on_the_base_circle(benchmark_pair):
    force = mesh_force(benchmark_pair, 130.0)
    assert force * 19 * 3.175e-3 / 2 * math.cos(math.radians(20)) == pytest.approx(130.0, rel=1e-12)


def test_angular_speeds_are_those_of_the_teeth_counts(benchmark_pair):
    pinion, gear = angular_speed(benchmark_pair, 6000)
    assert pinion == pytest.approx(200 * math.pi, rel=1e-12)
    assert 48 * gear == pytest.approx(19 * pinion, rel=1e-12)


def test_radii_of_curvature_share_the_line_of_action(benchmark_pair):
    radii, effective = curvature(benchmark_pair)
    np.testing.assert_allclose(radii.sum(axis=0), float(benchmark_pair["line_of_action"]))
    np.testing.assert_allclose(1 / effective, (1 / radii).sum(axis=0))
    assert (radii > 0).all()


def test_flanks_roll_without_sliding_only_at_the_pitch_point(benchmark_pair):
    speed = surface_speed(benchmark_pair, 6000)
    sliding = speed[0] - speed[1]
    pitch = benchmark_pair["path"].values == float(benchmark_pair["pitch_point"])
    assert pitch.sum() == 1
    assert abs(sliding[pitch]) < 1e-12 * speed.max()
    assert (sliding[benchmark_pair["path"] < benchmark_pair["pitch_point"]] < 0).all()
    assert (sliding[benchmark_pair["path"] > benchmark_pair["pitch_point"]] > 0).all()


def test_sliding_is_the_relative_rotation_about_the_pitch_point(benchmark_pair):
    speed = surface_speed(benchmark_pair, 6000)
    arm = benchmark_pair["path"].values - float(benchmark_pair["pitch_point"])
    np.testing.assert_allclose(speed[0] - speed[1], angular_speed(benchmark_pair, 6000).sum() * arm, atol=1e-12)


def test_both_flanks_move_at_one_speed_along_the_line_of_action(benchmark_pair):
    along_line = angular_speed(benchmark_pair, 6000) * benchmark_pair["base_radius"].values
    assert along_line[0] == pytest.approx(along_line[1], rel=1e-12)
