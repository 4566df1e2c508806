"""Axes of the mesh: the line of action with its zones of contact, and the mesh phase, a few mesh periods side by side.

Lines keep their jumps: they are open where a pair enters or leaves.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

PERIODS = 2
_SHADE, _MARK = "#EBEBEB", "#555555"


def draw_along_path(axes: Axes, field: xr.DataArray, scale: float, **line: Any) -> None:
    """Draw a field over its `path` (m), in units of 1/`scale`; the line is open where the path has a node twice."""
    path = field["path"].values
    jumps = np.flatnonzero(np.diff(path) == 0) + 1
    axes.plot(1e3 * np.insert(path, jumps, np.nan), scale * np.insert(field.values, jumps, np.nan), **line)


def mark_path(axes: Axes, geometry: xr.Dataset) -> None:
    """Shade the zone of single contact, draw the pitch point and set limits and label of the axis."""
    _shade(axes, *_millimetres(geometry, "lowest_single_contact", "highest_single_contact"))
    (pitch,) = _millimetres(geometry, "pitch_point")
    axes.axvline(pitch, color=_MARK, linestyle=":", linewidth=0.8, zorder=1)
    axes.set_xlim(*_millimetres(geometry, "start_of_contact", "end_of_contact"))
    axes.set_xlabel("Position on the line of action, s (mm)")


def keys(with_pitch_point: bool = True) -> list[Patch | Line2D]:
    """Return the legend entries of what `mark_path`, or without the pitch point `mark_phase`, draws."""
    zone = Patch(facecolor=_SHADE, edgecolor="none", label="one pair in contact")
    pitch = Line2D([], [], color=_MARK, linestyle=":", linewidth=0.8, label="pitch point")
    return [zone, pitch] if with_pitch_point else [zone]


def name_flanks(axes: Axes, geometry: xr.Dataset, member: str) -> None:
    """Write on both sides of the pitch point, above the frame, which part of the flank is in contact there."""
    ends = _millimetres(geometry, "start_of_contact", "pitch_point", "end_of_contact")
    parts = ("dedendum", "addendum") if member == "pinion" else ("addendum", "dedendum")
    offset: dict[str, Any] = {
        "xycoords": axes.get_xaxis_transform(),
        "textcoords": "offset points",
        "ha": "center",
        "va": "bottom",
    }
    for low, high, part in zip(ends[:-1], ends[1:], parts, strict=True):
        axes.annotate(part, ((low + high) / 2, 1), (0, 2), color=_MARK, **offset)


def draw_over_phase(axes: Axes, geometry: xr.Dataset, values: np.ndarray, **line: Any) -> None:
    """Draw values of one mesh period (mesh_phase,) over `PERIODS` periods."""
    double = geometry["leaving"].values >= 0
    phase = geometry["mesh_phase"].values
    cuts = np.append(np.flatnonzero(np.diff(double)) + 1, phase.size)
    phase, values = np.insert(phase, cuts, np.nan), np.insert(np.asarray(values, dtype=float), cuts, np.nan)
    axes.plot(np.concatenate([phase + period for period in range(PERIODS)]), np.tile(values, PERIODS), **line)


def mark_phase(axes: Axes, geometry: xr.Dataset, periods: int = PERIODS) -> None:
    """Shade the zones of single contact and set limits and label of the axis."""
    leaves = float(geometry["contact_ratio"]) - 1
    for period in range(periods):
        _shade(axes, period + leaves, period + 1)
    axes.set_xlim(0, periods)
    axes.set_xticks(np.arange(periods + 1) if periods > PERIODS else np.arange(2 * periods + 1) / 2)
    axes.set_xlabel("Mesh periods since a pair entered")


def _millimetres(geometry: xr.Dataset, *names: str) -> list[float]:
    return [1e3 * float(geometry[name]) for name in names]


def _shade(axes: Axes, low: float, high: float) -> None:
    axes.axvspan(low, high, facecolor=_SHADE, edgecolor="none", zorder=0)
