"""Values that follow from the gear pair."""

import copy
from pathlib import Path

import pytest
import yaml

from gearwear.config.check import ConfigError, check
from gearwear.config.derived import RULES, resolved
from gearwear.config.members import members, merged
from gearwear.config.parameters import PLACES
from gearwear.config.tree import value_at

ROOT = Path(__file__).resolve().parents[3]


def load(name):
    return yaml.safe_load((ROOT / "config" / name).read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def own():
    return merged(load("config.yaml"), load("own_pair.yaml"))


def test_the_default_study_leaves_nothing_open():
    values = check(load("config.yaml"))
    assert resolved(values) == values
    assert all(value_at(load("config.yaml"), key) is not None for key in RULES)


def test_the_own_pair_states_five_values_and_leaves_the_rest_open(own):
    stated = {
        "gear_pair.teeth.pinion",
        "gear_pair.teeth.gear",
        "gear_pair.module",
        "gear_pair.face_width",
        "operation.pinion_torque",
        "operation.pinion_speed",
    }

    def leaves(section, path=""):
        for name, value in section.items():
            yield from leaves(value, f"{path}{name}.") if isinstance(value, dict) else [(path + name, value)]

    overlay = dict(leaves(load("own_pair.yaml")))
    assert {key for key, value in overlay.items() if value is not None} == stated | {"figures.claims"}
    assert {key for key, value in overlay.items() if value is None} == set(RULES)


def test_every_open_value_becomes_a_number(own):
    before = copy.deepcopy(own)
    values = check(own)
    assert own == before
    assert all(isinstance(value_at(values, key), float) for key in RULES)
    assert check(values) == values


def test_the_bores_follow_from_the_root_circles(own):
    own = merged(own, {"gear_pair": {"profile_shift": {"pinion": 0.2, "gear": 0.0}}})
    bores = check(own)["gear_pair"]["bore_radius"]
    # root diameters d - 2 (h_a + c - x) m of 25 and 41 teeth: 91.6 mm and 154 mm
    assert bores == {"pinion": pytest.approx(0.45 * 45.8e-3, rel=1e-3), "gear": pytest.approx(0.45 * 77e-3, rel=1e-3)}


@pytest.mark.parametrize(
    ("module", "centre", "least"), [(3e-3, 0.1, 0.14e-3), (3e-3, 0.2, 0.17e-3), (5e-3, 0.2, 0.21e-3)]
)
def test_the_backlash_is_that_of_the_standard(own, module, centre, least):
    """The table of ISO/TR 10064-2 is the formula, rounded to 0.01 mm."""
    teeth = round(2 * centre / module)
    pair = {"teeth": {"pinion": 20, "gear": teeth - 20}, "module": module}
    half = check(merged(own, {"gear_pair": pair}))["backlash"]["half_backlash"]
    assert 2 * half == pytest.approx(least, abs=0.0075e-3)


def test_a_given_value_is_kept_and_its_range_follows_it(own):
    values = check(merged(own, {"backlash": {"half_backlash": "50 um"}}))
    assert values["backlash"]["half_backlash"] == 50e-6
    assert values["sensitivity"]["half_backlash"] == {"low": 25e-6, "high": 62.5e-6}


def test_every_range_encloses_its_value(own):
    values = check(own)
    for name, key in PLACES.items():
        ends = values["sensitivity"][name]
        assert ends["low"] < value_at(values, key) < ends["high"] or name in ("damping_ratio", "pressure_viscosity"), (
            name
        )


def test_a_member_keeps_the_derived_values_of_its_study_unless_it_opens_them(own):
    overrides = {
        "kept": {"gear_pair": {"module": "5 mm"}},
        "open": {"gear_pair": {"module": "5 mm", "bore_radius": {"pinion": None, "gear": None}}},
    }
    found = members(check(own | {"studies": {"modules": {"members": overrides}}}))
    bores = {name: found[f"studies/modules/{name}/"]["gear_pair"]["bore_radius"] for name in overrides}
    assert bores["kept"] == check(own)["gear_pair"]["bore_radius"]
    assert bores["open"]["pinion"] == pytest.approx(1.25 * bores["kept"]["pinion"], rel=1e-3)


def test_a_bad_value_stops_before_anything_is_derived(own):
    with pytest.raises(ConfigError) as caught:
        check(merged(own, {"gear_pair": {"module": "4 kg"}}))
    assert str(caught.value).count("\n") == 1
