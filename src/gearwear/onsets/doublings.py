"""Period doublings on the branches of periodic orbits, and which of them the motion of a sweep goes through."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import xarray as xr

from gearwear.claims.rules import PERIOD_RUN
from gearwear.codes.branch_codes import NONE, PERIOD_DOUBLING
from gearwear.codes.onset_codes import ABSENT, MET, PASSED_BY
from gearwear.motions.sequence import changes

ACCURACY = 1e-8  # to which special points are located


class Doubling(NamedTuple):
    """A period doubling: swept value, state at mesh phase 0 and period in mesh periods, before it doubles."""

    value: float
    state: tuple[float, float]
    period: int


class Onset(NamedTuple):
    """An event on the route to chaos.

    value : where it lies, of a doubling on the branch of orbits; nan without one.
    seen : where the sweep shows it: a doubling that it meets, else the middle between the two points that differ;
        nan if nowhere.
    how : one of codes.HOW.
    resolution : the event lies at most this far below `value`.
    remark : the same in words.
    """

    value: float
    seen: float
    how: int
    resolution: float
    remark: str


def doublings(branches: xr.Dataset, sweep: str, period: int) -> list[Doubling]:
    """Return where orbits of a period, stable below, lose their stability by a doubling, ascending.

    Parameters
    ----------
    branches : as orbits.record writes them.
    sweep : name of the swept quantity.
    """
    index, special = branches["branch_index"].values, branches["special_point"].values
    value, stable = branches[sweep].values, branches["stable"].values
    states = np.stack([branches[f"branch_{name}"].values[:, 0] for name in ("displacement", "velocity")], axis=1)
    found = []
    for branch in np.flatnonzero(branches["branch_period"].values == period):
        nodes = np.flatnonzero(index == branch)
        plain = nodes[special[nodes] == NONE]
        for node in nodes[special[nodes] == PERIOD_DOUBLING]:
            sides = [*plain[plain < node][-1:], *plain[plain > node][:1]]
            if len(sides) < 2:
                continue
            below, above = sorted(sides, key=lambda side: value[side])
            if value[below] < value[node] < value[above] and stable[below] and not stable[above]:
                found.append(Doubling(float(value[node]), tuple(states[node].tolist()), period))
    return sorted(found)


def onset_of_doubling(
    found: Sequence[Doubling], values: np.ndarray, motion_class: np.ndarray, period: int, above: float = -np.inf
) -> Onset:
    """Return the doubling of a period on the route of a sweep.

    It is the first one, upwards, where the sweep changes from this period to twice it. Without such a place: the one
    nearest to the first change of that kind, a jump; without a change: the lowest above the doubling before.

    Parameters
    ----------
    found : doublings of this period.
    values, motion_class : (points,) of the sweep, ascending.
    above : the doubling of half the period, if there is one.
    """
    brackets = [values[list(change)] for change in changes(motion_class, period, 2 * period, PERIOD_RUN)]
    for doubling in found:
        if any(low - ACCURACY <= doubling.value <= high + ACCURACY for low, high in brackets):
            return Onset(doubling.value, doubling.value, MET, ACCURACY, "the motion of the sweep doubles there")
    change = f"the sweep has no change from period {period} to {2 * period}"
    seen = np.nan
    if brackets:
        low, high = brackets[0]
        change = f"the sweep jumps from period {period} to {2 * period} between {low:.6g} and {high:.6g}"
        seen = float(low + high) / 2
        found = sorted(found, key=lambda doubling: abs(doubling.value - seen))
    else:
        found = [doubling for doubling in found if doubling.value > above]
    if not found:
        return Onset(np.nan, seen, ABSENT, np.nan, f"no stable orbit of period {period} doubles; {change}")
    return Onset(found[0].value, seen, PASSED_BY, ACCURACY, change)
