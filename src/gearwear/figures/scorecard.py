"""The scorecard of the claims as one page: every statement, what was found, and strips of the motion classes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import xarray as xr

from gearwear.errors import BadFile
from gearwear.figures import motion_classes
from gearwear.io.tables import render

_MARGIN = 0.5  # of the width of a window, shown on either side of it
_LEAST_SPAN = 0.05  # of the swept range: a window of one point is shown with its neighbours
_GROUPS = (
    ("Wear", ("6",)),
    ("Contact temperature and growth of the flanks", ("text", "7")),
    ("Mesh stiffness and transmission error", ("8", "9", "10")),
    ("Backlash", ("11",)),
    ("Motion over the mesh frequency", ("12", "13", "14")),
    ("Motion over the transmission error", ("15", "16")),
    ("Motion over the backlash", ("17", "18")),
)


def page(
    template: str,
    rows: Sequence[Mapping[str, str]],
    claims: Sequence[Mapping[str, Any]],
    sweeps: Mapping[tuple[str, str], xr.Dataset],
) -> str:
    """Return the page as HTML that needs no other file; all text is escaped.

    Parameters
    ----------
    template : of the page, Jinja.
    rows : of the scorecard, in the order of the claims.
    claims : the statements, as in `config/paper_claims.yaml`.
    sweeps : datasets of the sweeps by case and swept quantity.
    """
    shown: list[dict[str, Any]] = [
        {**row, "strips": _strips(claim, sweeps)} for row, claim in zip(rows, claims, strict=True)
    ]
    groups: list[dict[str, Any]] = []
    for title, figures in _GROUPS:
        members = [row for row in shown if row["figure"].rstrip("abcd") in figures]
        groups.append({"title": title, "rows": members, "agree": _agree(members)})
    left_out = len(rows) - sum(len(group["rows"]) for group in groups)
    if left_out:
        raise BadFile(f"claims: {left_out} belong to no group of the page; name their figures in figures/scorecard.py")
    names = {zone["name"] for row in shown for strip in row["strips"] for zone in strip["zones"]}
    key = [{"name": name, "colour": motion_classes.colour(name)} for name in sorted(names, key=motion_classes.rank)]
    return render(template, groups=groups, key=key, agree=_agree(rows), total=len(rows))


def _agree(rows: Sequence[Mapping[str, str]]) -> int:
    return sum(row["verdict"] == "agree" for row in rows)


def _strips(claim: Mapping[str, Any], sweeps: Mapping[tuple[str, str], xr.Dataset]) -> list[dict[str, Any]]:
    """Return the stated window and, below it, the computed classes of every case around it; none for other claims."""
    if claim["kind"] != "window":
        return []
    name, (low, high) = claim["sweep"], claim["range"]
    cases = [claim["case"]] if isinstance(claim["case"], str) else claim["case"]
    found = {case: sweeps[case, name].sortby(name) for case in cases if (case, name) in sweeps}
    if not found:
        return []
    ends = np.array([[dataset[name].values[0], dataset[name].values[-1]] for dataset in found.values()])
    first, last = ends[:, 0].min(), ends[:, 1].max()
    room = max(_MARGIN * (high - low), (_LEAST_SPAN * (last - first) - (high - low)) / 2)
    left, right = max(first, low - room), min(last, high + room)
    strips = [_strip("paper", [(low, high, claim["class"][0])], left, right)]
    for case, dataset in found.items():
        names = [motion_classes.name_of(code) for code in dataset["motion_class"].values]
        strips.append(_strip(case, motion_classes.runs(dataset[name].values, names), left, right))
    strips[0]["ends"] = [f"{left:.3g}", f"{right:.3g}"]
    return strips


def _strip(label: str, runs: Any, left: float, right: float) -> dict[str, Any]:
    """Return the zones of one row in per cent of its width."""
    zones = []
    for low, high, name in runs:
        low, high = max(low, left), min(high, right)
        if high > low or (label == "paper" and high == low):
            start, width = 100 * (low - left) / (right - left), 100 * (high - low) / (right - left)
            zones.append(
                {
                    "name": name,
                    "start": f"{start:.2f}",
                    "width": f"{max(width, 0.7):.2f}",
                    "colour": motion_classes.colour(name),
                }
            )
    return {"label": label, "zones": zones}
