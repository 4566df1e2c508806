"""The line of action as an axis: zones, pitch point, and lines that keep their jumps."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

LABEL = "Position on the line of action, s (mm)"
_SHADE, _MARK = "#EBEBEB", "#555555"


def millimetres(field: xr.DataArray) -> float:
    """Return a length (scalar, m) in mm."""
    return 1e3 * float(field)


def draw(axes: Axes, field: xr.DataArray, scale: float, **line) -> None:
    """Draw a field over its `path` (m), in units of 1/`scale`; the line is open where the path has a node twice."""
    path = field["path"].values
    jumps = np.flatnonzero(np.diff(path) == 0) + 1
    axes.plot(1e3 * np.insert(path, jumps, np.nan), scale * np.insert(field.values, jumps, np.nan), **line)


def mark(axes: Axes, geometry: xr.Dataset) -> None:
    """Shade the zone of single contact, draw the pitch point and set limits and label of the axis."""
    zone = [millimetres(geometry[name]) for name in ("lowest_single_contact", "highest_single_contact")]
    shade_single_contact(axes, *zone)
    axes.axvline(millimetres(geometry["pitch_point"]), color=_MARK, linestyle=":", linewidth=0.8, zorder=1)
    axes.set_xlim(millimetres(geometry["start_of_contact"]), millimetres(geometry["end_of_contact"]))
    axes.set_xlabel(LABEL)


def keys(with_pitch_point: bool = True) -> list[Patch | Line2D]:
    """Return the legend entries of what `mark` draws."""
    zone = Patch(facecolor=_SHADE, edgecolor="none", label="one pair in contact")
    pitch = Line2D([], [], color=_MARK, linestyle=":", linewidth=0.8, label="pitch point")
    return [zone, pitch] if with_pitch_point else [zone]


def name_flanks(axes: Axes, geometry: xr.Dataset, member: str) -> None:
    """Write on both sides of the pitch point, above the frame, which part of the flank is in contact there."""
    ends = [millimetres(geometry[name]) for name in ("start_of_contact", "pitch_point", "end_of_contact")]
    parts = ("dedendum", "addendum") if member == "pinion" else ("addendum", "dedendum")
    for low, high, part in zip(ends[:-1], ends[1:], parts, strict=True):
        axes.annotate(
            part,
            ((low + high) / 2, 1),
            (0, 2),
            xycoords=axes.get_xaxis_transform(),
            textcoords="offset points",
            ha="center",
            va="bottom",
            color=_MARK,
        )


def shade_single_contact(axes: Axes, low: float, high: float) -> None:
    """Shade a zone of single contact on any axis."""
    axes.axvspan(low, high, facecolor=_SHADE, edgecolor="none", zorder=0)
