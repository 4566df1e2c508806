"""What comes out for one member of a study: its mesh, its motions over the speed, how fast it may run."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.chain.history import state_at
from gearwear.codes.motion_class import NOT_CONVERGED
from gearwear.codes.onset_codes import ORDERS
from gearwear.errors import Infeasible
from gearwear.geometry.involute import GEARS
from gearwear.geometry.kinematics import angular_speed
from gearwear.motions import parameter_map
from gearwear.motions.settling import Settling, settle
from gearwear.motions.start import rest_state
from gearwear.onsets import route_to_chaos
from gearwear.onsets.route import SWEEP
from gearwear.oscillator.excitation import Excitation, excitation
from gearwear.oscillator.periodic import sum_of_harmonics

_COLUMNS = tuple(name for name in parameter_map.KEPT if name != "transient_periods")
_WHOLE = ("motion_class", "reason", "conflict", "period")
_NUMBERS = (
    "natural_speed",
    "mean_stiffness",
    "stiffness_ripple",
    "relative_mean_error",
    "mean_half_backlash",
    "first_doubling",
    "chaos_onset",
    "running_speed",
    "running_ratio",
    "running_force",
    "running_contact_loss",
)
_WORDS = ("first_doubling_remark", "chaos_onset_remark")
_TO_RPM = 60 / (2 * np.pi)


def outcome(cfg: dict[str, Any], chain: xr.Dataset, update: int) -> xr.Dataset:
    """Return the outcome of a member.

    Parameters
    ----------
    cfg : the slice `outcome`.
    chain : the wear chain of its case.
    update : wear cycle of the chain that is looked at.

    Returns
    -------
    dataset of the sweep along (order, point) with the speeds of its points, and of numbers of the state. A member that
    cannot be has nan, motions that are not decided, and the reason as `hindrance`.
    """
    try:
        state, reference = state_at(chain, update)
        source = excitation(chain, state, reference, cfg["operation"]["pinion_torque"], cfg["dynamics"])
    except Infeasible as error:
        return impossible(cfg["sweeps"]["mesh_frequency"], str(error))
    dynamics, order = cfg["dynamics"], cfg["sweeps"]["order"]
    sweeps = {one: route_to_chaos.swept(cfg, source, one) for one in sorted(ORDERS, key=lambda one: one != order)}
    events = route_to_chaos.events(cfg, source, list(sweeps.values()), 1)
    first = excitation(chain, state, reference, cfg["operation"]["pinion_torque"], dynamics | {"harmonics": 1})
    ratios = sweeps[order][SWEEP].values
    natural_speed = source.natural_frequency / float(chain["teeth"][0]) * _TO_RPM
    values: dict[str, Any] = {
        name: (("order", "point"), np.stack([sweeps[one][name].values for one in ORDERS])) for name in _COLUMNS
    }
    values |= {
        "pinion_speed": ("point", ratios * natural_speed),
        "natural_speed": natural_speed,
        "mean_stiffness": source.mean_stiffness,
        "stiffness_ripple": sum_of_harmonics(first.stiffness).amplitudes[0],
        "relative_mean_error": source.relative_mean_error,
        "mean_half_backlash": source.clearance.mean * source.length,
        "deepest_wear": ("gear", state["wear_depth"].values.max(axis=1)),
        "first_doubling": events[0].value,
        "first_doubling_remark": events[0].remark,
        "chaos_onset": events[-1].value,
        "chaos_onset_remark": events[-1].remark,
        "hindrance": "",
    }
    values |= _at_running_speed(cfg, source, chain)
    return _dataset(values, ratios)


def impossible(ends: dict[str, Any], reason: str) -> xr.Dataset:
    """Return the outcome of a member that cannot be.

    Parameters
    ----------
    ends : the section `sweeps.mesh_frequency`.
    reason : why.
    """
    shape = (len(ORDERS), ends["points"])
    values: dict[str, Any] = {
        name: (("order", "point"), np.zeros(shape, np.int32) if name in _WHOLE else np.full(shape, np.nan))
        for name in _COLUMNS
    }
    values |= dict.fromkeys(_NUMBERS, np.nan) | dict.fromkeys(_WORDS, "")
    values |= {
        "pinion_speed": ("point", np.full(shape[1], np.nan)),
        "deepest_wear": ("gear", np.full(len(GEARS), np.nan)),
        "running_class": np.int32(NOT_CONVERGED),
        "hindrance": reason,
    }
    return _dataset(values, np.linspace(ends["first"], ends["last"], ends["points"]))


def _at_running_speed(cfg: dict[str, Any], source: Excitation, pair: xr.Dataset) -> dict[str, Any]:
    speed, dynamics = cfg["operation"]["pinion_speed"], cfg["dynamics"]
    ratio = float(pair["teeth"][0]) * angular_speed(pair, speed)[0] / source.natural_frequency
    oscillator = source.oscillator(dynamics, ratio)
    motion = settle(
        oscillator, rest_state(source, oscillator, dynamics), Settling(**cfg["settling"]), dynamics["tolerance"]
    )
    return {
        "running_speed": speed,
        "running_ratio": ratio,
        "running_class": np.int32(motion.motion_class),
        "running_force": motion.force_max / source.force_parameter,
        "running_contact_loss": motion.contact_loss_share,
    }


def _dataset(values: dict[str, Any], ratios: np.ndarray) -> xr.Dataset:
    names = {"order": ("order", np.array(ORDERS, dtype=object)), "gear": ("gear", np.array(GEARS, dtype=object))}
    return xr.Dataset(values, {SWEEP: ("point", ratios)} | names)
