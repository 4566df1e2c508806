"""Where the values of a configuration come from."""

from pathlib import Path

import pytest
import yaml

from gearwear.config.check import check
from gearwear.config.origins import command_line_layer, file_layer, origin, rows

ROOT = Path(__file__).resolve().parents[3]

CONFIG = ROOT / "config"
DEFAULT = file_layer("config.yaml", (CONFIG / "config.yaml").read_text(encoding="utf-8"))
OWN = file_layer("own_pair.yaml", (CONFIG / "own_pair.yaml").read_text(encoding="utf-8"))
TURBO = """
operation: {pinion_torque: 80 N m}   # field: turbo gear
lubricant:                           # oil 32; field: data sheet
  dynamic_viscosity: 5 mPa s
  pressure_viscosity: 16 1/GPa       # 1/Pa; choice
cases: {with: {bulk_temperature: 120}}
"""


@pytest.mark.parametrize(
    ("key", "expected"),
    [
        ("gear_pair.module", "field: the common stiffness benchmark pair"),
        ("gear_pair.teeth.gear", "fit: snakemake -j2 calibrate; see docs/calibration.md"),
        ("gear_pair.profile_shift.pinion", "field: unshifted pair"),
        ("material.pinion.density", "field: case-hardening gear steel"),
        ("cases.with.bulk_temperature", "text"),
        ("cases.n0700_t060.flash", "choice: Figs 6-11"),
        ("portraits.ste.with", "text"),
        ("sensitivity.damping_ratio.low", "default"),
        ("wear.law", "default"),
    ],
)
def test_the_comments_of_the_default_file_tell_the_source(key, expected):
    assert origin(tuple(key.split(".")), [DEFAULT]) == expected


def test_an_overlay_is_named_with_the_source_it_tells():
    layers = [DEFAULT, file_layer("turbo.yaml", TURBO)]
    assert origin(("operation", "pinion_torque"), layers) == "turbo.yaml: field: turbo gear"
    assert origin(("lubricant", "dynamic_viscosity"), layers) == "turbo.yaml: field: data sheet"
    assert origin(("lubricant", "pressure_viscosity"), layers) == "turbo.yaml: choice"
    assert origin(("cases", "with", "bulk_temperature"), layers) == "turbo.yaml"
    assert origin(("cases", "with", "flash"), layers) == "text"


def test_what_the_own_pair_leaves_open_is_derived():
    layers = [DEFAULT, OWN]
    assert origin(("gear_pair", "module"), layers) == "own_pair.yaml"
    assert origin(("gear_pair", "bore_radius", "gear"), layers) == "derived: 0.45 of the root radius (choice)"
    assert origin(("sensitivity", "pinion_torque", "low"), layers) == (
        "derived: 0.8 times operation.pinion_torque (choice)"
    )
    assert origin(("gear_pair", "inertia", "gear"), layers) == "default"


def test_the_command_line_comes_last():
    given = {"backlash": {"half_backlash": "50 um"}, "gear_pair": {"bore_radius": {"gear": "null"}}}
    layers = [DEFAULT, OWN, command_line_layer(given)]
    assert origin(("backlash", "half_backlash"), layers) == "command line"
    assert origin(("gear_pair", "bore_radius", "gear"), layers).startswith("derived: ")
    assert origin(("operation", "pinion_speed"), layers) == "own_pair.yaml"


def test_a_section_that_yaml_merges_in_counts_as_set():
    text = "base: &steel {density: 7800.0}\nmaterial: {pinion: {<<: *steel}, gear: {<<: [*steel]}}\n"
    layers = [DEFAULT, file_layer("mine.yaml", text)]
    assert origin(("material", "pinion", "density"), layers) == "mine.yaml"
    assert origin(("material", "gear", "density"), layers) == "mine.yaml"
    assert origin(("material", "gear", "poisson_ratio"), layers).startswith("field")


@pytest.mark.parametrize("text", ["", "# nothing yet\n", "[]"])
def test_a_file_that_sets_nothing(text):
    layers = [DEFAULT, file_layer("empty.yaml", text)]
    assert origin(("backlash", "half_backlash"), layers).startswith("text: mean initial backlash")


def listed(changes=None):
    text = (ROOT / "config" / "config.yaml").read_text()
    config = check(yaml.safe_load(text) | (changes or {}))
    layers = [file_layer("config.yaml", text), command_line_layer(changes or {})]
    found = {key: rest for key, *rest in rows(config, layers)}
    assert len(found) == len(list(rows(config, layers)))
    return config, found


def values_of(config, path=()):
    """Yield dotted key and value of everything that is no section."""
    for name, value in config.items():
        if isinstance(value, dict):
            yield from values_of(value, (*path, name))
        else:
            yield ".".join((*path, name)), value


def test_every_value_of_the_configuration_is_listed_once():
    config, found = listed()
    assert set(found) == {key for key, _ in values_of(config)}


def test_rows_hold_value_unit_origin_and_meaning():
    _, found = listed()
    assert found["material.gear.density"] == ["7850.0", "kg/m3", "field: case-hardening gear steel", "Density."]
    assert found["cases.with.running_cycles"][:2] == ["2100000000", "1"]
    assert found["backlash.projection"][:2] == ["shi", "-"]
    assert found["gear_pair.centre_distance"][0] == "null"


def test_overrides_of_a_member_stand_in_one_row():
    overridden = {"cases": {"with": {"bulk_temperature": 120.0}}}
    _, found = listed({"studies": {"heat": {"members": {"t120": overridden}}}})
    assert found["studies.heat.members.t120"][0] == '{"cases": {"with": {"bulk_temperature": 120.0}}}'
    assert found["studies.heat.members.t120"][2] == "command line"
