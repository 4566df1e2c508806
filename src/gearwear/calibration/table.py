"""The result of a calibration as two tables: the parameters, and the claims."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import xarray as xr

from gearwear.calibration.agreement import judged
from gearwear.claims.scorecard import expectation
from gearwear.config.calibration_parameters import NAMES, PARAMETERS

STUDY = "study"  # the values of the configuration itself, computed like the best ones
_FIGURES = "{:.6g}"
_GOOD = 2  # claims fewer than the best candidate of the searches: still good


def parameters(found: xr.Dataset, settings: Mapping[str, Any]) -> list[dict[str, str]]:
    """Return a row a parameter: its range, its value in the study and in the best candidates, the spread of good ones.

    Good is a candidate of the searches with at most two claims less than the best of them.

    Parameters
    ----------
    found : as verdict.compared gives it.
    settings : the section `calibration`.
    """
    rows, chosen = [], good(found)
    for name in NAMES:
        row = {"parameter": name, "unit": PARAMETERS[name][0]}
        row |= {end: _FIGURES.format(settings[name][end]) for end in ("low", "high")}
        for member, own in zip(found["member"].values, found[f"member_{name}"].values, strict=True):
            row[str(member)] = _FIGURES.format(own)
        values = found[f"candidate_{name}"].values[chosen]
        row |= {"good_least": _FIGURES.format(values.min()), "good_greatest": _FIGURES.format(values.max())}
        rows.append(row)
    return rows


def claims(found: xr.Dataset, statements: Sequence[Mapping[str, Any]]) -> list[dict[str, str]]:
    """Return a row a claim: what it expects, who agrees, in which share of the good candidates and of all it does."""
    agrees, members, chosen, rows = found["claim_agrees"].values, found["member_agrees"].values, good(found), []
    for i, claim in enumerate(judged(statements)):
        row = {"claim": claim["id"], "expected": expectation(claim)}
        row |= {str(name): "agrees" if members[m, i] else "differs" for m, name in enumerate(found["member"].values)}
        row |= {"share_of_good": f"{agrees[chosen, i].mean():.3f}", "share_of_all": f"{agrees[:, i].mean():.4f}"}
        rows.append(row)
    return rows


def good(found: xr.Dataset) -> np.ndarray:
    """Return which candidates of the searches are good, (candidates,) bool."""
    counts = found["claim_agrees"].values.sum(axis=1)
    return counts >= counts.max() - _GOOD
