"""The variations: every choice of the models, their companions, and both ends of the parameters."""

from pathlib import Path
from typing import Literal, get_args

import pytest
import yaml

from gearwear.config.check import check
from gearwear.config.members import members, refusal
from gearwear.config.pair import Heat, TransmissionError
from gearwear.config.parameters import ENDS, OPTION, PARAMETER, PLACES
from gearwear.config.slices import slice_of
from gearwear.config.study import Configuration
from gearwear.config.types import keys, schema_of, unit_of
from gearwear.config.variations import STUDY, variations

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture
def study():
    """Return a function that gives the checked default study with sections replaced key by key."""
    raw = yaml.safe_load((ROOT / "config" / "config.yaml").read_text(encoding="utf-8"))

    def of(**changes):
        for section, values in changes.items():
            raw[section] |= values
        return check(raw)

    return of


def options(config):
    return {(one.key, one.value): one for one in variations(config) if one.group == OPTION}


def test_every_alternative_of_a_choice_is_a_variation_and_the_present_one_is_not(study):
    config = study()
    found = {value for key, value in options(config) if key == "transmission_error.heat"}
    assert found == set(get_args(TransmissionError.model_fields["heat"].annotation)) - {"relative"}
    assert ("transmission_error.heat", "relative") in options(study(transmission_error={"heat": "none"}))


def test_a_new_option_of_a_model_is_a_variation(study, monkeypatch):
    config = study()
    monkeypatch.setattr(Heat.model_fields["growth"], "annotation", Literal["paper", "measured"])
    assert {value for key, value in options(config) if key == "heat.growth"} == {"measured"}


def test_flags_and_numbers_of_harmonics_are_varied(study):
    found = options(study())
    assert found[("transmission_error.heat_in_load_sharing", "true")].overrides == {
        "transmission_error": {"heat_in_load_sharing": True}
    }
    assert {value for key, value in found if key == "dynamics.harmonics"} == {"3", "full"}
    assert {value for key, value in options(study(dynamics={"harmonics": 3})) if key == "dynamics.harmonics"} == {
        "1",
        "full",
    }


CHOICES = {
    "backlash.projection",
    "dynamics.clearance",
    "dynamics.harmonics",
    "dynamics.start.at",
    "dynamics.ste_amplitude",
    "dynamics.stiffness",
    "elasticity.law",
    "friction.law",
    "heat.growth",
    "heat.hub",
    "heat.temperature_rise",
    "lubricant.viscosity_law",
    "mesh_stiffness.cantilever",
    "mesh_stiffness.fillet_angle",
    "mesh_stiffness.hertz",
    "mesh_stiffness.pairs",
    "mesh_stiffness.profile_changes",
    "sweeps.order",
    "transmission_error.heat",
    "transmission_error.heat_in_load_sharing",
    "transmission_error.mode",
    "wear.force",
    "wear.gear_cycles",
    "wear.law",
    "wear.pressure",
}


def test_the_choices_are_those_listed_and_no_other(study):
    """The reading of the backlash sweep touches nothing that is measured; model translational has no branches."""
    assert {key for key, _ in options(study())} == CHOICES


def test_every_variation_changes_what_is_measured_from(study):
    config = study()
    found = members(config)
    usual = slice_of(config, "measures")
    for one in variations(config):
        assert slice_of(found[f"studies/{STUDY}/{one.name}/"], "measures") != usual, one.name


def test_companions_are_taken_along_where_the_study_has_them_not(study):
    no_load = options(study())[("transmission_error.mode", "no_load")]
    assert no_load.overrides == {
        "transmission_error": {"mode": "no_load"},
        "dynamics": {"ste_amplitude": "harmonic"},
    }
    assert no_load.companions == "dynamics.ste_amplitude harmonic"
    already = options(study(dynamics={"ste_amplitude": "harmonic"}))[("transmission_error.mode", "no_load")]
    assert already.companions == "" and already.overrides == {"transmission_error": {"mode": "no_load"}}


def test_names_are_those_of_folders_and_each_stands_once(study):
    names = [one.name for one in variations(study())]
    assert len(set(names)) == len(names)
    assert all(name.replace("_", "").isalnum() and name[0].isalpha() and name == name.lower() for name in names)


def test_both_ends_of_every_parameter_are_variations_but_for_the_value_of_the_study(study):
    config = study()
    found = [one for one in variations(config) if one.group == PARAMETER]
    assert [one.name for one in found] == [f"{name}_{end}" for name in PLACES for end in ENDS]
    assert found[0].overrides == {"dynamics": {"damping_ratio": config["sensitivity"]["damping_ratio"]["low"]}}
    usual = config["dynamics"]["damping_ratio"]
    names = {one.name for one in variations(study(sensitivity={"damping_ratio": {"low": usual, "high": 0.2}}))}
    assert "damping_ratio_low" not in names and "damping_ratio_high" in names


def test_ends_have_unit_and_limits_of_their_key(study):
    def limits(field):
        schema = schema_of(field)
        return schema.get("anyOf", [schema])[0]  # the number, where null is allowed too

    declared = {".".join(path): field for path, field in keys(Configuration)}
    for name, key in PLACES.items():
        for end in ENDS:
            field, own = declared[f"sensitivity.{name}.{end}"], declared[key]
            assert unit_of(field) == unit_of(own), name
            assert limits(field) == limits(own) and "type" in limits(own), name


def test_an_option_that_the_rest_does_not_allow_is_no_member_and_says_why(study):
    config = study(lubricant={"dynamic_viscosity_40": 0.005})
    vogel = options(config)[("lubricant.viscosity_law", "vogel")]
    assert f"studies/{STUDY}/{vogel.name}/" not in members(config)
    assert refusal(config, vogel.overrides).startswith(
        "lubricant.dynamic_viscosity_40: 0.005 is not above lubricant.dynamic_viscosity, 0.0094 Pa s"
    )
    assert refusal(config, {}) == ""
