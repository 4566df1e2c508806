"""What each stage may read of the configuration."""

import copy
import json
from pathlib import Path

import pytest
import yaml

from gearwear.config.slices import STAGES, slice_of

ROOT = Path(__file__).resolve().parents[3]
BY_NAME = ("sweep", "branches", "portraits", "motions", "basins", "prescribed_excitation")
CHAIN = ("temperature", "deformation", "mesh_excitation", "response", "wear", "excitation", "sweep", "case_onsets")
IN_ONE_PROCESS = {"measures", "calibration", "wear_history", "member_onsets", "outcome", "study"}
MAPS = {"map_ste", "map_backlash", "temperature_map_tile", "map_wear"}


@pytest.fixture
def config():
    config = yaml.safe_load((ROOT / "config" / "config.yaml").read_text())
    return config | {"oscillators": {name: {"mean_force": 0.1} for name in config["cases"]}}


def cut(config, stage, case="with", sweep="backlash"):
    return slice_of(config, stage, case, sweep)


def leaves(tree, prefix=()):
    for key, value in tree.items():
        if isinstance(value, dict):
            yield from leaves(value, (*prefix, key))
        else:
            yield (*prefix, key)


def changed(config, keys):
    """Return a copy with another value at `keys`."""
    other = copy.deepcopy(config)
    section = other
    for key in keys[:-1]:
        section = section[key]
    section[keys[-1]] = "changed"
    return other


@pytest.mark.parametrize("stage", STAGES)
def test_slice_is_plain_data_with_sorted_keys(config, stage):
    found = cut(config, stage)
    assert json.dumps(found) == json.dumps(found, sort_keys=True)
    assert json.loads(json.dumps(found)) == found


@pytest.mark.parametrize("stage", STAGES)
def test_slice_does_not_depend_on_the_order_of_keys_and_leaves_the_configuration_alone(config, stage):
    def turned(tree):
        return {key: turned(tree[key]) for key in reversed(tree)} if isinstance(tree, dict) else tree

    before = copy.deepcopy(config)
    assert list(leaves(cut(turned(config), stage))) == list(leaves(cut(config, stage)))
    assert config == before


@pytest.mark.parametrize(
    ("keys", "stages"),
    [
        ("gear_pair.module", {"geometry"}),
        ("grid.mesh_cells", {"geometry"}),
        ("micro_geometry.tip_relief.gear.amount", {"geometry"}),
        ("micro_geometry.base_pitch_difference", {"geometry"}),
        ("material.pinion.density", {"geometry", "temperature"}),
        ("material.gear.youngs_modulus", {"temperature", "wear", "mesh_excitation"}),
        ("material.gear.thermal_expansion", {"temperature", "deformation", "wear", "mesh_excitation"}),
        ("elasticity.law", {"temperature", "wear", "mesh_excitation"}),
        (
            "operation.pinion_torque",
            {"temperature", "mesh_excitation", "wear", "response", "excitation"} | MAPS,
        ),
        ("operation.pinion_speed", {"temperature", "wear", "response"}),
        ("lubricant.composite_roughness", {"temperature", "wear", "warnings"}),
        ("friction.dry", {"temperature"}),
        ("heat.flash_coefficient", {"temperature"}),
        ("heat.growth", {"deformation"}),
        ("mesh_stiffness.hertz", {"temperature", "mesh_excitation"}),
        ("transmission_error.mode", {"mesh_excitation"}),
        ("backlash.half_backlash", {"mesh_excitation"}),
        ("backlash.housing.temperature_rise", {"mesh_excitation"}),
        ("heat.initial_temperature", {"deformation", "mesh_excitation"}),
        ("wear.cycles_per_update", {"wear"}),
        ("dynamics.clearance", {"response", "excitation"} | MAPS),
        ("dynamics.start.at", {"response", "sweep", "case_onsets", "portraits"} | MAPS),
        (
            "dynamics.damping_ratio",
            {"response", "sweep", "branches", "case_onsets", "portraits", "motions", "basins"} | MAPS,
        ),
        ("oscillators.with.mean_force", {"prescribed_excitation"}),
        ("oscillators.without.mean_force", set()),
        ("settling.largest_period", {"response", "sweep", "case_onsets", "portraits", "basins"} | MAPS),
        ("cases.with.bulk_temperature", {"temperature", "deformation", "wear", "mesh_excitation"}),
        ("cases.with.flash", {"temperature"}),
        ("cases.with.running_cycles", set()),
        ("cases.without.bulk_temperature", set()),
        ("sweeps.backlash.points", {"sweep"}),
        ("sweeps.backlash.first", {"sweep", "branches"}),
        ("sweeps.backlash.mesh_frequency", {"sweep", "branches", "portraits", "motions", "basins"}),
        ("sweeps.ste.points", set()),
        ("sweeps.backlash.cases", set()),
        ("sweeps.order", {"case_onsets", "onset_shifts"}),
        ("onsets.refinement", {"case_onsets"}),
        ("onsets.members", {"onset_shifts"}),
        ("sensitivity.damping_ratio.low", {"sensitivity_comparison"}),
        ("calibration.islands", set()),
        ("onsets.box.bore_radius.low", {"onset_shifts"}),
        ("branches.largest_period", {"branches"}),
        ("portraits.backlash.with", {"portraits"}),
        ("portraits.ste.with", set()),
        ("basins.points.backlash.with", {"basins"}),
        ("basins.points.ste.with", set()),
        ("basins.displacement.first", {"basins"}),
        ("basins.resolution", {"basins"}),
        ("portraits.mesh_frequency.without", set()),
        ("figures.diagonal", set()),
        ("maps.case", set()),
        ("dynamics.stiffness", {"response", "excitation", "handover_dataset"} | MAPS),
        ("maps.mesh_frequency.points", MAPS),
        ("maps.temperature", {"temperature_map_tile"}),
        ("sweeps.backlash.reading", {"sweep", "branches", "portraits", "motions", "map_backlash", "basins"}),
    ],
)
def test_a_key_reaches_its_stages_and_no_other(config, keys, stages):
    other = changed(config, keys.split("."))
    reached = {stage for stage in STAGES if cut(other, stage) != cut(config, stage)}
    assert reached - IN_ONE_PROCESS == stages


@pytest.mark.parametrize(
    ("keys", "reached"),
    [
        ("gear_pair.module", {"measures", "calibration", "wear_history", "member_onsets"}),
        ("dynamics.damping_ratio", {"measures", "calibration", "wear_history", "member_onsets", "outcome"}),
        ("operation.pinion_speed", {"measures", "calibration", "wear_history", "member_onsets", "outcome"}),
        ("cases.with.bulk_temperature", {"measures", "calibration", "wear_history", "member_onsets"}),
        ("cases.with.running_cycles", {"measures", "calibration", "member_onsets"}),
        # the reference
        ("cases.without.bulk_temperature", {"measures", "calibration", "wear_history", "member_onsets"}),
        ("cases.wear_only.bulk_temperature", set()),
        ("sweeps.mesh_frequency.points", {"measures", "calibration", "member_onsets", "outcome", "study"}),
        ("sweeps.mesh_frequency.cases", set()),
        ("sweeps.order", {"measures", "member_onsets", "outcome", "study"}),
        ("branches.largest_period", {"member_onsets"}),
    ],
)
def test_a_key_reaches_the_stages_that_run_a_whole_chain(config, keys, reached):
    other = changed(config, keys.split("."))
    assert {stage for stage in IN_ONE_PROCESS if cut(other, stage) != cut(config, stage)} == reached


@pytest.mark.parametrize("whole_chain", ["measures", "member_onsets"])
@pytest.mark.parametrize("stage", ("geometry", *CHAIN))
def test_stages_in_one_process_see_every_setting_of_the_chain(config, stage, whole_chain):
    measured = cut(config, whole_chain)
    for case in ("without", "with"):
        whole = measured | {"case": measured["cases"][case]}
        for keys in leaves(cut(config, stage, case, "mesh_frequency")):
            value = whole
            for key in keys:
                value = value[key]


def test_the_measures_see_no_other_sweep_and_no_other_case(config):
    before = cut(config, "measures")
    for keys in ("sweeps.backlash.reading", "cases.wear_only.bulk_temperature", "maps.case", "branches.largest_period"):
        assert cut(changed(config, keys.split(".")), "measures") == before
    config["dynamics"]["reference_case"] = "temperature_only"
    assert set(cut(config, "measures")["cases"]) == {"without", "with", "temperature_only"}


@pytest.mark.parametrize("stage", [stage for stage in STAGES if stage not in BY_NAME])
def test_stages_of_the_wear_chain_do_not_know_the_case_by_name(config, stage):
    config["cases"]["twin"] = dict(config["cases"]["with"])
    assert cut(config, stage, "twin") == cut(config, stage, "with")


def test_slices_of_the_stages_before_the_cases_need_no_case(config):
    assert slice_of(config, "geometry")["grid"] == {"mesh_cells": 240}
    assert slice_of(config, "unworn") == {}


def test_every_key_of_the_physics_reaches_a_stage(config):
    """The sections below are read by no stage but by the targets, jobs and figures, or named above."""
    reached = set()
    for stage in STAGES:
        for case in config["cases"]:
            for sweep in config["portraits"]:
                listed = {"portraits": config["portraits"], "basins": config["basins"]["points"]}.get(stage)
                if listed and case not in listed[sweep]:
                    continue
                reached |= {
                    ("cases", case, *keys[1:]) if keys[0] == "case" else keys
                    for keys in leaves(cut(config, stage, case, sweep))
                }
    only_targets = {("cases", case, "running_cycles") for case in config["cases"] if case not in ("without", "with")}
    only_targets |= {("sweeps", sweep, "cases") for sweep in config["portraits"]}
    only_targets |= {("figures", "diagonal"), ("figures", "claims"), ("maps", "case"), ("calibration", "islands")}
    assert set(leaves(config)) - reached == only_targets | {("jobs", "wear_cycles")}
