"""Poincare sections over a swept quantity: one dot for every mesh period until the motion repeats."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes


def draw(axes: Axes, values: np.ndarray, dataset: xr.Dataset, sizes: tuple[float, float], **style) -> None:
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
