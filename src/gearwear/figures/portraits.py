"""Phase portraits, one small panel for every value of a sweep, with the section on top."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from gearwear.errors import ConfigError
from gearwear.figures import labels, motion_classes
from gearwear.figures.sheet import DOUBLE, letter, sheet

_MOST_COLUMNS = 4
_ROW, _MARGIN = 42.0, 18.0  # mm
_ORBIT, _SECTION = "#56789A", "#D55E00"


def height(portraits: xr.Dataset, **_: Any) -> float:
    """Return the height, mm, of a sheet with these portraits."""
    return _MARGIN + _ROW * max(_rows(portraits.sizes["point"]), 1)


@sheet(DOUBLE, height)
def draw(figure: Figure, portraits: xr.Dataset, cfg: dict[str, Any]) -> None:
    """Draw every portrait; the last row is centred if it is short.

    Parameters
    ----------
    portraits : dataset with `orbit_displacement`, `orbit_velocity` (point, time), the section and the class.
    cfg : `sweep`, its settings `swept`, and the `state`.

    Raises
    ------
    ConfigError : the dataset holds no portrait.
    """
    count = portraits.sizes["point"]
    if count == 0:
        raise ConfigError(f"portraits: none of {cfg['sweep']}; list at least one value in portraits.{cfg['sweep']}")
    rows = _rows(count)
    columns = -(-count // rows)
    grid = figure.add_gridspec(rows, 2 * columns)
    for position in range(count):
        row, column = divmod(position, columns)
        in_row = min(columns, count - row * columns)
        start = 2 * column + columns - in_row
        axes = figure.add_subplot(grid[row, start : start + 2])
        portrait = portraits.isel(point=position)
        _draw_portrait(axes, portrait)
        motion = motion_classes.short(motion_classes.name_of(portrait["motion_class"].item()))
        axes.set_title(f"{letter(position)} {float(portrait[cfg['sweep']]):g}", loc="left")
        axes.set_title(f"{motion}, {_signed(float(portrait['lyapunov_exponent']))}", loc="right")
    unit = labels.length_unit(cfg["sweep"], cfg["swept"])
    figure.supxlabel(f"Displacement over {unit}")
    figure.supylabel(f"Velocity over {unit}\ntimes natural frequency", multialignment="center")
    lines = [
        Line2D([], [], color=_ORBIT, label="orbit"),
        Line2D([], [], color=_SECTION, marker="o", markersize=3, linestyle="none", label="section at pair entry"),
    ]
    title, quantity = labels.title(cfg, cfg["state"]), labels.sweep(cfg["sweep"], cfg["state"]).lower()
    titles = f"{title}\nPanels: {quantity}; motion class, largest Lyapunov exponent"
    box = figure.legend(handles=lines, title=titles, title_fontsize=7.5, loc="outside upper center", ncols=2)
    box.get_title().set_multialignment("center")


def _rows(count: int) -> int:
    return -(-count // _MOST_COLUMNS)


def _draw_portrait(axes: Axes, portrait: xr.Dataset) -> None:
    repeats = int(portrait["period"]) > 0
    section = slice(int(portrait["period"])) if repeats else slice(None)
    axes.plot(
        portrait["orbit_displacement"],
        portrait["orbit_velocity"],
        color=_ORBIT,
        linewidth=0.8 if repeats else 0.15,
        rasterized=not repeats,
    )
    axes.plot(
        portrait["section_displacement"][section],
        portrait["section_velocity"][section],
        color=_SECTION,
        marker="o",
        markersize=2.6 if repeats else 1.1,
        markeredgewidth=0,
        linestyle="none",
    )
    axes.margins(0.07)


def _signed(exponent: float) -> str:
    return f"{exponent:+.3f}".replace("-", "−") if np.isfinite(exponent) else "no exponent"
