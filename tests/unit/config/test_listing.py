from pathlib import Path

import yaml

from gearwear.config import check, listing, origins

ROOT = Path(__file__).resolve().parents[3]


def listed(changes=None):
    text = (ROOT / "config" / "config.yaml").read_text()
    config = check.check(yaml.safe_load(text) | (changes or {}))
    layers = [origins.file_layer("config.yaml", text), origins.command_line_layer(changes or {})]
    rows = list(listing.rows(config, layers))
    found = {key: rest for key, *rest in rows}
    assert len(found) == len(rows)
    return config, found


def values_of(config, path=()):
    """Yield dotted key and value of everything that is no section."""
    for name, value in config.items():
        if isinstance(value, dict):
            yield from values_of(value, (*path, name))
        else:
            yield ".".join((*path, name)), value


def test_every_value_of_the_configuration_is_listed_once():
    config, rows = listed()
    assert set(rows) == {key for key, _ in values_of(config)}


def test_rows_hold_value_unit_origin_and_meaning():
    _, rows = listed()
    assert rows["material.gear.density"] == ["7850.0", "kg/m3", "field: case-hardening gear steel", "Density."]
    assert rows["cases.with.running_cycles"][:2] == ["2100000000", "1"]
    assert rows["backlash.projection"][:2] == ["shi", "-"]
    assert rows["gear_pair.centre_distance"][0] == "null"


def test_overrides_of_a_member_stand_in_one_row():
    overridden = {"cases": {"with": {"bulk_temperature": 120.0}}}
    _, rows = listed({"studies": {"heat": {"members": {"t120": overridden}}}})
    assert rows["studies.heat.members.t120"][0] == '{"cases": {"with": {"bulk_temperature": 120.0}}}'
    assert rows["studies.heat.members.t120"][2] == "command line"
