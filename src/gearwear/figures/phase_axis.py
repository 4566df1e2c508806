"""The mesh phase as an axis: mesh periods side by side, open lines where a pair enters or leaves."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from gearwear.figures.path_axis import shade_single_contact

PERIODS = 2


def draw(axes: Axes, geometry: xr.Dataset, values: np.ndarray, **line) -> None:
    """Draw values of one mesh period (mesh_phase,) over `PERIODS` periods."""
    double = geometry["leaving"].values >= 0
    phase = geometry["mesh_phase"].values
    change = np.flatnonzero(np.diff(double)) + 1
    cuts = np.append(change, phase.size)
    once, one = np.insert(phase, cuts, np.nan), np.insert(np.asarray(values, dtype=float), cuts, np.nan)
    axes.plot(np.concatenate([once + period for period in range(PERIODS)]), np.tile(one, PERIODS), **line)


def mark(axes: Axes, geometry: xr.Dataset, periods: int = PERIODS) -> None:
    """Shade the zones of single contact and set limits and label of the axis."""
    leaves = float(geometry["contact_ratio"]) - 1
    for period in range(periods):
        shade_single_contact(axes, period + leaves, period + 1)
    axes.set_xlim(0, periods)
    axes.set_xticks(np.arange(periods + 1) if periods > PERIODS else np.arange(2 * periods + 1) / 2)
    axes.set_xlabel("Mesh periods since a pair entered")
