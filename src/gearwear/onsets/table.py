"""The shifts of the onsets as one table, a row for every event."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.codes.onset_codes import ERRORS, LOCATED, TOTAL
from gearwear.onsets.shifts import CASES, drawn, span, spread

_FIGURES = "{:.6f}"
NO_NUMBER = "none"


def rows(table: xr.Dataset) -> list[dict[str, str]]:
    """Return the rows: shift, its span over the ways of computing, error, ensemble, faces of the box, what lacks.

    `error_*` are how far the ways that vary one thing lead from the usual sweep, `numerical_error` how far any leads
    from the shift. The ways that miss an event count in no error, so they are named. All shifts are mesh frequencies
    over the natural frequency of each case, that of case `with` less that of case `without`: negative where `with`
    comes earlier.
    """
    statistics, inside = spread(table), drawn(table)
    low, high = span(table)
    found = []
    for i, event in enumerate(table["event"].values):
        error = dict(zip(ERRORS, table["shift_error"].values[:, i], strict=True))
        row = {"event": str(event)}
        row |= {case: _number(table[f"onset_{case}"].values[i]) for case in CASES}
        row |= {"shift": _number(table["onset_shift"].values[i])}
        row |= {"lowest": _number(low[i]), "highest": _number(high[i]), "numerical_error": _small(error.pop(TOTAL))}
        row |= {f"error_{name}": _small(value) for name, value in error.items()}
        row["ways_without_the_event"] = "; ".join(_ways_without(table, i)) or NO_NUMBER
        row |= {"members": str(int(inside.sum())), "members_with_event": str(int(statistics["exists"][i]))}
        row |= {
            name: _number(statistics[key][i])
            for name, key in (("median", "median"), ("percentile_5", "low"), ("percentile_95", "high"))
        }
        row["share_earlier"] = NO_NUMBER if np.isnan(statistics["earlier"][i]) else f"{statistics['earlier'][i]:.2f}"
        for name, value in zip(table["member"].values[~inside], table["member_shift"].values[~inside, i], strict=True):
            row[str(name)] = _number(value)
        row["lacking"] = "; ".join(_lacking(table, i)) or NO_NUMBER
        found.append(row)
    return found


def _ways_without(table: xr.Dataset, event: int) -> list[str]:
    """Return the ways of computing that do not show the event in both cases: they count in no error."""
    missing = np.isnan(table["variant_shift"].values[:, event])
    return [str(name) for name, lacks in zip(table["variant"].values, missing, strict=True) if lacks]


def _lacking(table: xr.Dataset, event: int) -> Any:
    for position in np.flatnonzero(np.isnan(table["member_shift"].values[:, event])):
        member = table["member"].values[position]
        for case in CASES:
            if table[f"member_how_{case}"].values[position, event] not in LOCATED:
                yield f"{member} {case}: {table[f'member_remark_{case}'].values[position, event]}"


def _number(value: float) -> str:
    return NO_NUMBER if np.isnan(value) else _FIGURES.format(value)


def _small(value: float) -> str:
    return NO_NUMBER if np.isnan(value) else f"{value:.1e}"
