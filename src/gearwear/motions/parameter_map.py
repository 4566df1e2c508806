"""Maps: settled motions over the mesh frequency and, across it, another parameter or a state of the pair."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
import xarray as xr

from gearwear.motions.motion_variables import columns
from gearwear.motions.settling import Attractor, Settling
from gearwear.motions.sweep import settle_from_rest
from gearwear.oscillator.excitation import Excitation
from gearwear.oscillator.oscillator import Oscillator

COORDINATES = {
    "ste": "ste",
    "backlash": "backlash",
    "temperature": "bulk_temperature",
    "wear": "running_cycles",
}
KEPT = (
    "motion_class",
    "reason",
    "conflict",
    "period",
    "lyapunov_exponent",
    "lyapunov_exponent_error",
    "transient_periods",
    "contact_loss_share",
    "force_max",
)


def values(axis: dict[str, Any] | list[float]) -> np.ndarray:
    """Return the values of an axis, a list or given by `first`, `last` and `points`."""
    if isinstance(axis, list):
        return np.array(axis, dtype=float)
    return np.linspace(axis["first"], axis["last"], axis["points"])


def tile(
    name: str,
    rows: np.ndarray,
    frequencies: np.ndarray,
    oscillators: Iterable[tuple[Excitation, list[Oscillator]]],
    cfg: dict[str, Any],
) -> xr.Dataset:
    """Return some rows of a map, every motion from rest.

    Parameters
    ----------
    name : of the map, a key of COORDINATES.
    rows, frequencies : (rows,) and (columns,), values of the axes.
    oscillators : of every row, its excitation and one oscillator a column.
    cfg : the sections `dynamics` and `settling`.
    """
    dynamics, settling = cfg["dynamics"], Settling(**cfg["settling"])
    tables = [_kept([], settling, 1.0)]
    for source, row in oscillators:
        motions = settle_from_rest(source, row, dynamics, settling)
        tables.append(_kept(motions, settling, source.force_parameter))
    whole = {key: np.concatenate([table[key] for table in tables]) for key in KEPT}
    return xr.Dataset(
        {key: (("row", "column"), found.reshape(len(rows), len(frequencies))) for key, found in whole.items()},
        {COORDINATES[name]: ("row", rows), "mesh_frequency": ("column", frequencies)},
    )


def _kept(motions: list[Attractor], settling: Settling, force_parameter: float) -> dict[str, np.ndarray]:
    table = columns(motions, settling.sampled_periods, force_parameter)
    return {key: table[key][1] for key in KEPT}
