"""Values at dotted keys of nested dicts."""

from gearwear.config.tree import dotted_keys, merged, nested, value_at


def test_dotted_keys_become_groups():
    assert nested({"a.b.c": 1, "a.b.d": 2, "e.f": 3}) == {"a": {"b": {"c": 1, "d": 2}}, "e": {"f": 3}}


def test_dotted_keys_of_groups():
    assert dotted_keys({"a": {"b": {"c": 1, "d": [2]}}, "e": 3}) == ["a.b.c", "a.b.d", "e"]


def test_groups_are_merged_and_all_else_is_replaced():
    base = {"a": {"b": 1, "c": [1, 2]}, "d": 3}
    assert merged(base, {"a": {"c": [4]}, "d": {"e": 5}}) == {"a": {"b": 1, "c": [4]}, "d": {"e": 5}}
    assert base == {"a": {"b": 1, "c": [1, 2]}, "d": 3}


def test_value_at_passes_over_what_is_absent():
    assert value_at({"a": {"b": 1}}, "a.b") == 1
    assert value_at({"a": {"b": 1}}, "a.c") is value_at({"a": 1}, "a.b") is value_at({}, "a.b") is None
