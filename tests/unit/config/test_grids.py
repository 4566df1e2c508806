"""Grids: the combinations of values, their names and their keys."""

import pytest

from gearwear.config.grids import combinations, nested, slug


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


def test_dotted_keys_become_groups():
    assert nested({"a.b.c": 1, "a.b.d": 2, "e.f": 3}) == {"a": {"b": {"c": 1, "d": 2}}, "e": {"f": 3}}
