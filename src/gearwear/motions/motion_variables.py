"""Settled motions as columns of a table: class, period and the evidence for them."""

from __future__ import annotations

from typing import Any

import numpy as np

from gearwear.motions.settling import Attractor

_RENAMED = {"exponent": "lyapunov_exponent", "exponent_error": "lyapunov_exponent_error"}
_WHOLE = (
    "motion_class",
    "reason",
    "conflict",
    "period",
    "recurrence_period",
    "stable_orbit_period",
    "transient_periods",
)
_NO_COLUMN = ("end",)  # it is the last of the section, but for motion of more than two variables
_SECTION = {"displacement": "section_displacement", "velocity": "section_velocity"}


def columns(motions: list[Attractor], samples: int, force_parameter: float) -> dict[str, Any]:
    """Return the variables of a sweep, each as (dimensions, array), from the motions at its points.

    Parameters
    ----------
    motions : one a point; may be empty.
    samples : length of every section.
    force_parameter : dimensionless mean force; the largest mesh force is given over it.
    """
    table: dict[str, Any] = {}
    for name in Attractor._fields:
        if name in _NO_COLUMN:
            continue
        values = [getattr(motion, name) for motion in motions]
        if name in _SECTION:
            table[_SECTION[name]] = (("point", "sample"), np.array(values, dtype=float).reshape(-1, samples))
            continue
        kind = np.int32 if name in _WHOLE else float
        column = np.array(values, dtype=kind)
        table[_RENAMED.get(name, name)] = ("point", column / force_parameter if name == "force_max" else column)
    return table


def end_of(motion: Attractor) -> tuple[float, ...]:
    """Return the state at the end of the sample, where the motion can be taken up again."""
    return tuple(motion.end.tolist())
