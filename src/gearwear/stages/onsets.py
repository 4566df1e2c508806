"""Stages of the onsets of period doublings and chaos."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.chain.geometry import geometry
from gearwear.chain.history import last_state
from gearwear.codes.onset_codes import ORDERS, VARIANTS
from gearwear.config import ensemble
from gearwear.io.tables import Table
from gearwear.motions.settling import Settling
from gearwear.onsets import route, route_to_chaos, table
from gearwear.onsets.onset_variables import columns
from gearwear.onsets.shifts import CASES, shifts
from gearwear.oscillator.excitation import excitation as excitation_of
from gearwear.oscillator.excitation_variables import recorded
from gearwear.run.stage import report


def case_onsets(
    cfg: dict[str, Any], excitation: xr.Dataset, main_sweep: xr.Dataset, branches: xr.Dataset
) -> xr.Dataset:
    """Return the onsets of a case along its main sweep over the mesh frequency."""
    state = _state(cfg, excitation, branches)
    events = route.along(state, main_sweep, cfg["sweeps"]["order"], cfg["onsets"]["refinement"])
    return xr.Dataset(columns([events])).set_coords("event")


def onset_variants(
    cfg: dict[str, Any], excitation: xr.Dataset, sweeps: list[xr.Dataset], branches: xr.Dataset
) -> xr.Dataset:
    """Return the onsets of a case for every direction, start, settling time, step and integrator."""
    state, refinement = _state(cfg, excitation, branches), cfg["onsets"]["refinement"]
    by_order = dict(zip(ORDERS, sweeps, strict=True))
    ways = {order: route.along(state, by_order[order], order, refinement) for order in ORDERS}
    ways |= route.varied(state, by_order["restart"], ways["restart"], refinement)
    found = columns([ways[name] for name in VARIANTS]) | {"variant": ("variant", np.array(VARIANTS, dtype=object))}
    return xr.Dataset(found).set_coords(["event", "variant"])


def member_onsets(cfg: dict[str, Any]) -> xr.Dataset:
    """Return the onsets of both cases of a member of the ensemble, with the wear histories behind them."""
    pair, dynamics, order = geometry(cfg), cfg["dynamics"], cfg["sweeps"]["order"]
    reference = last_state(cfg, pair, dynamics["reference_case"])
    found = []
    for case in CASES:
        state = last_state(cfg, pair, case, reference)
        source = excitation_of(pair, state, reference, cfg["operation"]["pinion_torque"], dynamics)
        sweeps = [route_to_chaos.swept(cfg, source, one) for one in sorted(ORDERS, key=lambda one: one != order)]
        events = route_to_chaos.events(cfg, source, sweeps, cfg["branches"]["largest_period"])
        found.append(xr.Dataset(columns([events])).set_coords("event"))
    return xr.concat(found, dim="case").assign_coords(case=np.array(CASES, dtype=object))


def onset_shifts(
    cfg: dict[str, Any], onsets: list[xr.Dataset], variants: list[xr.Dataset], members: list[xr.Dataset]
) -> dict[str, Any]:
    """Return the shifts of the onsets between the two cases (`shifts`) and their `table`.

    Parameters
    ----------
    onsets, variants : of the two cases.
    members : of the ensemble.
    """
    factors = ensemble.factors(cfg["onsets"])
    of_members = {
        case: {name: one.sel(case=case) for name, one in zip(factors, members, strict=True)} for case in CASES
    }
    own, varied = (dict(zip(CASES, several, strict=True)) for several in (onsets, variants))
    compared = shifts(own, varied, of_members, cfg["sweeps"]["order"], factors)
    rows = table.rows(compared)
    for row in rows:
        report(
            f"{row['event']}: with less without {row['shift']}, {row['lowest']} to {row['highest']} over ways of "
            f"computing; ensemble {row['percentile_5']} to {row['percentile_95']}, {row['members_with_event']} of "
            f"{row['members']} members"
        )
    return {"shifts": compared, "table": Table.of(rows)}


def _state(cfg: dict[str, Any], excitation: xr.Dataset, branches: xr.Dataset) -> route.State:
    return route.State(recorded(excitation), cfg["dynamics"], Settling(**cfg["settling"]), branches)
