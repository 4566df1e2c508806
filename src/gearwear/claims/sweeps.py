"""A sweep as the claims read it: swept values, motion classes and extent of the section, ascending."""

from dataclasses import dataclass

import numpy as np

from gearwear.claims import rules
from gearwear.claims.study import Study, Undecided
from gearwear.codes.motion_class import CHAOTIC, NOT_CONVERGED, QUASI_PERIODIC
from gearwear.errors import BadFile


@dataclass(frozen=True)
class Sweep:
    """One sweep in ascending order of the swept variable.

    Attributes
    ----------
    swept : (point,) float
    motion_class : (point,) int
        0 not converged, n period n, 100 quasi-periodic, 101 chaotic.
    extent : (point, 4) float
        Least and greatest displacement and velocity of the section, in half clearances and half clearances times
        the natural frequency; NaN where a point has no section.
    """

    swept: np.ndarray
    motion_class: np.ndarray
    extent: np.ndarray

    def require_span(self, low: float, high: float) -> None:
        """Raise `Undecided` unless the sweep spans [low, high]."""
        first, last = self.swept[0], self.swept[-1]
        if low < first - rules.GRID_TOLERANCE or high > last + rules.GRID_TOLERANCE:
            raise Undecided(f"the sweep spans {first:.4g} to {last:.4g} only")


def read_sweep(study: Study, case: str, name: str) -> Sweep:
    """Return sweep `name` of `case`; `Undecided` if it is missing or holds values that are not finite.

    The section may be NaN at single points, those without one.
    """
    swept = study.field(name, "sweep", case, name).values
    motion_class = study.field("motion_class", "sweep", case, name).values.astype(int)
    dataset = study.results["sweep", case, name]
    extent = np.full((swept.size, 4), np.nan)
    for column, variable in ((0, "section_displacement"), (2, "section_velocity")):
        if variable not in dataset.variables:
            raise Undecided(f"no variable {variable} in sweep/{case}/{name}")
        section = dataset[variable].transpose("point", "sample").values
        known = np.isfinite(section).any(axis=1)
        extent[known, column] = np.nanmin(section[known], axis=1)
        extent[known, column + 1] = np.nanmax(section[known], axis=1)
    order = np.argsort(swept, kind="stable")
    return Sweep(swept[order], motion_class[order], extent[order])


def class_code(name: str) -> int:
    """Return the code of a motion class named ``P<n>``, ``QP`` or ``CH``; ValueError for other names."""
    named = {"QP": QUASI_PERIODIC, "CH": CHAOTIC}
    if name in named:
        return named[name]
    if name.startswith("P") and name[1:].isdecimal() and 0 < int(name[1:]) < QUASI_PERIODIC:
        return int(name[1:])
    raise BadFile(f"motion class {name!r} is unknown; use P1, P2, ..., QP or CH")


def class_name(code: int) -> str:
    """Return the name of a motion class code."""
    named = {NOT_CONVERGED: "not converged", QUASI_PERIODIC: "QP", CHAOTIC: "CH"}
    return named.get(code, f"P{code}")
