"""Reading of single values, plain results, and messages that never turn into other exceptions."""

import copy
import random
from collections import OrderedDict
from pathlib import Path

import pytest
import yaml

from gearwear.config.check import ConfigError, check
from gearwear.config.study import Configuration
from gearwear.config.types import keys

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture
def raw():
    return yaml.safe_load((ROOT / "config/config.yaml").read_text(encoding="utf-8"))


def put(raw, path, value):
    *way, last = path.split(".")
    for key in way:
        raw = raw[key]
    raw[last] = value


def get(values, path):
    for key in path.split("."):
        values = values[key]
    return values


def plain(value):
    if type(value) is dict:
        return all(type(key) is str and plain(item) for key, item in value.items())
    return all(map(plain, value)) if type(value) is list else type(value) in (int, float, str, bool, type(None))


def test_the_default_study_becomes_plain_values_in_the_order_of_the_models(raw):
    values = check(OrderedDict(reversed(raw.items())))
    assert plain(values)
    assert list(values) == list(Configuration.model_fields)
    assert list(values["wear"]) == list(Configuration.model_fields["wear"].annotation.model_fields)
    assert list(values["cases"]) == list(raw["cases"])
    assert check(values) == values


def test_the_input_is_left_as_it_was(raw):
    before = copy.deepcopy(raw)
    check(raw)
    assert raw == before


@pytest.mark.parametrize(
    ("path", "written", "read"),
    [
        ("lubricant.pressure_viscosity", "1e-8", 1e-8),
        ("lubricant.pressure_viscosity", " 2.5E-8 ", 2.5e-8),
        ("operation.pinion_torque", 130, 130.0),
        ("operation.pinion_torque", ".5", 0.5),
        ("operation.pinion_torque", "0.13 kN m", 130.0),
        ("material.gear.youngs_modulus", "206 GPa", 206.0e9),
        ("gear_pair.centre_distance", "165.1 mm", 0.1651),
        ("cases.with.bulk_temperature", "373.15 K", 100.0),
        ("maps.temperature", ["20 degC", "353.15 K", 100], [20.0, 80.0, 100.0]),
        ("wear.cycles_per_update", "1e8", 100_000_000),
        ("wear.cycles_per_update", 1.0e8, 100_000_000),
        ("grid.mesh_cells", 24.0, 24),
        ("grid.mesh_cells", "24", 24),
        ("dynamics.harmonics", "full", "full"),
        ("dynamics.harmonics", "3", 3),
        ("gear_pair.centre_distance", None, None),
        ("gear_pair.centre_distance", "null", None),
        ("gear_pair.centre_distance", "0.1064", 0.1064),
        ("gear_pair.inertia.gear", 1, 1.0),
        ("mesh_stiffness.profile_changes", False, "off"),
        ("cases.with.flash", "false", False),
        ("portraits.ste.with", ["1e0", 2], [1.0, 2.0]),
    ],
)
def test_spellings_of_yaml_and_the_command_line_are_read(raw, path, written, read):
    put(raw, path, written)
    value = get(check(raw), path)
    assert value == read
    assert type(value) is type(read)


@pytest.mark.parametrize(
    "value", [True, float("nan"), float("inf"), "nan", "inf", "1_0", "0,5", "", None, [20.0], 10**400]
)
def test_what_is_no_finite_number_is_refused(raw, value):
    put(raw, "gear_pair.pressure_angle", value)
    with pytest.raises(ConfigError, match=r"gear_pair\.pressure_angle: .* is not a (finite )?number; give a number"):
        check(raw)


@pytest.mark.parametrize("value", [3.5, "3.5", True, "many", None, {}])
def test_what_is_no_whole_number_is_refused(raw, value):
    put(raw, "settling.sampled_periods", value)
    with pytest.raises(ConfigError, match=r"settling\.sampled_periods: .* is not a whole number; give"):
        check(raw)


def test_all_problems_stand_in_one_message_in_the_order_of_the_models(raw):
    put(raw, "sweeps.ste.points", 1)
    put(raw, "dynamics.dampng_ratio", 0.1)
    put(raw, "wear.coefficient", "abc")
    with pytest.raises(ConfigError) as caught:
        check(raw)
    assert str(caught.value) == (
        "configuration: 3 problems\n"
        "  wear.coefficient: text 'abc' is not a number; give a number from 0 to 1.0e-9 m2/N\n"
        "  dynamics.dampng_ratio: unknown key (did you mean dynamics.damping_ratio?)\n"
        "  sweeps.ste.points: 1 is below the least allowed value 2; give a whole number from 2 to 20001"
    )


def test_rules_between_keys_are_checked_beside_bad_keys(raw):
    put(raw, "wear.coefficient", "abc")
    put(raw, "cases.with.running_cycles", 2.05e9)
    with pytest.raises(ConfigError) as caught:
        check(raw)
    assert "\n  wear.coefficient: " in str(caught.value)
    assert "\n  cases.with.running_cycles: 2.05e+9 is not a whole multiple" in str(caught.value)


def test_a_bad_value_of_several_types_leaves_the_rest_of_its_section_to_the_rules(raw):
    put(raw, "cases.with.bulk_temperature", float("nan"))
    put(raw, "cases.with.running_cycles", 2.05e9)
    with pytest.raises(ConfigError, match="configuration: 2 problems") as caught:
        check(raw)
    assert "\n  cases.with.running_cycles: 2.05e+9 is not a whole multiple" in str(caught.value)


def test_a_case_that_is_no_section_keeps_its_name(raw):
    put(raw, "cases.with", 3)
    with pytest.raises(ConfigError, match="configuration: 1 problem\n  cases.with: 3 is not a section"):
        check(raw)


def test_rules_between_keys_pass_over_values_that_are_bad_themselves(raw):
    put(raw, "wear.cycles_per_update", "abc")
    put(raw, "sweeps.ste.last", "abc")
    put(raw, "heat.initial_temperature", None)
    with pytest.raises(ConfigError, match="configuration: 3 problems"):
        check(raw)


def test_no_input_raises_anything_but_a_configuration_error(raw):
    chance = random.Random(7)
    names = [part for path, _ in keys(Configuration) for part in path] + ["", "a\nb", "{ge}", "\ud800", "[0]"]
    endless = {"cases": None}
    endless["cases"] = endless["wear"] = [endless]
    deep = []
    for _ in range(3000):
        deep = [deep]
    atoms = [
        None,
        True,
        0,
        -1,
        3.5,
        10**5000,
        float("nan"),
        "1e-8",
        "abc",
        "\ud800",
        b"x",
        (1,),
        endless,
        deep,
    ]

    def anything(depth=0):
        kind = chance.random()
        if depth > 3 or kind < 0.5:
            return chance.choice(atoms)
        if kind < 0.7:
            return [anything(depth + 1) for _ in range(chance.randrange(4))]
        return {chance.choice([*names, None, 1, 2.5]): anything(depth + 1) for _ in range(chance.randrange(5))}

    def spoil(tree):
        key = chance.choice(list(tree))
        if isinstance(tree[key], dict) and tree[key] and chance.random() < 0.8:
            spoil(tree[key])
        else:
            tree[chance.choice([key, chance.choice(names)])] = anything()

    refused = 0
    for _ in range(400):
        spoiled = copy.deepcopy(raw)
        for _ in range(chance.randrange(1, 6)):
            spoil(spoiled)
        for candidate in (spoiled, anything()):
            try:
                assert plain(check(candidate))
            except ConfigError as error:
                refused += 1
                head, *lines = str(error).encode().decode().split("\n")
                assert head.startswith("configuration: ") and lines
                assert all(line.startswith("  ") for line in lines), error
    assert refused > 700
