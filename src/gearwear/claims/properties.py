"""Which function decides which qualitative claim."""

from collections.abc import Callable

from gearwear.claims import events, excitation_properties, flank_properties
from gearwear.claims.study import Study

PROPERTIES: dict[str, Callable[[Study], tuple[bool | None, str]]] = {
    "wear-pinion-dedendum": flank_properties.wear_of_pinion_largest_in_dedendum,
    "wear-gear-addendum": flank_properties.wear_of_gear_largest_in_addendum,
    "wear-zero-at-pitch": flank_properties.no_wear_at_pitch_point,
    "wear-grows-with-cycles": flank_properties.wear_grows_with_cycles,
    "wear-jumps-at-transitions": flank_properties.wear_jumps_at_transitions,
    "flash-monotone": flank_properties.flash_temperature_monotone,
    "thermal-pinion-decreasing": flank_properties.growth_of_pinion_falls,
    "thermal-gear-dedendum-max": flank_properties.growth_of_gear_largest_in_dedendum,
    "thermal-grows-with-Tb": flank_properties.growth_rises_with_bulk_temperature,
    "thermal-bulk-dominates": flank_properties.growth_dominated_by_bulk_temperature,
    "tvms-falls-with-temperature": excitation_properties.stiffness_falls_with_temperature,
    "tvms-falls-with-wear": excitation_properties.stiffness_falls_with_wear,
    "tvms-wear-double-zone": excitation_properties.stiffness_drop_larger_in_double_contact,
    "ste-rises-with-wear-and-temperature": excitation_properties.transmission_error_rises,
    "ste-double-zone": excitation_properties.transmission_error_rise_larger_in_double_contact,
    "thermal-mean-dominates": excitation_properties.growth_dominates_backlash,
    "backlash-falls-then-rises": excitation_properties.backlash_falls_then_rises,
    "backlash-jumps": excitation_properties.backlash_jumps_at_transitions,
    "chaos-earlier-with": events.chaos_earlier_with_temperature_and_wear,
}
"""Claim id -> function of a `Study` that returns (holds, found)."""
