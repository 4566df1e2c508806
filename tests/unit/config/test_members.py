"""Members of studies: what they override, what they keep, and bad overrides."""

import copy
from pathlib import Path

import pytest
import yaml

from gearwear.config.check import ConfigError, check
from gearwear.config.members import combinations, members, overrides_of, refusal, slug
from gearwear.config.tree import merged

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture
def study():
    """Return a function that gives the checked default study with the studies named."""
    raw = yaml.safe_load((ROOT / "config" / "config.yaml").read_text(encoding="utf-8"))

    def of(**studies):
        raw["maps"]["temperature"] = [40, 60.5]
        raw["onsets"]["members"] = 1
        for name in ("bore_radius", "pinion_torque", "pressure_viscosity"):
            raw["onsets"]["box"][name] = {"low": 1, "high": 1}
        return check(raw | {"studies": {name: {"members": table} for name, table in studies.items()}})

    return of


MAPPED = ["studies/temperature/t40/", "studies/temperature/t60_5/"]
ENSEMBLE = [f"studies/onsets/{name}/" for name in ("damping_ratio_low", "damping_ratio_high", "box_001")]


def named(found):
    """Return the folders of the members but those of the sensitivity, which has tests of its own."""
    return [root for root in found if not root.startswith("studies/sensitivity/")]


def test_the_study_itself_is_the_first_and_only_one_without_members(study):
    config = study()
    found = members(config)
    assert named(found) == ["", *MAPPED, *ENSEMBLE]
    assert found[""] == config


def test_every_temperature_of_the_map_is_a_member(study):
    found = members(study())
    assert [found[root]["cases"]["with"]["bulk_temperature"] for root in MAPPED] == [40.0, 60.5]


def test_the_ensemble_of_the_onsets_has_its_members(study):
    config = study()
    found = [members(config)[root] for root in ENSEMBLE]
    damping = config["dynamics"]["damping_ratio"]
    assert [one["dynamics"]["damping_ratio"] / damping for one in found] == pytest.approx([0.9, 1.1, 1.0])
    assert all(one["gear_pair"] == config["gear_pair"] for one in found)


def test_a_member_differs_from_the_study_in_its_overrides_only(study):
    config = study(heat={"t120": {"cases": {"with": {"bulk_temperature": 120}}}})
    found = members(config)
    assert named(found) == ["", *MAPPED, *ENSEMBLE, "studies/heat/t120/"]
    member = found["studies/heat/t120/"]
    assert member["cases"]["with"] == {"bulk_temperature": 120.0, "running_cycles": 2_100_000_000, "flash": True}
    member["cases"]["with"]["bulk_temperature"] = 100.0
    assert member == {**config, "studies": {}}


def test_sections_that_a_member_shares_with_the_study_need_no_second_reading(study):
    config = study(heat={"t120": {"cases": {"with": {"bulk_temperature": 120}}}})
    anew = copy.deepcopy({**config, "studies": {}})
    anew["cases"]["with"]["bulk_temperature"] = 120
    assert members(config)["studies/heat/t120/"] == check(anew)


def test_overrides_are_read_like_any_configuration(study):
    found = members(study(oil={"thin": {"lubricant": {"pressure_viscosity": "2.4e-8"}, "dynamics": {}}}))
    assert found["studies/oil/thin/"]["lubricant"]["pressure_viscosity"] == 2.4e-8


def test_a_changed_value_of_the_study_reaches_its_members(study):
    config = study(heat={"t120": {"cases": {"with": {"bulk_temperature": 120}}}})
    config["dynamics"]["damping_ratio"] = 0.09
    assert members(config)["studies/heat/t120/"]["dynamics"]["damping_ratio"] == 0.09


def test_a_member_may_have_cases_of_its_own(study):
    case = {"bulk_temperature": 50.0, "running_cycles": 0, "flash": False}
    found = members(study(heat={"more": {"cases": {"warm": case}}}))
    assert found["studies/heat/more/"]["cases"]["warm"] == case
    assert "warm" not in found[""]["cases"]


def test_every_problem_of_every_member_is_named_with_member_and_key(study):
    config = study(
        heat={
            "t120": {"cases": {"with": {"bulk_temprature": 120}}, "dynamics": {"damping_ratio": 2}},
            "good": {"cases": {"with": {"bulk_temperature": 120}}},
        },
        more={"nested": {"studies": {}}, "long": {"wear": {"cycles_per_update": 1e6}}},
    )
    with pytest.raises(ConfigError) as caught:
        members(config)
    assert str(caught.value).split("\n")[:5] == [
        "configuration: 6 problems",
        "  studies/heat/t120: dynamics.damping_ratio: 2.0 is not below 1; give a number from 1.0e-4 to below 1",
        "  studies/heat/t120: cases.with.bulk_temprature: unknown key (did you mean cases.with.bulk_temperature?)",
        "  studies/more/nested: studies: a member has no studies of its own; take them out",
        "  studies/more/long: cases.wear_only.running_cycles: 2.1e+9 is more than 999 times wear.cycles_per_update, "
        "1.0e+6; give at most 9.99e+8, or raise wear.cycles_per_update to 2.102103e+6 or more",
    ]


def test_merging_replaces_all_but_groups_and_leaves_both_as_they_were():
    base, overrides = {"a": {"b": 1, "c": [1, 2]}, "d": {"e": 1}}, {"a": {"c": [3]}, "d": None, "f": {"g": 1}}
    assert merged(base, overrides) == {"a": {"b": 1, "c": [3]}, "d": None, "f": {"g": 1}}
    assert base == {"a": {"b": 1, "c": [1, 2]}, "d": {"e": 1}}
    assert overrides == {"a": {"c": [3]}, "d": None, "f": {"g": 1}}


HEAT = "cases.with.bulk_temperature"


@pytest.fixture
def gridded(study):
    """Return a function that gives the checked default study with one grid."""

    def of(**entries):
        return check(study() | {"studies": {"life": entries}})

    return of


def test_every_possible_combination_of_a_grid_is_a_member(gridded):
    config = gridded(grid={HEAT: [10, 60], "wear.law": ["constant"]}, settings={"dynamics": {"damping_ratio": 0.09}})
    found = {root: member for root, member in members(config).items() if root.startswith("studies/life/")}
    (root,) = found  # 10 degC is below the initial temperature
    assert root == "studies/life/bulk_temperature_60__law_constant/"
    assert found[root]["cases"]["with"]["bulk_temperature"] == 60.0
    assert found[root]["wear"]["law"] == "constant" and found[root]["dynamics"]["damping_ratio"] == 0.09


def test_settings_that_cannot_be_hinder_the_study_and_not_the_run(gridded):
    """The study `life` is always declared, with settings that another configuration need not allow."""
    config = gridded(grid={HEAT: [20, 60]}, settings={"dynamics": {"damping_ratio": 2}})
    assert not [root for root in members(config) if root.startswith("studies/life/")]
    reason = "dynamics.damping_ratio: 2.0 is not below 1; give a number from 1.0e-4 to below 1"
    assert refusal(config, overrides_of(config["studies"]["life"], {HEAT: 20})) == reason


@pytest.mark.parametrize(
    ("entries", "told"),
    [
        ({}, "studies.life: a study has either members or a grid; give one of them"),
        (
            {"grid": {HEAT: [20]}, "members": {"one": {}}},
            "studies.life: a study has either members or a grid; give one of them",
        ),
        (
            {"grid": {"cases.with.bulk_temprature": [20]}},
            "studies.life.grid.(text 'cases.with.bulk_temprature'): no key with a value of its own; "
            "did you mean cases.with.bulk_temperature?",
        ),
        ({"grid": {"dynamics": [1]}}, "studies.life.grid.dynamics: no key with a value of its own"),
        (
            {"grid": {HEAT: [60, 40]}},
            "studies.life.grid.(text 'cases.with.bulk_temperature'): 40 does not come after 60; "
            "sort the values, each once",
        ),
        (
            {"grid": {"wear.law": ["constant", "constant"]}},
            "studies.life.grid.(text 'wear.law'): text 'constant' does not come after text 'constant'; "
            "sort the values, each once",
        ),
        (
            {"grid": {HEAT: [20]}, "case": "wth"},
            "studies.life.case: text 'wth' is no case (did you mean with?)",
        ),
        (
            {"grid": {HEAT: list(range(20, 140)), "dynamics.damping_ratio": [i / 1000 for i in range(1, 101)]}},
            "studies.life.grid: 12000 combinations are more than 10000; give fewer values",
        ),
    ],
)
def test_a_bad_grid_is_told_with_its_key(gridded, entries, told):
    with pytest.raises(ConfigError) as refused:
        gridded(**entries)
    assert str(refused.value).splitlines()[1].strip().startswith(told)


def test_the_last_key_changes_fastest():
    found = combinations({"dynamics.damping_ratio": [0.05, 0.1], "mesh_stiffness.hertz": ["linear", "weber"]})
    assert [one.name for one in found] == [
        "damping_ratio_0_05__hertz_linear",
        "damping_ratio_0_05__hertz_weber",
        "damping_ratio_0_1__hertz_linear",
        "damping_ratio_0_1__hertz_weber",
    ]
    assert found[2].values == {"dynamics.damping_ratio": 0.1, "mesh_stiffness.hertz": "linear"}


def test_no_grid_has_no_combination():
    assert combinations({}) == []


@pytest.mark.parametrize("values", [[1.00000001, 1.00000002], ["a" * 70, "b" * 70]])
def test_names_that_are_alike_or_too_long_are_numbered(values):
    assert [one.name for one in combinations({"dynamics.start.displacement": values})] == ["member_0001", "member_0002"]


@pytest.mark.parametrize(
    ("value", "text"), [(2.1e9, "2_1e09"), (-20, "m20"), (0.5, "0_5"), (True, "true"), ("Weber line", "weber_line")]
)
def test_a_value_becomes_part_of_a_name(value, text):
    assert slug(value) == text
