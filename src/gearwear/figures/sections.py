"""Poincare sections over a swept quantity, one dot for every mesh period until the motion repeats.

The sweeps upwards and downwards are drawn beside the one shown first wherever they differ.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from gearwear.figures import motion_classes
from gearwear.motions import hysteresis

DIRECTIONS = {"restart": "from rest", "up": "upwards", "down": "downwards"}
# Okabe and Ito (2008), safe for colour-blind readers.
_BOTH: dict[str, dict[str, Any]] = {
    "up": {"color": "#E69F00", "marker": "^"},
    "down": {"color": "#009E73", "marker": "v"},
}
_SIZES = (1.0, 2.8)
_SHADE = "#ECECEC"
_BELOW = 1.5  # the dots of the sweep shown first lie on top

Sweeps = Mapping[str, xr.Dataset]  # of one quantity, by direction


def draw(axes: Axes, values: np.ndarray, dataset: xr.Dataset, sizes: tuple[float, float], **style: Any) -> None:
    """Draw the section displacements of a sweep.

    Parameters
    ----------
    values : (points,) of the swept quantity.
    dataset : with `section_displacement` (point, sample) and `period`.
    sizes : of the dots of motions that do not repeat, and of those that do.
    style : colour, marker and order of drawing.
    """
    displacement = dataset["section_displacement"].values
    repeats, endless = chosen(dataset)
    swept_values = np.broadcast_to(values[:, None], displacement.shape)
    dots: dict[str, Any] = {"linestyle": "none", "marker": "o", "markeredgewidth": 0, "rasterized": True} | style
    axes.plot(swept_values[endless], displacement[endless], markersize=sizes[0], alpha=0.6, **dots)
    axes.plot(swept_values[repeats], displacement[repeats], markersize=sizes[1], **dots)


def chosen(dataset: xr.Dataset) -> tuple[np.ndarray, np.ndarray]:
    """Return which dots of the section (point, sample) are drawn: of motions that repeat, and of all others."""
    displacement, period = dataset["section_displacement"].values, dataset["period"].values
    finite = np.isfinite(displacement)
    sample = np.arange(displacement.shape[1])
    return finite & (sample < period[:, None]), finite & (period == 0)[:, None]


def draw_both(axes: Axes, values: np.ndarray, sweeps: Sweeps) -> None:
    """Draw the sections of the sweeps up and down where they differ."""
    differs = _differing(sweeps)
    for direction, style in _BOTH.items():
        draw(axes, values[differs], sweeps[direction].isel(point=differs), _SIZES, zorder=_BELOW, **style)


def differing_ranges(values: np.ndarray, sweeps: Sweeps) -> list[tuple[float, float]]:
    """Return (low, high) of the ranges in which the sweeps up and down differ; `values` ascend."""
    runs = motion_classes.runs(values, ["apart" if point else "alike" for point in _differing(sweeps)])
    return [(low, high) for low, high, name in runs if name == "apart"]


def shade(axes: Axes, ranges: Sequence[tuple[float, float]]) -> None:
    """Shade ranges of the swept quantity over the whole height."""
    for low, high in ranges:
        axes.axvspan(low, high, facecolor=_SHADE, edgecolor="none", zorder=0)


def keys(first: str, apart: bool) -> list[Line2D | Patch]:
    """Return the legend entries of the direction shown first and, if there are any, of ranges where both differ."""
    dot: dict[str, Any] = {"linestyle": "none", "markeredgewidth": 0}
    label = f"section, {DIRECTIONS[first]}"
    entries: list[Line2D | Patch] = [Line2D([], [], marker="o", markersize=1.8, color="black", label=label, **dot)]
    if apart:
        entries += [Line2D([], [], markersize=3.0, label=DIRECTIONS[one], **dot, **_BOTH[one]) for one in _BOTH]
        entries.append(Patch(facecolor=_SHADE, edgecolor="none", label="up and down differ"))
    return entries


def _differing(sweeps: Sweeps) -> np.ndarray:
    both = [sweeps[direction] for direction in _BOTH]
    states = [np.stack([one["section_displacement"].values, one["section_velocity"].values], axis=-1) for one in both]
    return hysteresis.differing(np.stack([one["motion_class"].values for one in both]), np.stack(states))
