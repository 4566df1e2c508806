"""The outcomes as a tidy table, a row a member, and one sentence on every life."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import Any

import numpy as np
import xarray as xr

from gearwear.codes.motion_class import class_name
from gearwear.geometry.involute import GEARS
from gearwear.studies import wording
from gearwear.studies.gathering import MEMBER
from gearwear.studies.speeds import Limit, contact_limit, intervals, peak, period_one_limit

NOTHING = "none"
AGE = ".running_cycles"  # end of the key along which a pair ages


def members(study: xr.Dataset, axes: list[str]) -> Iterator[tuple[dict[str, Any], xr.Dataset]]:
    """Yield the values of the axes and the outcome of every member."""
    for place in itertools.product(*(range(study.sizes[key]) for key in axes)):
        one = study.isel(dict(zip(axes, place, strict=True)))
        yield {key: one[key].item() for key in axes}, one


def rows(study: xr.Dataset, axes: list[str], order: str) -> list[dict[str, str]]:
    """Return one row a member: values of the axes, what hinders it, mesh, speeds in rpm, classes over the speed.

    Ratios are mesh frequencies over the natural one of the member.
    """
    found = []
    for values, one in members(study, axes):
        safe, contact, highest = period_one_limit(one), contact_limit(one), peak(one)
        natural = float(one["natural_speed"])
        row = {} if axes == [MEMBER] else {"member": str(one["member_name"].item())}
        row |= {key: wording.plain(value) for key, value in values.items()}
        row |= {
            "hindrance": str(one["hindrance"].item()) or NOTHING,
            "natural_speed_rpm": _figures(natural, 1),
            "mean_stiffness_N_per_m": _exponent(one["mean_stiffness"]),
            "relative_mean_error": _figures(one["relative_mean_error"], 4),
            "mean_half_backlash_um": _figures(1e6 * one["mean_half_backlash"], 2),
        }
        row |= {f"deepest_wear_{gear}_um": _figures(1e6 * one["deepest_wear"].sel(gear=gear), 3) for gear in GEARS}
        row |= {"period_1_up_to": _figures(safe.ratio, 4), "period_1_up_to_rpm": _figures(safe.speed, 0)}
        row |= {"contact_kept_up_to": _figures(contact.ratio, 4), "contact_kept_up_to_rpm": _figures(contact.speed, 0)}
        for event in ("first_doubling", "chaos_onset"):
            ratio = float(one[event])
            row |= {event: _figures(ratio, 4), f"{event}_rpm": _figures(ratio * natural, 0)}
        row |= {
            "peak_force_over_mean": _figures(highest.force, 3),
            "peak_at": _figures(highest.ratio, 4),
            "peak_at_rpm": _figures(highest.speed, 0),
            "running_speed_rpm": _figures(one["running_speed"], 0),
            "running_class": NOTHING if np.isnan(natural) else class_name(int(one["running_class"])),
            "running_force_over_mean": _figures(one["running_force"], 3),
            "running_contact_loss": _figures(one["running_contact_loss"], 4),
        }
        runs = [] if np.isnan(natural) else intervals(one, order)
        row["classes"] = "; ".join(f"{name} {a:.3f}-{b:.3f}" for name, a, b, _, _ in runs) or NOTHING
        row["classes_rpm"] = "; ".join(f"{name} {a:.0f}-{b:.0f}" for name, _, _, a, b in runs) or NOTHING
        found.append(row)
    return found


def sentences(study: xr.Dataset, units: dict[str, str]) -> list[dict[str, str]]:
    """Return one row for every combination of the axes but that of age: how fast the pair may run all its life.

    A limit is the lowest over the life, in ratio and in speed each.

    Parameters
    ----------
    units : of the axes, by name.
    """
    age = next((key for key in units if key.endswith(AGE)), None)
    others = [key for key in units if key != age]
    found = []
    for values, life in members(study, others):
        states = [life] if age is None else [life.isel({age: i}) for i in range(life.sizes[age])]
        possible = [one for one in states if not str(one["hindrance"].item())]
        row = {key: wording.plain(value) for key, value in values.items()}
        where = wording.state(values, units)
        found.append(row | {"sentence": (f"{where}: " if where else "") + _sentence(life, age, states, possible)})
    return found


def lowest(limits: list[Limit]) -> Limit:
    """Return the lowest ratio and the lowest speed of some limits."""
    if any(np.isnan(one.ratio) for one in limits):
        return Limit(np.nan, np.nan, False)
    return Limit(
        min(one.ratio for one in limits), min(one.speed for one in limits), all(one.everywhere for one in limits)
    )


def _sentence(life: Any, age: Any, states: list[xr.Dataset], possible: Any) -> str:
    if not possible:
        return f"cannot be: {states[0]['hindrance'].item()}."
    whole = "" if age is None else f" from {life[age].values[0]:.3g} to {life[age].values[-1]:.3g} revolutions"
    if len(possible) < len(states):
        last = possible[-1][age].item()
        whole = f" up to {last:.3g} revolutions (then it cannot go on: {states[len(possible)]['hindrance'].item()})"
    safe, contact = (
        lowest([period_one_limit(one) for one in possible]),
        lowest([contact_limit(one) for one in possible]),
    )
    highest = max((peak(one) for one in possible), key=lambda one: one.force)
    running = {class_name(int(one["running_class"])) for one in possible}
    force = max(float(one["running_force"]) for one in possible)
    lost = max(float(one["running_contact_loss"]) for one in possible)
    kept = "contact kept" if lost == 0 else f"contact lost for {100 * lost:.1f} % of the time"
    return (
        f"{_below(safe)} the pair stays period 1{whole}; {_below(contact)} it keeps contact. The mesh force is "
        f"at most {highest.force:.2f} of its mean, at {highest.ratio:.3f} ({highest.speed:.0f} rpm). At the running "
        f"speed, {float(possible[0]['running_speed']):.0f} rpm, the motion is {' or '.join(sorted(running))}, {kept}, "
        f"the force at most {force:.2f} of its mean."
    )


def _below(limit: Limit) -> str:
    if np.isnan(limit.ratio):
        return "at no speed of the sweep"
    if limit.everywhere:
        return f"at every speed of the sweep, up to {limit.ratio:.3f} of the natural frequency ({limit.speed:.0f} rpm),"
    return f"up to {limit.ratio:.3f} of the natural frequency ({limit.speed:.0f} rpm)"


def _figures(value: Any, decimals: int) -> str:
    return NOTHING if np.isnan(float(value)) else f"{float(value):.{decimals}f}"


def _exponent(value: Any) -> str:
    return NOTHING if np.isnan(float(value)) else f"{float(value):.4e}"
