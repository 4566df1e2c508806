import numpy as np
import pytest

from gearwear.claims.study import Study, Undecided, describe


def test_field_returns_values_with_their_coordinates(study):
    growth = study.field("thermal_growth", "deformation", "with")
    assert growth.dims == ("gear", "path")
    assert growth.sel(gear="pinion").values[0] == pytest.approx(5e-6)


@pytest.mark.parametrize(
    ("key", "name", "reason"),
    [
        (("wear", "with", 7), "wear_depth", "no result wear/with/q007"),
        (("wear", "with", 2), "wear", "no variable wear in wear/with/q002"),
        (("geometry",), "bore", "no variable bore in geometry"),
    ],
)
def test_missing_results_are_undecided_with_their_name(study, key, name, reason):
    with pytest.raises(Undecided, match=reason):
        study.field(name, *key)


def test_values_that_are_not_finite_are_undecided(study, results, change):
    change(results, ("deformation", "with"), "thermal_growth", lambda growth: growth.where(growth > 3e-6))
    with pytest.raises(Undecided, match="not finite"):
        study.field("thermal_growth", "deformation", "with")


def test_field_without_its_coordinate_is_undecided(study, results):
    results["backlash", "with", 2] = results["backlash", "with", 2].drop_vars("path")
    with pytest.raises(Undecided, match="no coordinate path in backlash/with/q002"):
        study.field("backlash_path", "backlash", "with", 2)


def test_cycles_are_ascending_and_must_exist(study):
    assert study.cycles("with") == [0, 1, 2]
    with pytest.raises(Undecided, match="no wear cycle of case other"):
        study.cycles("other")


def test_bulk_temperature_is_read_where_nothing_slides(study):
    assert study.bulk_temperature("with") == 100.0
    assert study.field("contact_temperature", "temperature", "with").values.max() > 100.0


def test_states_are_told_apart_by_wear_and_by_heat(study):
    assert study.worn_states() == [("middle", 1), ("with", 2)]
    assert study.heated_states() == [("middle", 1), ("with", 2)]


def test_cases_are_ordered_by_temperature_one_of_each(results):
    study = Study(results, (("with", 2), ("temperature_only", 0), ("without", 0)))
    assert study.cases_by_temperature() == ["without", "with"]


def test_no_worn_or_heated_state_is_undecided(results):
    study = Study(results, (("without", 0),))
    for states in (study.worn_states, study.heated_states, study.cases_by_temperature):
        with pytest.raises(Undecided):
            states()


def test_nodes_at_finds_both_one_sided_nodes(study):
    field = study.field("backlash_path", "backlash", "with", 2)
    first, second = study.nodes_at(field, "lowest_single_contact")
    assert second == first + 1
    assert field["path"].values[first] == field["path"].values[second]


def test_point_without_a_node_is_undecided(study, results):
    results["geometry"] = results["geometry"].assign(pitch_point=8.0123e-3)
    field = study.field("backlash_path", "backlash", "with", 2)
    with pytest.raises(Undecided, match="no node at pitch_point = 8.0123 mm"):
        study.pitch_node(field)


def test_describe_joins_a_key():
    assert describe(("wear", "with", 21)) == "wear/with/q021"
    assert describe(("sweep", "with", "ste")) == "sweep/with/ste"


def test_empty_fields_are_undecided(study, results):
    results["deformation", "with"] = results["deformation", "with"].isel(path=np.array([], dtype=int))
    with pytest.raises(Undecided, match="empty"):
        study.field("thermal_growth", "deformation", "with")
