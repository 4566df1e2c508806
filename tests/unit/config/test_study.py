"""The models of the configuration."""

import inspect

from gearwear.config.study import Configuration, declared_at
from gearwear.config.types import Section, entry_type, is_section, keys, schema_of, unit_of


def test_every_key_has_a_meaning_and_every_number_a_unit():
    for path, field in keys(Configuration):
        described = field.annotation if is_section(field.annotation) else entry_type(field.annotation)
        assert field.description or inspect.getdoc(described) != Section.__doc__, path
        schema = str(schema_of(field))
        if ("'number'" in schema or "'integer'" in schema) and "properties" not in schema:
            assert unit_of(field), path


def test_the_meaning_of_a_choice_tells_every_option():
    for path, field in keys(Configuration):
        if "Literal" in str(field.annotation):
            options = [option for option in str(field.annotation).split("'")[1::2]]
            told = [field.description.find(f"{option} = ") for option in options]
            if path[-1] != "harmonics":
                assert -1 not in told and told == sorted(told), path


def test_no_model_has_a_default_beside_the_configuration_file():
    """A study is written anew by whoever declares it, so its entries may be left out."""
    assert all(field.is_required() for path, field in keys(Configuration) if path[0] != "studies" or len(path) < 2)


def test_the_declaration_of_a_key_by_its_dotted_name():
    assert declared_at("cases.with.bulk_temperature").unit == "degC"
    assert declared_at("gear_pair.teeth.pinion").meaning.startswith("Number of teeth")
    assert declared_at("wear.law").unit == ""
    assert declared_at("wear.laws") is None
