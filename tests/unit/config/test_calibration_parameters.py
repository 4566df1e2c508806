"""Parameters of a calibration and the keys they set."""

import numpy as np
import pytest

from gearwear.chain.geometry import geometry
from gearwear.config.calibration_parameters import NAMES, ends, values_of, with_values
from gearwear.geometry.kinematics import mesh_force, surface_speed


def changed(config, **values):
    own = dict(zip(NAMES, values_of(config), strict=True)) | values
    return with_values(config, np.array([own[name] for name in NAMES]))


def test_the_values_of_a_configuration_give_it_back(config):
    same = with_values(config, values_of(config))
    np.testing.assert_allclose(values_of(same), values_of(config), rtol=1e-12)
    assert same["gear_pair"]["teeth"] == config["gear_pair"]["teeth"]
    assert same["operation"]["pinion_torque"] == pytest.approx(config["operation"]["pinion_torque"], rel=1e-12)
    assert same["operation"]["pinion_speed"] == pytest.approx(config["operation"]["pinion_speed"], rel=1e-12)


def test_line_load_and_pitch_speed_are_those_of_the_pair_that_follows(config):
    other = changed(config, pinion_teeth=27.4, tooth_ratio=2.0, line_load=200e3, pitch_speed=15.0)
    pair = geometry(other)
    assert pair["teeth"].values.tolist() == [27, 54]
    force = mesh_force(pair, other["operation"]["pinion_torque"])
    assert force / float(pair["face_width"]) == pytest.approx(200e3, rel=1e-12)
    speed = surface_speed(pair, other["operation"]["pinion_speed"])
    at_pitch = np.argmin(np.abs(pair["path"].values - float(pair["pitch_point"])))
    rolling = 15.0 * np.sin(np.radians(20.0))
    np.testing.assert_allclose(speed[:, at_pitch], rolling, rtol=1e-12)


def test_bores_follow_the_reference_radii(config):
    other = changed(config, pinion_teeth=30, tooth_ratio=1.5, pinion_bore=0.3, gear_bore=0.5)
    module = config["gear_pair"]["module"]
    assert other["gear_pair"]["bore_radius"] == pytest.approx(
        {"pinion": 0.3 * 15 * module, "gear": 0.5 * 22.5 * module}
    )


def test_nothing_else_changes(config):
    other = changed(config, damping_ratio=0.06, composite_roughness=0.4e-6)
    assert other["dynamics"] == {**config["dynamics"], "damping_ratio": 0.06}
    assert other["lubricant"]["composite_roughness"] == 0.4e-6
    assert other["cases"] == config["cases"] and other["sweeps"] == config["sweeps"]


def test_every_parameter_has_a_range(config):
    low, high = ends(config["calibration"])
    assert len(low) == len(high) == len(NAMES)
    assert (low <= high).all()
