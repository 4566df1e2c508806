"""Heat balance: limits, an integral along the path, similarity of the oil flow and published magnitudes."""

import math

import numpy as np
import pytest

from gearwear.geometry.kinematics import angular_speed, mesh_force, surface_speed
from gearwear.heat.balance import (
    Gear,
    HeatFlows,
    balanced,
    churning_torque,
    heat_flows,
    loss_factor,
    mean_friction,
    surface,
)

OPERATION = {"pinion_torque": 130.0, "pinion_speed": 3000.0}
OIL = {
    "viscosity_law": "vogel",
    "dynamic_viscosity": 0.0094,
    "dynamic_viscosity_40": 0.0885,
    "composite_roughness": 0.5e-6,
}
SETTINGS = {
    "surroundings": 40.0,
    "heat_transfer": 100.0,
    "area": None,
    "immersion": {"pinion": 0.0, "gear": 10e-3},
    "oil_volume": 1e-3,
    "oil_density": 870.0,
}
WHEEL = Gear(60e-3, 20e-3, 15e-3, 100.0, 25e-3)


def constant(mesh, churning, conductance, surroundings=40.0):
    return lambda temperature: HeatFlows(mesh, churning, conductance * (temperature - surroundings))


def test_without_losses_the_gears_are_as_warm_as_their_surroundings():
    assert balanced(constant(0.0, 0.0, 5.0), 40.0) == 40.0


def test_constant_losses_heat_by_loss_over_conductance_so_that_twice_of_it_halves_the_rise():
    assert balanced(constant(200.0, 50.0, 5.0), 40.0) == pytest.approx(90.0, rel=1e-14)
    assert balanced(constant(200.0, 50.0, 10.0), 40.0) == pytest.approx(65.0, rel=1e-14)


def test_losses_that_nothing_carries_away_have_no_balance():
    with pytest.raises(ValueError, match="no balance of heat below"):
        balanced(constant(200.0, 0.0, 1e-3), 40.0)


@pytest.mark.parametrize("immersion", [0.0, 10e-3, 70e-3])
def test_powers_are_equal_where_the_balance_closes(benchmark_pair, immersion):
    settings = SETTINGS | {"immersion": {"pinion": 0.0, "gear": immersion}}

    def flows(temperature):
        return heat_flows(benchmark_pair, temperature, OPERATION, OIL, settings)

    found = flows(balanced(flows, 40.0))
    assert found.mesh_loss + found.churning_loss == pytest.approx(found.convection, rel=1e-9)
    assert (found.churning_loss > 0) == (immersion > 0)


@pytest.mark.parametrize("teeth, shift", [((19, 48), (0.0, 0.0)), ((25, 25), (0.0, 0.0)), ((16, 60), (0.5, -0.5))])
def test_mesh_loss_is_the_integral_of_friction_times_sliding(make_geometry, teeth, shift):
    """Second method, pairs carrying half of the load each; the last pair has its pitch point in double contact."""
    geometry = make_geometry(teeth, bore=(8e-3, 10e-3), shift=shift, mesh_cells=2000)
    found = heat_flows(geometry, 60.0, OPERATION, OIL, SETTINGS)
    force, speed = mesh_force(geometry, OPERATION["pinion_torque"]), surface_speed(geometry, OPERATION["pinion_speed"])
    at_pitch = speed[:, np.argmin(abs(speed[0] - speed[1]))]
    path, line = float(geometry["pitch_point"]), float(geometry["line_of_action"])
    viscosity = 0.0094 * math.exp(math.log(0.0885 / 0.0094) / (1 / 135 - 1 / 195) * (1 / 155 - 1 / 195))
    width = float(geometry["face_width"])
    friction = mean_friction(force / width, at_pitch.sum(), path * (line - path) / line, viscosity, 0.5e-6)
    load = force * np.where(geometry["partner"].values < 0, 1.0, 0.5)
    heat = friction * load * abs(speed[0] - speed[1])
    steps = np.diff(geometry["path"].values)
    integral = (steps * (heat[1:] + heat[:-1]) / 2).sum() / float(geometry["base_pitch"])
    assert found.mesh_loss == pytest.approx(integral, rel=1e-6)


def test_loss_factor_of_the_gears_of_the_fzg_rig(make_geometry):
    """Type C, 16 and 24 teeth of module 4.5: 0.195 in the literature of the rig, tips as in its drawings."""
    geometry = make_geometry(
        (16, 24), 4.5e-3, 14e-3, bore=(10e-3, 15e-3), shift=(0.1817, 0.1715), centre_distance=91.5e-3
    )
    pitch, tips = float(geometry["base_pitch"]), np.array([82.46e-3, 118.36e-3]) / 2
    reach = np.sqrt(tips**2 - geometry["base_radius"].values ** 2)
    pinion = (reach[0] - float(geometry["pitch_point"])) / pitch
    gear = (reach[1] - float(geometry["line_of_action"]) + float(geometry["pitch_point"])) / pitch
    assert loss_factor(16, 1.5, pinion, gear) == pytest.approx(0.195, abs=0.005)


def test_friction_is_of_the_size_of_mixed_lubrication_and_has_the_exponents_of_its_source():
    usual = (3e5, 8.0, 8e-3, 0.02, 0.5e-6)
    assert 0.03 < mean_friction(*usual) < 0.07
    for place, exponent in enumerate((0.2, -0.2, -0.2, -0.05, 0.25)):
        doubled = [2 * one if i == place else one for i, one in enumerate(usual)]
        assert mean_friction(*doubled) == pytest.approx(2**exponent * mean_friction(*usual), rel=1e-12)


@pytest.mark.parametrize("viscosity", [0.2, 0.009, 0.002])
def test_churning_obeys_similarity(viscosity):
    """Lengths fourfold at equal Froude and Reynolds numbers: speeds half, nu eightfold, torque 4^5/4."""
    large = Gear(*(4 * one for one in WHEEL[:3]), WHEEL.speed / 2, 4 * WHEEL.immersion)
    small = churning_torque(WHEEL, viscosity, 870.0, 2e-3)
    assert churning_torque(large, 8 * viscosity, 870.0, 64 * 2e-3) == pytest.approx(256 * small, rel=1e-12)


def test_churning_is_continuous_where_its_fits_meet():
    reynolds = WHEEL.speed * WHEEL.tip_radius * WHEEL.face_width * 870.0
    for limit in (6000.0, 9000.0):
        sides = [churning_torque(WHEEL, reynolds / (limit * (1 + side)), 870.0, 2e-3) for side in (-1e-9, 1e-9)]
        assert sides[0] == pytest.approx(sides[1], rel=1e-6)


def test_dry_gears_and_gears_at_rest_churn_nothing_and_deeper_ones_more():
    assert churning_torque(WHEEL._replace(immersion=0.0), 0.02, 870.0, 2e-3) == 0
    assert churning_torque(WHEEL._replace(speed=0.0), 0.02, 870.0, 2e-3) == 0
    torques = [
        churning_torque(WHEEL._replace(immersion=depth), 0.02, 870.0, 2e-3) for depth in (5e-3, 20e-3, 60e-3, 0.12)
    ]
    assert torques == sorted(torques)
    assert churning_torque(WHEEL._replace(immersion=1.0), 0.02, 870.0, 2e-3) == torques[-1]


def test_churning_torque_of_a_published_gear_is_a_few_newton_metres():
    """72 teeth of 3 mm at 4500 rpm, 54 mm deep: Luke and Olver (1999) call 75 N m far too much, 5 N m the other end."""
    gear = Gear(111e-3, 20e-3, 20e-3, 4500 * math.pi / 30, 54e-3)
    assert 0.3 < churning_torque(gear, 0.02, 870.0, 10e-3) < 5


def test_surface_is_that_of_two_rings():
    ring = 2 * math.pi * (60e-3**2 - 20e-3**2) + 2 * math.pi * 60e-3 * 15e-3
    assert surface([WHEEL, WHEEL]) == pytest.approx(2 * ring)


def test_more_load_speed_and_oil_heat_more_and_a_given_area_replaces_that_of_the_gears(benchmark_pair):
    usual = heat_flows(benchmark_pair, 60.0, OPERATION, OIL, SETTINGS)
    loaded = heat_flows(benchmark_pair, 60.0, OPERATION | {"pinion_torque": 260.0}, OIL, SETTINGS)
    assert loaded.mesh_loss == pytest.approx(2**1.2 * usual.mesh_loss)
    assert loaded.churning_loss == usual.churning_loss
    given = heat_flows(benchmark_pair, 60.0, OPERATION, OIL, SETTINGS | {"area": 0.5})
    assert given.convection == pytest.approx(100.0 * 0.5 * 20.0)
    pair_speed = angular_speed(benchmark_pair, OPERATION["pinion_speed"])
    assert 0.002 < usual.mesh_loss / (130.0 * pair_speed[0]) < 0.02
