import pytest

from gearwear.claims import flank_properties as flank
from gearwear.claims.study import Study, Undecided

PITCH = 8e-3


def swap_gears(field):
    return field.copy(data=field.sel(gear=["gear", "pinion"]).values)


def mirror(field):
    return field.copy(data=field.values[:, ::-1])


def smooth_wear(field):
    return field.copy(data=[abs(field["path"].values - PITCH)] * 2)


WEAR = ("wear", "with", 2)
GROWTH = ("deformation", "with")


@pytest.mark.parametrize(
    ("judge", "key", "name", "spoil"),
    [
        (flank.wear_of_pinion_largest_in_dedendum, WEAR, "wear_depth", mirror),
        (flank.wear_of_gear_largest_in_addendum, WEAR, "wear_depth", mirror),
        (flank.wear_of_gear_largest_in_addendum, WEAR, "wear_depth", lambda wear: 0 * wear),
        (flank.no_wear_at_pitch_point, WEAR, "wear_depth", lambda wear: wear + 1e-11),
        (flank.no_wear_at_pitch_point, WEAR, "wear_depth", lambda wear: 0 * wear),
        (flank.wear_grows_with_cycles, WEAR, "wear_depth", lambda wear: 0.4 * wear),
        (flank.wear_jumps_at_transitions, WEAR, "wear_depth", smooth_wear),
        (flank.growth_of_pinion_falls, GROWTH, "thermal_growth", swap_gears),
        (flank.growth_of_gear_largest_in_dedendum, GROWTH, "thermal_growth", swap_gears),
        (flank.growth_rises_with_bulk_temperature, GROWTH, "thermal_growth", lambda growth: 0.4 * growth),
        (flank.growth_dominated_by_bulk_temperature, GROWTH, "thermal_growth", lambda growth: 0.39 * growth),
        (
            flank.flash_temperature_monotone,
            ("temperature", "with"),
            "flash_sensitivity",
            lambda factor: factor - 0.05,
        ),
    ],
)
def test_property_holds_until_its_field_is_spoilt(study, results, change, judge, key, name, spoil):
    assert judge(study)[0] is True
    change(results, key, name, spoil)
    holds, found = judge(study)
    assert holds is False
    assert found


def test_deepest_wear_is_reported_with_place_and_unit(study):
    _, found = flank.wear_of_pinion_largest_in_dedendum(study)
    assert "with 0.9 um at 2.000 mm" in found
    assert "pitch point 8.000 mm" in found


def test_pinion_growth_may_not_rise_between_one_sided_values(study, results, change):
    def lift_single_contact(growth):
        path = growth["path"].values
        lifted = growth.values.copy()
        first = int((path < 7.5e-3).sum()) + 1
        assert path[first - 1] == path[first] == 7.5e-3
        lifted[0, first:] += 1e-7
        return growth.copy(data=lifted)

    change(results, GROWTH, "thermal_growth", lift_single_contact)
    assert flank.growth_of_pinion_falls(study)[0] is False


def test_bulk_dominates_above_factor_two(study, results, change):
    change(results, GROWTH, "thermal_growth", lambda growth: 0.41 * growth)
    assert flank.growth_dominated_by_bulk_temperature(study)[0] is True


def test_growth_of_wear_is_counted_over_every_cycle(study, results):
    assert flank.wear_grows_with_cycles(study) == (True, "grows at 100 % of nodes and cycles, 3 cycles")
    del results["wear", "with", 1], results["wear", "with", 2]
    assert flank.wear_grows_with_cycles(study) == (None, "one wear cycle only")


def test_wear_of_an_unworn_diagonal_is_undecided(results):
    study = Study(results, (("without", 0), ("temperature_only", 0)))
    for judge in (
        flank.wear_of_pinion_largest_in_dedendum,
        flank.no_wear_at_pitch_point,
        flank.wear_jumps_at_transitions,
    ):
        with pytest.raises(Undecided, match="no worn state"):
            judge(study)
