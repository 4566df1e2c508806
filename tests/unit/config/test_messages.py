"""What a key allows, as text."""

from gearwear.config.messages import allowed, span


def test_limits():
    assert span({"exclusiveMinimum": 0, "maximum": 2.5}) == "above 0 up to 2.5"
    assert span({"minimum": 0, "exclusiveMaximum": 1}) == "from 0 to below 1"


def test_choices_and_lists():
    assert allowed({"anyOf": [{"type": "number", "minimum": 0}, {"type": "null"}]}, "m") == "a number from 0 m or null"
    assert allowed({"enum": ["li", "linear", "table"]}) == "li, linear or table"
    names = {"type": "array", "items": {"type": "string"}}
    assert allowed(names | {"minItems": 2, "maxItems": 6}) == "a list of names with 2 to 6 entries"
    assert allowed(names | {"minItems": 1}) == "a list of names with at least one entry"
