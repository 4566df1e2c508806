"""Sections over a swept quantity, coloured by the largest Lyapunov exponent."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import fill
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LinearSegmentedColormap, TwoSlopeNorm
from matplotlib.figure import Figure

from gearwear.figures import labels, sections
from gearwear.figures.sheet import DOUBLE, letter, sheet

_LABEL = "Largest Lyapunov exponent (per unit of dimensionless time)"
# Blue and vermilion of Okabe and Ito (2008), dark between them so that dots near zero show on white.
_STOPS = ("#7CC4F2", "#0072B2", "#101010", "#D55E00", "#F7B267")
_COLOURS = LinearSegmentedColormap.from_list("exponents", _STOPS).with_extremes(bad="#9A9A9A")
_LEAST_SPAN = 1e-3
_LOWEST_PERCENTILE = 2.0  # a few strongly contracting points would take all the colours
_SIZES = (0.15, 1.2)  # square points
_LONGEST_LINE = 40  # letters below a panel


def norm(values: np.ndarray) -> TwoSlopeNorm:
    """Return the scale of colours for these exponents, zero in its middle; some of them must be finite."""
    known = values[np.isfinite(values)]
    lowest = min(np.percentile(known, _LOWEST_PERCENTILE), -_LEAST_SPAN)
    return TwoSlopeNorm(0.0, lowest, max(known.max(), _LEAST_SPAN))


def _height(sweeps: Sequence[xr.Dataset], **_: Any) -> float:
    return 22.0 + 58.0 * -(-len(sweeps) // 2)


@sheet(DOUBLE, _height)
def draw(figure: Figure, sweeps: Sequence[xr.Dataset], cfg: dict[str, Any]) -> None:
    """Draw one panel for every sweep, two in a row, all on one scale of colours.

    Parameters
    ----------
    cfg : `panels`, of every sweep `sweep`, its settings `swept` and the `state`.
    """
    grid = figure.subplots(-(-len(sweeps) // 2), 2, squeeze=False)
    scale = norm(np.concatenate([dataset["lyapunov_exponent"].values for dataset in sweeps]))
    for position, (dataset, panel) in enumerate(zip(sweeps, cfg["panels"], strict=True)):
        axes = grid.flat[position]
        _draw_section(axes, dataset, panel["sweep"], scale)
        title = labels.title(panel, panel["state"], separator="\n")
        axes.set_title(f"{letter(position)} {title}", loc="left")
        axes.set_xlabel(fill(labels.sweep(panel["sweep"], panel["state"]), _LONGEST_LINE))
        axes.set_ylabel(f"Section displacement over\n{labels.length_unit(panel['sweep'], panel['swept'])}")
    for axes in grid.flat[len(sweeps) :]:
        axes.remove()
    key = ScalarMappable(scale, _COLOURS)
    figure.colorbar(key, ax=figure.axes, location="top", extend="min", aspect=50, shrink=0.6, label=_LABEL)


def _draw_section(axes: Axes, dataset: xr.Dataset, sweep: str, scale: TwoSlopeNorm) -> None:
    displacement, values = dataset["section_displacement"].values, dataset[sweep].values
    exponent = dataset["lyapunov_exponent"].values
    spread = [np.broadcast_to(one[:, None], displacement.shape) for one in (values, exponent)]
    repeats, endless = sections.chosen(dataset)
    for dots, size in ((endless, _SIZES[0]), (repeats, _SIZES[1])):
        place, colour = (one[dots] for one in spread)
        axes.scatter(
            place,
            displacement[dots],
            size,
            colour,
            norm=scale,
            cmap=_COLOURS,
            linewidths=0,
            plotnonfinite=True,
            rasterized=True,
        )
    axes.set_xlim(values.min(), values.max())
