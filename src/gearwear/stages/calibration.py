"""Stages of the calibration: searches of the open parameters, and their best candidates in full."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import xarray as xr

from gearwear.calibration import table
from gearwear.calibration.search import evolve
from gearwear.calibration.verdict import compared
from gearwear.claims.statements import read
from gearwear.io.tables import Table
from gearwear.run.stage import log, report


def search(cfg: dict[str, Any], claims: Path, island: str) -> xr.Dataset:
    """Return the candidates of one search.

    Parameters
    ----------
    claims : statements of the paper.
    island : number of the search, which is its seed.
    """
    found = evolve(cfg, read(claims), int(island))
    log.info(
        "%d candidates, %d of them not feasible; the best agrees with %d of %d claims in the quick look",
        found.sizes["candidate"],
        (found["candidate_remark"].values != "").sum(),
        found["claim_agrees"].values.sum(axis=1).max(),
        found.sizes["claim"],
    )
    return found


def calibration(cfg: dict[str, Any], claims: Path, searches: list[xr.Dataset]) -> dict[str, Any]:
    """Return the best candidates computed in full (`dataset`), their `parameters` and the `claims` they agree with."""
    statements = read(claims)
    found = compared(cfg, statements, searches)
    for name, row in zip(found["member"].values, found["member_agrees"].values, strict=True):
        report(f"{name}: agrees with {row.sum()} of {row.size} claims about states and motion")
    return {
        "dataset": found,
        "parameters": Table.of(table.parameters(found, cfg["calibration"])),
        "claims": Table.of(table.claims(found, statements)),
    }
