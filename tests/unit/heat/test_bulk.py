"""Bulk temperatures left to the heat balance."""

from pathlib import Path

import pytest
import yaml

from gearwear.config.check import ConfigError, check
from gearwear.config.members import members
from gearwear.heat.bulk import BALANCE, bulk_temperature, of_case, resolved

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture
def raw():
    return yaml.safe_load((ROOT / "config/config.yaml").read_text(encoding="utf-8"))


def test_given_temperatures_stay_as_they_are(raw):
    config = check(raw)
    assert resolved(config) is config


def test_cases_that_ask_for_a_balance_get_it_and_no_other(raw):
    raw["cases"]["with"]["bulk_temperature"] = BALANCE
    config = check(raw)
    found = resolved(config)
    assert found["cases"]["with"] == config["cases"]["with"] | {"bulk_temperature": bulk_temperature(config)}
    assert {name: case for name, case in found["cases"].items() if name != "with"} == {
        name: case for name, case in config["cases"].items() if name != "with"
    }
    assert config["cases"]["with"]["bulk_temperature"] == BALANCE
    assert check(found) == found


def test_balance_follows_load_speed_and_cooling(raw):
    def found(section, **changes):
        return bulk_temperature(check(raw | {section: raw[section] | changes}))

    usual = bulk_temperature(check(raw))
    assert raw["heat_balance"]["surroundings"] < usual < 120
    assert found("operation", pinion_torque=270.0) > usual
    assert found("operation", pinion_speed=1700.0) < usual
    assert found("heat_balance", heat_transfer=200.0) < usual
    warm = found("heat_balance", surroundings=60.0)
    assert warm == pytest.approx(usual + 20, abs=3)


def test_a_member_of_a_study_has_the_balance_of_its_own_load(raw):
    raw["cases"]["with"]["bulk_temperature"] = BALANCE
    raw["studies"] = {"load": {"members": {"heavy": {"operation": {"pinion_torque": 270.0}}}}}
    raw["maps"]["temperature"] = [60, 100]
    found = {root: resolved(one)["cases"]["with"]["bulk_temperature"] for root, one in members(check(raw)).items()}
    assert found["studies/load/heavy/"] > found[""] + 5
    assert found["studies/temperature/t100/"] == 100.0


def test_gears_that_do_not_mesh_are_named(raw):
    values = check(raw)
    values["gear_pair"]["centre_distance"] = 0.2
    number, hindrance = of_case(values, {"bulk_temperature": BALANCE})
    assert number is None and hindrance.startswith("balance: gear_pair: the contact ratio is")


def test_keys_that_are_missing_hinder_nothing_here(raw):
    values = check(raw)
    del values["lubricant"]["dynamic_viscosity"]
    assert of_case(values, {"bulk_temperature": BALANCE}) == (None, "")
    assert of_case(values, {}) == (None, "")


@pytest.mark.parametrize("section", ["gear_pair", "operation", "lubricant", "heat_balance"])
def test_a_balance_does_not_hide_which_key_is_missing(raw, section):
    raw["cases"]["with"]["bulk_temperature"] = BALANCE
    for key in list(raw[section]):
        value = raw[section].pop(key)
        with pytest.raises(ConfigError, match=f"{section}.{key}: missing"):
            check(raw)
        raw[section][key] = value
    raw[section] = None
    with pytest.raises(ConfigError, match=f"{section}: .* is not a section"):
        check(raw)


def test_without_a_balance_the_number_given_is_the_temperature(raw):
    values = check(raw)
    assert of_case(values, {"bulk_temperature": 55.0}) == (55.0, "")
