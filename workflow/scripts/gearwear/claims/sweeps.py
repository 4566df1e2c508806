"""A sweep as the claims read it: swept values, motion classes and extent of the section, ascending."""

from dataclasses import dataclass

import numpy as np

from gearwear.claims import rules
from gearwear.claims.study import Study, Undecided

NOT_CONVERGED = 0
QUASI_PERIODIC = 100
CHAOTIC = 101


@dataclass(frozen=True)
class Sweep:
    """One sweep in ascending order of the swept variable.

    Attributes
    ----------
    swept : (point,) float
    motion_class : (point,) int
        0 not converged, n period n, 100 quasi-periodic, 101 chaotic.
    lowest, highest : (point,) float
        Least and greatest section displacement in half clearances; NaN where a point has no section.
    """

    swept: np.ndarray
    motion_class: np.ndarray
    lowest: np.ndarray
    highest: np.ndarray

    def require_span(self, low: float, high: float) -> None:
        """Raise `Undecided` unless the sweep spans [low, high]."""
        first, last = self.swept[0], self.swept[-1]
        if low < first - rules.GRID_TOLERANCE or high > last + rules.GRID_TOLERANCE:
            raise Undecided(f"the sweep spans {first:.4g} to {last:.4g} only")


def read_sweep(study: Study, case: str, name: str) -> Sweep:
    """Return sweep `name` of `case`; `Undecided` if it is missing or holds values that are not finite.

    The section displacement may be NaN at single points, those without a section.
    """
    swept = study.field(name, "sweep", case, name).values
    motion_class = study.field("motion_class", "sweep", case, name).values.astype(int)
    dataset = study.results["sweep", case, name]
    if "section_displacement" not in dataset.variables:
        raise Undecided(f"no variable section_displacement in sweep/{case}/{name}")
    section = dataset["section_displacement"].transpose("point", "sample").values
    has_section = np.isfinite(section).any(axis=1)
    lowest, highest = np.full(swept.size, np.nan), np.full(swept.size, np.nan)
    lowest[has_section] = np.nanmin(section[has_section], axis=1)
    highest[has_section] = np.nanmax(section[has_section], axis=1)
    order = np.argsort(swept, kind="stable")
    return Sweep(swept[order], motion_class[order], lowest[order], highest[order])


def class_code(name: str) -> int:
    """Return the code of a motion class named ``P<n>``, ``QP`` or ``CH``; ValueError for other names."""
    named = {"QP": QUASI_PERIODIC, "CH": CHAOTIC}
    if name in named:
        return named[name]
    if name.startswith("P") and name[1:].isdecimal() and 0 < int(name[1:]) < QUASI_PERIODIC:
        return int(name[1:])
    raise ValueError(f"motion class {name!r} is unknown; use P1, P2, ..., QP or CH")


def class_name(code: int) -> str:
    """Return the name of a motion class code."""
    named = {NOT_CONVERGED: "not converged", QUASI_PERIODIC: "QP", CHAOTIC: "CH"}
    return named.get(code, f"P{code}")
