"""The orders of a sweep side by side: classes in rows, and both motions wherever up and down differ."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from gearwear.figures import motion_classes, sections
from gearwear.motions import hysteresis

NAMES = {"restart": "from rest", "up": "upwards", "down": "downwards"}
# Okabe and Ito (2008), safe for colour-blind readers.
_STYLES: dict[str, dict[str, Any]] = {
    "up": {"color": "#E69F00", "marker": "^"},
    "down": {"color": "#009E73", "marker": "v"},
}
_SIZES = (1.0, 2.8)
_SHADE = "#ECECEC"
_BELOW = 1.5  # the dots of the order shown first lie on top

Sweeps = Mapping[str, xr.Dataset]


def ranges(values: np.ndarray, sweeps: Sweeps) -> list[tuple[float, float]]:
    """Return (low, high) of the ranges in which the sweeps up and down differ; `values` ascend."""
    differs = _differing(sweeps)
    found = motion_classes.runs(values, ["apart" if point else "alike" for point in differs])
    return [(low, high) for low, high, name in found if name == "apart"]


def shade(axes: Axes, found: Sequence[tuple[float, float]]) -> None:
    """Shade ranges of the swept quantity over the whole height."""
    for low, high in found:
        axes.axvspan(low, high, facecolor=_SHADE, edgecolor="none", zorder=0)


def draw(axes: Axes, values: np.ndarray, sweeps: Sweeps) -> None:
    """Draw the sections of the sweeps up and down where they differ."""
    differs = _differing(sweeps)
    for order, style in _STYLES.items():
        sections.draw(axes, values[differs], sweeps[order].isel(point=differs), _SIZES, zorder=_BELOW, **style)


def keys(main: str, apart: bool) -> list[Line2D | Patch]:
    """Return the legend entries of the order shown first and, if there are any, of ranges where up and down differ."""
    dot: dict[str, Any] = {"linestyle": "none", "markeredgewidth": 0}
    entries: list[Line2D | Patch] = [
        Line2D([], [], marker="o", markersize=1.8, color="black", label=f"section, {NAMES[main]}", **dot)
    ]
    if apart:
        entries += [Line2D([], [], markersize=3.0, label=NAMES[order], **dot, **_STYLES[order]) for order in _STYLES]
        entries.append(Patch(facecolor=_SHADE, edgecolor="none", label="up and down differ"))
    return entries


def _differing(sweeps: Sweeps) -> np.ndarray:
    both = [sweeps[order] for order in _STYLES]
    states = [
        np.stack([sweep["section_displacement"].values, sweep["section_velocity"].values], axis=-1) for sweep in both
    ]
    return hysteresis.differing(np.stack([sweep["motion_class"].values for sweep in both]), np.stack(states))
