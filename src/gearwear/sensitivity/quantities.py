"""The quantities of the sensitivity table, and how far a member changes them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import xarray as xr

from gearwear.onsets.shifts import CASES

SHIFT = "shift"  # of case with against case without


class Quantity(NamedTuple):
    """One column of the table.

    variable : of the measures; case : one of CASES or SHIFT; gear : of a wear depth, else empty; relative : whether a
    change is given over the value of the study, else it is a difference.
    """

    variable: str
    case: str
    gear: str = ""
    relative: bool = True

    @property
    def name(self) -> str:
        """Its name in the table."""
        return "_".join(filter(None, [self.variable, self.gear, self.case]))

    def of(self, measures: xr.Dataset) -> np.ndarray:
        """Return the values, (members,) of a dataset along `member`; nan where a member has none."""
        column = measures[self.variable].sel(gear=self.gear) if self.gear else measures[self.variable]
        if self.case == SHIFT:
            return (column.sel(case=CASES[1]) - column.sel(case=CASES[0])).values
        return column.sel(case=self.case).values

    def change(self, values: np.ndarray, usual: float) -> np.ndarray:
        """Return how far values, (members,), differ from that of the study; nan where either is missing."""
        if not self.relative:
            return values - usual
        return values / usual - 1 if usual else np.full(len(values), np.nan)


QUANTITIES = (
    *(Quantity("mean_stiffness", case) for case in CASES),
    *(Quantity("stiffness_ripple", case) for case in CASES),
    Quantity("relative_mean_error", "with"),
    Quantity("deepest_wear", "with", "pinion"),
    Quantity("deepest_wear", "with", "gear"),
    *(Quantity("mean_half_backlash", case) for case in CASES),
    *(Quantity(event, case, relative=False) for event in ("first_doubling", "chaos_onset") for case in (*CASES, SHIFT)),
)
