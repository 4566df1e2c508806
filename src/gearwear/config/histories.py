"""Wear histories that members of studies share: each is computed once, under the name of what makes it."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Mapping
from typing import Any

from gearwear.config.slices import slice_of


def history_of(config: dict[str, Any], case: str) -> str:
    """Return the name of the wear history of a case: equal settings have equal names, however long the history."""
    settings = json.dumps(slice_of(config, "wear_history", case), sort_keys=True)
    return f"{case}_{hashlib.sha256(settings.encode()).hexdigest()[:12]}"


def updates_of(config: dict[str, Any], case: str) -> int:
    """Return the number of wear cycles of a case."""
    return round(config["cases"][case]["running_cycles"] / config["wear"]["cycles_per_update"])


def histories(wanted: Iterable[tuple[dict[str, Any], str]]) -> dict[str, dict[str, Any]]:
    """Return the settings of every wear history behind some configurations and cases, by its name.

    Returns
    -------
    name -> {"settings": the slice `wear_history`, "updates": the most wear cycles that are wanted of it}
    """
    found: dict[str, dict[str, Any]] = {}
    for config, case in wanted:
        name, updates = history_of(config, case), updates_of(config, case)
        if name not in found:
            found[name] = {"settings": slice_of(config, "wear_history", case), "updates": updates}
        found[name]["updates"] = max(found[name]["updates"], updates)
    return found


def blocks(updates: Mapping[str, int], cycles: int) -> dict[tuple[int, int], list[str]]:
    """Return the blocks of wear cycles that one job computes, and the cases that have them; none for blocks of one.

    Parameters
    ----------
    updates : wear cycles of every case.
    cycles : of a block; the last block of a case has what is left.

    Returns
    -------
    first and last wear cycle -> cases
    """
    found: dict[tuple[int, int], list[str]] = {}
    for case, most in updates.items() if cycles > 1 else ():
        for first in range(1, most + 1, cycles):
            found.setdefault((first, min(first + cycles - 1, most)), []).append(case)
    return found
