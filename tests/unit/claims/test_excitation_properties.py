import numpy as np
import pytest

from gearwear.claims import excitation_properties as excitation
from gearwear.claims.study import Study, Undecided

STIFFNESS = ("mesh_stiffness", "wear_only", 2)
ERROR = ("transmission_error", "with", 2)


def raise_one_phase(stiffness):
    raised = stiffness.values.copy()
    raised[3] *= 1.1
    return stiffness.copy(data=raised)


def lower_single_contact(stiffness):
    return stiffness.where(stiffness["mesh_phase"] < 14 / 8.5 - 1, 0.9 * stiffness)


def lower_error(error):
    return error - 2e-6


def lower_error_of_single_contact(error):
    return error.where(error["mesh_phase"] < 14 / 8.5 - 1, error - 2e-6)


def lower_error_of_double_contact(error):
    return error.where(error["mesh_phase"] > 14 / 8.5 - 1, error - 2e-6)


def fall_all_along(backlash):
    return backlash.copy(data=-backlash["path"].values)


@pytest.mark.parametrize(
    ("judge", "key", "name", "spoil"),
    [
        (
            excitation.stiffness_falls_with_temperature,
            ("mesh_stiffness", "middle", 0),
            "mesh_stiffness",
            raise_one_phase,
        ),
        (
            excitation.stiffness_falls_with_temperature,
            ("mesh_stiffness", "temperature_only", 0),
            "mesh_stiffness",
            raise_one_phase,
        ),
        (excitation.stiffness_falls_with_wear, STIFFNESS, "mesh_stiffness", raise_one_phase),
        (
            excitation.stiffness_drop_larger_in_double_contact,
            STIFFNESS,
            "mesh_stiffness",
            lower_single_contact,
        ),
        (excitation.transmission_error_rises, ERROR, "transmission_error", lower_error),
        (excitation.transmission_error_rises, ERROR, "transmission_error", lower_error_of_single_contact),
        (excitation.transmission_error_rises, ERROR, "transmission_error", lower_error_of_double_contact),
        (
            excitation.transmission_error_rise_larger_in_double_contact,
            ERROR,
            "transmission_error",
            lambda error: error + 1e-6,
        ),
        (
            excitation.growth_dominates_backlash,
            ERROR,
            "elastic_deflection",
            lambda deflection: 3 * deflection,
        ),
        (
            excitation.growth_dominates_backlash,
            ("wear", "with", 2),
            "wear_depth",
            lambda wear: 100 * wear,
        ),
        (
            excitation.backlash_falls_then_rises,
            ("backlash", "middle", 1),
            "backlash_path",
            fall_all_along,
        ),
        (
            excitation.backlash_jumps_at_transitions,
            ("backlash", "without", 0),
            "backlash_path",
            fall_all_along,
        ),
    ],
)
def test_property_holds_until_its_field_is_spoilt(study, results, change, judge, key, name, spoil):
    assert judge(study)[0] is True
    change(results, key, name, spoil)
    holds, found = judge(study)
    assert holds is False
    assert found


def test_drop_by_wear_is_reported_by_size(study):
    _, found = excitation.stiffness_falls_with_wear(study)
    assert "largest 0.04 %" in found
    assert "lower at 100 % of the phases" in found


def test_drop_needs_a_worn_cycle(study, results):
    del results["wear", "wear_only", 1], results["wear", "wear_only", 2]
    with pytest.raises(Undecided, match="no worn cycle"):
        excitation.stiffness_falls_with_wear(study)


def test_transmission_error_is_judged_by_zone_means(study, results, change):
    change(results, ERROR, "transmission_error", lambda error: error.copy(data=error.values - lone(error)))
    holds, found = excitation.transmission_error_rises(study)
    assert holds is True
    assert "rises at no less than 97.5 % of the phases" in found


def lone(error):
    return np.where(np.arange(error.size) == 2, 1e-6, 0.0)


def test_rise_of_a_single_state_is_not_decided(results):
    assert excitation.transmission_error_rises(Study(results, (("with", 2),)))[0] is None


def test_significantly_larger_is_half_as_large_again(study, results, change):
    change(results, ERROR, "transmission_error", lambda error: error + 0.6e-6)
    assert excitation.transmission_error_rise_larger_in_double_contact(study)[0] is True
    change(results, ERROR, "transmission_error", lambda error: error + 0.2e-6)
    assert excitation.transmission_error_rise_larger_in_double_contact(study)[0] is False


def test_means_are_reported_with_units(study):
    _, found = excitation.growth_dominates_backlash(study)
    assert found.startswith("means: growth 14 um, deflection ")


def test_backlash_of_a_cold_state_is_not_asked(study, results, change):
    change(results, ("backlash", "without", 0), "backlash_path", fall_all_along)
    assert excitation.backlash_falls_then_rises(study)[0] is True
