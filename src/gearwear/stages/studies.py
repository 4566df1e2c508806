"""Stages of studies and of the sensitivity: members of a configuration, and what they have in common."""

from __future__ import annotations

from typing import Any

import xarray as xr

from gearwear.io.tables import Table
from gearwear.run.stage import report
from gearwear.sensitivity import measures as of_member
from gearwear.sensitivity import table as sensitivity_table
from gearwear.studies import outcome as of_combination
from gearwear.studies import table
from gearwear.studies.gathering import axes_of, gathered


def outcome(cfg: dict[str, Any], history: xr.Dataset) -> xr.Dataset:
    """Return the motions over the speed for one combination of a study.

    Parameters
    ----------
    cfg : `settings`, the slice `outcome`; `update`, the wear cycle; `member`, its folder.
    """
    found = of_combination.outcome(cfg["settings"], history, cfg["update"])
    if reason := found["hindrance"].item():
        report(f"{cfg['member']}: not feasible: {reason}")
    return found


def study(cfg: dict[str, Any], outcomes: list[xr.Dataset]) -> dict[str, Any]:
    """Return the outcomes of all members (`data`), their `table`, and the safe speeds (`lives`).

    Parameters
    ----------
    cfg : the slice `study`; `study`, `members` (name and reason why it is none), `units` and `meanings` of the axes.
    outcomes : of the members that are feasible configurations, in their order.
    """
    own = iter(outcomes)
    found = [
        of_combination.impossible(cfg["sweeps"]["mesh_frequency"], one["reason"]) if one["reason"] else next(own)
        for one in cfg["members"]
    ]
    axes = axes_of(cfg["study"])
    data = gathered(axes, [one["name"] for one in cfg["members"]], found)
    for key in cfg["meanings"]:
        data[key].attrs = {"long_name": cfg["meanings"][key]} | (
            {"units": cfg["units"][key]} if cfg["units"][key] else {}
        )
    lives = table.sentences(data, {key: cfg["units"].get(key, "") for key in axes})
    for life in lives:
        report(life["sentence"])
    rows = table.rows(data, list(axes), cfg["sweeps"]["order"])
    return {"data": data, "table": Table.of(rows), "lives": Table.of(lives)}


def measures(cfg: dict[str, Any]) -> xr.Dataset:
    """Return the measures of one member of the sensitivity."""
    return of_member.measures(cfg)


def sensitivity_comparison(cfg: dict[str, Any], study: xr.Dataset, members: list[xr.Dataset]) -> dict[str, Any]:
    """Return what every option and open parameter changes: `measures` of all members, and their `table`.

    Parameters
    ----------
    cfg : the slice of that name; `varied`, every variation and the reason where it is no member.
    study : measures of the study itself.
    """
    compared = sensitivity_table.compared(study, members, cfg["varied"])
    rows = sensitivity_table.rows(compared)
    for row in rows:
        if row["hindrance"] != sensitivity_table.NOTHING:
            report(f"{row['key']} {row['value']}: not feasible: {row['hindrance']}")
    return {"measures": compared, "table": Table.of(rows)}
