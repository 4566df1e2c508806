"""The outcomes of all members as one dataset over the axes of the study."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr

MEMBER = "member"


def axes_of(study: dict[str, Any]) -> dict[str, list[Any]]:
    """Return the axes of a study, the keys of its grid with their values, or else its members by name."""
    return dict(study["grid"]) or {MEMBER: list(study["members"])}


def gathered(axes: dict[str, list[Any]], names: Sequence[str], outcomes: Sequence[xr.Dataset]) -> xr.Dataset:
    """Return one dataset whose leading dimensions are the axes.

    Parameters
    ----------
    axes : values by key, the last key changing fastest among the members.
    names, outcomes : of all members.
    """
    sizes = tuple(len(values) for values in axes.values())
    first = outcomes[0]
    table = {}
    for name, values in first.data_vars.items():
        stacked = np.stack([one[name].values for one in outcomes])
        table[name] = ((*axes, *values.dims), stacked.reshape(*sizes, *values.shape))
    if MEMBER not in axes:
        table["member_name"] = (tuple(axes), np.array(names, dtype=object).reshape(sizes))
    coords: dict[str, Any] = {str(name): first[name] for name in first.coords}
    coords |= {key: (key, _numbers(values)) for key, values in axes.items()}
    return xr.Dataset(table, coords)


def _numbers(values: list[Any]) -> np.ndarray:
    if all(isinstance(value, int | float) and not isinstance(value, bool) for value in values):
        return np.array(values, dtype=float)
    return np.array([str(value).lower() if isinstance(value, bool) else str(value) for value in values], dtype=object)
