"""The measures of all members as one dataset and as one table, a row for every member."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import xarray as xr

from gearwear.onsets.shifts import CASES
from gearwear.sensitivity.quantities import QUANTITIES

STUDY = "study"  # name of the first row, the study itself
_DESCRIBED = {"group": "group", "key": "key", "value": "value", "usual": "usual_value", "companions": "companions"}
_FIGURES = "{:.8g}"
NOTHING = "none"


def compared(study: xr.Dataset, members: Sequence[xr.Dataset], varied: Sequence[dict[str, str]]) -> xr.Dataset:
    """Return the study and its variations along `member`.

    Parameters
    ----------
    study, members : measures of the study itself and, in the order of `varied`, of the variations that are members.
    varied : name, group, key, value, usual, companions and hindrance of every variation; one whose hindrance is not
        empty was refused by the check of the configuration and is no member.
    """
    own = iter(members)
    found = [study, *(_nothing(study, one["hindrance"]) if one["hindrance"] else next(own) for one in varied)]
    table = xr.concat(found, dim="member")
    table = table.assign_coords(member=np.array([STUDY, *(one["name"] for one in varied)], dtype=object))
    described = {
        name: ("member", np.array(["", *(one[key] for one in varied)], dtype=object))
        for key, name in _DESCRIBED.items()
    }
    return table.assign(described)


def rows(table: xr.Dataset) -> list[dict[str, str]]:
    """Return the rows: what is varied, what stands in the way, every quantity (SI), then the change of each."""
    values = {quantity.name: quantity.of(table) for quantity in QUANTITIES}
    changes = {
        quantity.name: quantity.change(values[quantity.name], values[quantity.name][0]) for quantity in QUANTITIES
    }
    found = []
    for i, member in enumerate(table["member"].values):
        row = {"member": str(member)} | {name: str(table[name].values[i]) for name in _DESCRIBED.values()}
        row["hindrance"] = "; ".join(dict.fromkeys(filter(None, table["hindrance"].values[i]))) or NOTHING
        row |= {name: _number(column[i]) for name, column in values.items()}
        row |= {f"change_{name}": _number(column[i]) for name, column in changes.items()}
        for event in ("first_doubling", "chaos_onset"):
            row |= {f"{event}_{case}_remark": str(table[f"{event}_remark"].sel(case=case).values[i]) for case in CASES}
        found.append(row)
    return found


def _nothing(study: xr.Dataset, hindrance: str) -> xr.Dataset:
    empty = study.map(lambda one: xr.full_like(one, np.nan if one.dtype.kind == "f" else ""))
    return empty.assign(hindrance=("case", np.full(study.sizes["case"], hindrance, dtype=object)))


def _number(value: float) -> str:
    return NOTHING if np.isnan(value) else _FIGURES.format(value)
