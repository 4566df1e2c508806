"""Qualitative properties of the excitations: mesh stiffness, transmission error, backlash.

Shapes are judged in every state drawn; sizes of causes at the paper's operating point, case ``with``.
Every function takes a `Study` and returns whether the property holds, and the numbers found;
`Undecided` if the results do not suffice.
"""

from itertools import pairwise
from typing import Any

import numpy as np

from gearwear.claims import rules
from gearwear.claims.path_measures import double_contact, jump_ratios, jumps_everywhere
from gearwear.claims.study import Study, Undecided
from gearwear.claims.wording import micrometres, millimetres, percent
from gearwear.geometry.path_mean import path_mean


def stiffness_falls_with_temperature(study: Study) -> tuple[bool, str]:
    """Return whether unworn stiffness falls at every phase from each bulk temperature to the next.

    Compared are the drawn cases in order of bulk temperature, and ``temperature_only`` with ``without``.
    """
    steps = [*pairwise(study.cases_by_temperature()), ("without", "temperature_only")]
    shares, drops = [], []
    for colder, hotter in steps:
        drop = _relative_drop(study, (colder, 0), (hotter, 0))
        shares.append(float(np.mean(drop > 0)))
        drops.append(f"{colder} to {hotter} {percent(drop.mean())}")
    found = f"mean drop {', '.join(drops)}; at no less than {percent(min(shares))} of the phases"
    return bool(min(shares) == 1), found


def stiffness_falls_with_wear(study: Study) -> tuple[bool, str]:
    """Return whether wear alone lowers the stiffness at every phase, last cycle against the first."""
    drop = _drop_by_wear(study)
    found = f"mean drop {percent(drop.mean())}, largest {percent(drop.max())}"
    return bool(np.all(drop > 0)), f"{found}, lower at {percent(float(np.mean(drop > 0)))} of the phases"


def stiffness_drop_larger_in_double_contact(study: Study) -> tuple[bool, str]:
    """Return whether wear alone lowers the stiffness more, on average, where two pairs are in contact."""
    drop = _drop_by_wear(study)
    double = double_contact(study, study.field("mesh_stiffness", "mesh_stiffness", "wear_only", 0))
    in_double, in_single = drop[double].mean(), drop[~double].mean()
    return bool(in_double > in_single), f"mean drop double {percent(in_double)}, single {percent(in_single)}"


def _drop_by_wear(study: Study) -> np.ndarray:
    last = study.cycles("wear_only")[-1]
    if last == 0:
        raise Undecided("case wear_only has no worn cycle")
    return _relative_drop(study, ("wear_only", 0), ("wear_only", last))


def _relative_drop(study: Study, before: tuple[str, int], after: tuple[str, int]) -> np.ndarray:
    reference = study.field("mesh_stiffness", "mesh_stiffness", *before).values
    return (reference - study.field("mesh_stiffness", "mesh_stiffness", *after).values) / reference


def transmission_error_rises(study: Study) -> tuple[bool | None, str]:
    """Return whether the mean transmission error of both zones rises from each drawn state to the next.

    The share of single phases that rise is reported and takes no part in the verdict.
    """
    if len(study.diagonal) < 2:
        return None, "fewer than two states are drawn"
    holds, shares = True, []
    for before, after in pairwise(study.diagonal):
        rise, double = _rise_of_transmission_error(study, before, after)
        holds &= rise[double].mean() > 0 and rise[~double].mean() > 0
        shares.append(float(np.mean(rise > 0)))
    rise, double = _rise_of_transmission_error(study, study.diagonal[0], study.diagonal[-1])
    found = f"mean rise double {micrometres(rise[double].mean())}, single {micrometres(rise[~double].mean())}"
    return bool(holds), f"{found}; each step rises at no less than {percent(min(shares))} of the phases"


def transmission_error_rise_larger_in_double_contact(study: Study) -> tuple[bool, str]:
    """Return whether the mean rise, first to last drawn state, is significantly larger in double contact."""
    rise, double = _rise_of_transmission_error(study, study.diagonal[0], study.diagonal[-1])
    in_double, in_single = rise[double].mean(), rise[~double].mean()
    holds = in_double > 0 and in_double >= rules.SIGNIFICANTLY_LARGER * in_single
    return bool(holds), f"mean rise double {micrometres(in_double)}, single {micrometres(in_single)}"


def _rise_of_transmission_error(study: Study, before: Any, after: Any) -> tuple[np.ndarray, np.ndarray]:
    first, last = (
        study.field("transmission_error", "transmission_error", case, cycle) for case, cycle in (before, after)
    )
    return last.values - first.values, double_contact(study, first)


def growth_dominates_backlash(study: Study) -> tuple[bool, str]:
    """Return whether the mean growth of all four flanks exceeds mean deflection and wear, case ``with``."""
    cycle = study.cycles("with")[-1]
    growth = 2 * path_mean(study.field("thermal_growth", "deformation", "with").sum("gear"))
    deflection = path_mean(study.field("elastic_deflection", "transmission_error", "with", cycle))
    wear = path_mean(study.field("wear_depth", "wear", "with", cycle).sum("gear"))
    found = f"means: growth {micrometres(growth)}, deflection {micrometres(deflection)}, wear {micrometres(wear)}"
    return growth > max(deflection, wear), found


def backlash_falls_then_rises(study: Study) -> tuple[bool, str]:
    """Return whether backlash is least strictly inside the path in every heated state drawn."""
    holds, found = True, []
    for case, cycle in study.heated_states():
        backlash = study.field("backlash_path", "backlash", case, cycle)
        values = backlash.values
        least = int(np.argmin(values))
        holds &= values[0] > values[least] < values[-1]
        place = float(backlash["path"].values[least])
        first, lowest, last = (f"{1e6 * value:.2f}" for value in (values[0], values[least], values[-1]))
        found.append(f"{case} {first}, least {lowest} at {millimetres(place)}, {last} um")
    return bool(holds), "; ".join(found)


def backlash_jumps_at_transitions(study: Study) -> tuple[bool, str]:
    """Return whether backlash jumps at both zone changes in every state drawn."""
    ratios = []
    for case, cycle in study.diagonal:
        ratios += jump_ratios(study, study.field("backlash_path", "backlash", case, cycle))
    return jumps_everywhere(ratios), f"differences {min(ratios):.3g} to {max(ratios):.3g} x the next step"
