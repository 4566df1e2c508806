"""Basins of attraction, one panel for every value of a sweep: a colour for each attractor, its section on top."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from gearwear.figures import labels, motion_classes
from gearwear.figures.sheet import DOUBLE, letter, sheet

_MOST_COLUMNS = 3
# mm: margins, sides of a panel, gap between panels, height of tick labels, of a line and of a panel's title
_LEFT, _RIGHT, _TOP, _BOTTOM = 16.5, 2.0, 9.0, 6.0
_GAP, _TICKS, _LINE, _TITLE = 6.5, 4.0, 3.6, 5.0
_PANEL = (DOUBLE - _LEFT - _RIGHT - (_MOST_COLUMNS - 1) * _GAP) / _MOST_COLUMNS
_MARKS = ("o", "s", "^", "D", "v", "P", "X", "*")
_TINTS = (0.0, 0.55, -0.45, 0.3, -0.65, 0.75)  # towards white, or black, for attractors of one class
_DARKER = 0.55  # of the colour of its basin, the ink of a chaotic section
_SIZES, _HALO = (0.8, 3.4), 1.6  # of the dots of a section, and what their white rims add


def height(basins: xr.Dataset, **_: Any) -> float:
    """Return the height, mm, of a sheet with these basins."""
    rows = -(-max(basins.sizes["point"], 1) // _MOST_COLUMNS)
    return _TOP + _BOTTOM + rows * (_TITLE + _PANEL + _below(basins))


@sheet(DOUBLE, height, layout=None)
def draw(figure: Figure, basins: xr.Dataset, cfg: dict[str, Any]) -> None:
    """Draw the basins at every point.

    Parameters
    ----------
    basins : dataset of the stage `basins`.
    cfg : `sweep`, its settings `swept`, and the `state`.
    """
    count, total = basins.sizes["point"], height(basins)
    columns = min(count, _MOST_COLUMNS)
    begin = _LEFT + (_MOST_COLUMNS - columns) * (_PANEL + _GAP) / 2
    for position in range(count):
        row, column = divmod(position, columns)
        left = begin + column * (_PANEL + _GAP)
        bottom = total - _TOP - row * (_TITLE + _PANEL + _below(basins)) - _TITLE - _PANEL
        axes = figure.add_axes((left / DOUBLE, bottom / total, _PANEL / DOUBLE, _PANEL / total))
        _draw_panel(axes, basins.isel(point=position), f"{letter(position)} {float(basins[cfg['sweep']][position]):g}")
        if column:
            axes.tick_params(labelleft=False)
    unit = labels.length_unit(cfg["sweep"], cfg["swept"])
    figure.supxlabel(f"Initial displacement over {unit}", y=1.0 / total, va="bottom")
    words = f"Initial velocity over {unit}\ntimes natural frequency"
    figure.supylabel(words, x=(begin - 8.5) / DOUBLE, ha="right", multialignment="center")
    title, quantity = labels.title(cfg, cfg["state"]), labels.sweep(cfg["sweep"], cfg["state"]).lower()
    words = f"{title}\nPanels: {quantity}; below: shares of the cells of the slice"
    figure.suptitle(words, y=1 - 1.0 / total, va="top", fontsize=7.5)


def colours(names: list[str]) -> list[tuple[float, float, float]]:
    """Return a colour for each attractor by its motion class; those of one class are lighter or darker tints of it."""
    found = []
    for place, name in enumerate(names):
        tint = _TINTS[names[:place].count(name) % len(_TINTS)]
        colour = np.array(to_rgb(motion_classes.colour(name)))
        found.append(tuple(colour + tint * (1 - colour) if tint >= 0 else colour * (1 + tint)))
    return found


def _draw_panel(axes: Axes, basin: xr.Dataset, title: str) -> None:
    names = [motion_classes.name_of(code) for code in basin["motion_class"].values[: int(basin["attractors"])]]
    palette = colours(names)
    left, right = _edges(basin["initial_displacement"].values)
    bottom, top = _edges(basin["initial_velocity"].values)
    picture = np.array([*palette, to_rgb("white")])[basin["basin"].values.T]  # the undecided index -1 is the last one
    axes.imshow(picture, extent=(left, right, bottom, top), origin="lower", aspect="auto", interpolation="nearest")
    keys = []
    for place, (name, colour) in enumerate(zip(names, palette, strict=True)):
        attractor = basin.isel(attractor=place)
        keys.append(_draw_section(axes, attractor, colour, _MARKS[place % len(_MARKS)]))
        keys[-1].set_label(f"{motion_classes.short(name)}: {_percent(attractor['share'], attractor['share_error'])}")
    if float(basin["undecided_share"]) > 0:
        label = f"undecided: {_percent(basin['undecided_share'])}"
        keys.append(Patch(facecolor="white", edgecolor="black", linewidth=0.4, label=label))
    axes.set_xlim(left, right)
    axes.set_ylim(bottom, top)
    axes.set_title(title, loc="left")
    below = (0.5, -_TICKS / _PANEL)
    tight: dict[str, Any] = {"handlelength": 1.0, "handletextpad": 0.2, "columnspacing": 0.6}
    axes.legend(handles=keys, loc="upper center", bbox_to_anchor=below, ncols=2, **tight)


def _draw_section(axes: Axes, attractor: xr.Dataset, colour: tuple[float, float, float], marker: str) -> Artist:
    """Draw the section of one attractor; return its entry of the legend."""
    period = int(attractor["period"])
    section = [attractor[name].values[: period or None] for name in ("section_displacement", "section_velocity")]
    marker, size = (marker, _SIZES[1]) if period else ("o", _SIZES[0])
    layer = 3 if period else 2.5  # the few points of an orbit above the many of chaos
    halo: dict[str, Any] = {"marker": marker, "markersize": size + _HALO, "color": "white", "markeredgewidth": 0}
    axes.plot(*section, linestyle="none", zorder=layer - 0.25, **halo)
    if not period:
        dark = tuple(_DARKER * np.array(colour))
        ink: dict[str, Any] = {"marker": marker, "markersize": size, "markeredgewidth": 0, "color": dark}
        axes.plot(*section, linestyle="none", zorder=layer, **ink)
        return Patch(facecolor=colour, linewidth=0)
    ink = {"markerfacecolor": colour, "markeredgecolor": "black", "markeredgewidth": 0.6, "markersize": size}
    axes.plot(*section, linestyle="none", marker=marker, zorder=layer, **ink)
    return Line2D([], [], linestyle="none", marker=marker, **ink)


def _percent(share: xr.DataArray, error: xr.DataArray | None = None) -> str:
    if error is None:
        return f"{100 * float(share):.1f} %"
    return f"{100 * float(share):.1f} ± {100 * float(error):.1f} %"


def _edges(centres: np.ndarray) -> tuple[float, float]:
    half = (centres[1] - centres[0]) / 2
    return float(centres[0] - half), float(centres[-1] + half)


def _below(basins: xr.Dataset) -> float:
    """Return the height, mm, of what stands below a panel: tick labels and the longest legend, in two columns."""
    entries = basins["attractors"].values + (basins["undecided_share"].values > 0)
    return _TICKS + _LINE * (0.5 + -(-int(entries.max(initial=1)) // 2))
