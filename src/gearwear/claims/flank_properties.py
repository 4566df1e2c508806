"""Qualitative properties of the flanks: wear depth, contact temperature, thermal growth.

Shapes are judged in every state drawn that is worn or heated; sizes of causes at the paper's operating
point, case ``with``. The path coordinate runs from the dedendum of the pinion, which meets the addendum
of the gear, over the pitch point to the addendum of the pinion. Every function takes a `Study` and
returns whether the property holds, and the numbers found; `Undecided` if the results do not suffice.
"""

import numpy as np

from gearwear.claims import rules
from gearwear.claims.path_measures import jump_ratios, jumps_everywhere
from gearwear.claims.study import Study
from gearwear.claims.wording import micrometres, millimetres, percent
from gearwear.geometry.path_mean import path_mean

GEARS = ("pinion", "gear")


def wear_of_pinion_largest_in_dedendum(study: Study) -> tuple[bool, str]:
    """Return whether pinion wear is deepest before the pitch point in every worn state."""
    return _deepest_before_pitch_point(study, "pinion")


def wear_of_gear_largest_in_addendum(study: Study) -> tuple[bool, str]:
    """Return whether gear wear is deepest before the pitch point in every worn state."""
    return _deepest_before_pitch_point(study, "gear")


def _deepest_before_pitch_point(study: Study, gear: str) -> tuple[bool, str]:
    pitch_point = study.scalar("pitch_point")
    holds, found = True, []
    for case, cycle in study.worn_states():
        depth = study.field("wear_depth", "wear", case, cycle).sel(gear=gear)
        deepest = int(np.argmax(depth.values))
        place = float(depth["path"].values[deepest])
        holds &= depth.values[deepest] > 0 and place < pitch_point
        found.append(f"{case} {micrometres(depth.values[deepest])} at {millimetres(place)}")
    return bool(holds), f"{', '.join(found)}; pitch point {millimetres(pitch_point)}"


def no_wear_at_pitch_point(study: Study) -> tuple[bool, str]:
    """Return whether wear at the pitch point is a negligible share of the largest one, gear by gear."""
    shares = []
    for case, cycle in study.worn_states():
        wear = study.field("wear_depth", "wear", case, cycle)
        for gear in GEARS:
            depth = wear.sel(gear=gear)
            if depth.values.max() <= 0:
                return False, f"{case}: the {gear} does not wear at all"
            shares.append(abs(depth.values[study.pitch_node(depth)]) / depth.values.max())
    return bool(max(shares) < rules.NO_WEAR), f"at most {max(shares):.1e} of the largest wear depth"


def wear_grows_with_cycles(study: Study) -> tuple[bool | None, str]:
    """Return whether wear of case ``with`` grows in every cycle at all nodes but the pitch point."""
    cycles = study.cycles("with")
    if len(cycles) < 2:
        return None, "one wear cycle only"
    growing, total = 0, 0
    worn = study.field("wear_depth", "wear", "with", cycles[0]).transpose("gear", "path")
    sliding = np.arange(worn.sizes["path"]) != study.pitch_node(worn)
    for cycle in cycles[1:]:
        before, worn = worn, study.field("wear_depth", "wear", "with", cycle).transpose("gear", "path")
        growth = (worn.values - before.values)[:, sliding]
        growing += int(np.count_nonzero(growth > 0))
        total += growth.size
    return growing == total, f"grows at {percent(growing / total)} of nodes and cycles, {len(cycles)} cycles"


def wear_jumps_at_transitions(study: Study) -> tuple[bool, str]:
    """Return whether the wear of both gears jumps at both zone changes in every worn state."""
    ratios = []
    for case, cycle in study.worn_states():
        wear = study.field("wear_depth", "wear", case, cycle)
        for gear in GEARS:
            ratios += jump_ratios(study, wear.sel(gear=gear))
    return jumps_everywhere(ratios), f"differences {min(ratios):.3g} to {max(ratios):.3g} x the next step"


def flash_temperature_monotone(study: Study) -> tuple[bool, str]:
    """Return whether friction, speed and load each raise the flash temperature of case ``with``."""
    sensitivity = study.field("flash_sensitivity", "temperature", "with")
    factors = {name: float(sensitivity.sel(influence=name)) for name in ("friction", "speed", "load")}
    found = ", ".join(f"{name} {factor:.4f}" for name, factor in factors.items())
    return min(factors.values()) > 1, f"largest flash temperature times, for 10 % more: {found}"


def growth_of_pinion_falls(study: Study) -> tuple[bool, str]:
    """Return whether pinion growth falls along the whole path in every heated state.

    Between the one-sided values at a zone change it may be equal, but not rise.
    """
    holds, found = True, []
    for case, _ in study.heated_states():
        growth = study.field("thermal_growth", "deformation", case).sel(gear="pinion")
        steps = np.diff(growth.values)
        apart = np.diff(growth["path"].values) > 0
        rounding = rules.GRID_TOLERANCE * np.abs(growth.values).max()
        holds &= bool(np.all(steps[apart] < 0) and np.all(steps[~apart] <= rounding))
        found.append(f"{case} {micrometres(growth.values[0])} to {micrometres(growth.values[-1])}")
    return bool(holds), ", ".join(found)


def growth_of_gear_largest_in_dedendum(study: Study) -> tuple[bool, str]:
    """Return whether gear growth is largest behind the pitch point in every heated state."""
    pitch_point = study.scalar("pitch_point")
    holds, found = True, []
    for case, _ in study.heated_states():
        growth = study.field("thermal_growth", "deformation", case).sel(gear="gear")
        largest = int(np.argmax(growth.values))
        place = float(growth["path"].values[largest])
        holds &= growth.values[largest] > 0 and place > pitch_point
        found.append(f"{case} {micrometres(growth.values[largest])} at {millimetres(place)}")
    return bool(holds), f"{', '.join(found)}; pitch point {millimetres(pitch_point)}"


def growth_rises_with_bulk_temperature(study: Study) -> tuple[bool, str]:
    """Return whether growth rises at every node of both gears from each bulk temperature to the next."""
    cases = study.cases_by_temperature()
    growth = [study.field("thermal_growth", "deformation", case).transpose("gear", "path") for case in cases]
    rising = np.diff([field.values for field in growth], axis=0) > 0
    return bool(rising.all()), f"rises at {percent(rising.mean())} of nodes and steps, {', '.join(cases)}"


def growth_dominated_by_bulk_temperature(study: Study) -> tuple[bool, str]:
    """Return whether mean growth by bulk temperature is far more than by flash temperature, case ``with``.

    The latter is an upper bound: the flash temperature is taken to heat the whole tooth.
    """
    bulk, flash = (
        path_mean(study.field(name, result, "with").sum("gear"))
        for name, result in (("thermal_growth", "deformation"), ("thermal_growth_flash", "flash_growth"))
    )
    found = f"mean of both gears {micrometres(bulk)} by bulk, {micrometres(flash)} by flash temperature"
    return bulk > rules.FAR_MORE * flash, found
