"""Shift of the onsets of doublings and chaos: over ways of computing, over the ensemble, one parameter at a time."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator, NullLocator

from gearwear.config.ensemble import NOMINAL
from gearwear.figures.sheet import DOUBLE, legend_above, letter, sheet
from gearwear.onsets.shifts import drawn, span, spread

_NAMES = {
    "damping_ratio": "damping ratio",
    "bore_radius": "bore radius",
    "pinion_torque": "pinion torque",
    "pressure_viscosity": "pressure-viscosity",
}
# Okabe and Ito (2008), safe for colour-blind readers; low and high differ in shape.
_INK, _DOTS, _LOW, _HIGH = "#000000", "#56B4E9", "#0072B2", "#D55E00"
_ENDS: dict[str, dict[str, Any]] = {"low": {"marker": "v", "color": _LOW}, "high": {"marker": "^", "color": _HIGH}}
_MARK: dict[str, Any] = {"linestyle": "none", "markeredgewidth": 0}
_HEIGHT_OF_ROW = 0.3  # over which the members are spread, either way
_GOLDEN = 0.6180339887  # spreads them evenly, in any number
_ROOM = 0.08  # of the range, left and right


@sheet(DOUBLE, 82.0)
def draw(figure: Figure, shifts: xr.Dataset, cfg: dict[str, Any]) -> None:
    """Draw a panel for every event, on one scale; rows are the study, the drawn members, and every parameter alone.

    Parameters
    ----------
    shifts : as onsets.shifts.shifts gives it.
    """
    panels = figure.subplots(1, shifts.sizes["event"], sharey=True, sharex=True)
    parameters = [str(name) for name in shifts["parameter"].values]
    inside = int(drawn(shifts).sum())
    low, high = _extent(shifts)
    for position, (axes, event) in enumerate(zip(panels, shifts["event"].values, strict=True)):
        axes.axvline(0.0, color=_INK, linewidth=0.5, dashes=(4, 2))
        _draw_study(axes, 0, shifts, position)
        _draw_members(axes, 1, shifts, position)
        for row, name in enumerate(parameters, start=2):
            _draw_alone(axes, row, shifts, position, name)
        axes.set_title(f"{letter(position)} {event}", loc="left")
        axes.xaxis.set_major_locator(MaxNLocator(3))
        axes.yaxis.set_minor_locator(NullLocator())
        axes.tick_params(axis="y", which="both", length=0)
    axes.set_xlim(low, high)
    axes.set_ylim(len(parameters) + 1.6, -0.6)
    labels = [
        "this study",
        f"ensemble of {inside}",
        *(f"{_NAMES[name]}\n{_range(shifts, name)}" for name in parameters),
    ]
    panels[0].set_yticks(range(len(labels)), labels)
    figure.supxlabel("Onset in case “with” less that in case “without”, mesh frequency over natural frequency")
    legend_above(figure, _keys(), 5)


def _draw_study(axes: Axes, row: int, table: xr.Dataset, event: int) -> None:
    shift = float(table["onset_shift"].values[event])
    if np.isnan(shift):
        _say(axes, row, "no such event")
        return
    low, high = (float(ends[event]) for ends in span(table))
    reach = [[shift - low], [high - shift]]
    axes.errorbar(shift, row, xerr=reach, color=_INK, marker="D", markersize=3.2, linewidth=0.8, capsize=2.2)
    axes.axvline(shift, color=_INK, linewidth=0.3, alpha=0.5)


def _draw_members(axes: Axes, row: int, table: xr.Dataset, event: int) -> None:
    values = table["member_shift"].values[drawn(table), event]
    if not np.isfinite(values).any():
        _say(axes, row, "no such event" if len(values) else "no members")
        return
    offset = (np.arange(1, len(values) + 1) * _GOLDEN % 1.0 - 0.5) * 2 * _HEIGHT_OF_ROW
    axes.plot(values, row + offset, marker="o", markersize=2.4, color=_DOTS, **_MARK)
    found = {name: numbers[event] for name, numbers in spread(table).items()}
    if np.isfinite(found["median"]):
        axes.plot([found["low"], found["high"]], [row, row], color=_INK, linewidth=0.8)
        axes.plot([found["median"]] * 2, [row - _HEIGHT_OF_ROW, row + _HEIGHT_OF_ROW], color=_INK, linewidth=1.2)
    if found["exists"] < len(values):
        _say(axes, row + _HEIGHT_OF_ROW, f"{found['exists']} of {len(values)}")


def _draw_alone(axes: Axes, row: int, table: xr.Dataset, event: int, name: str) -> None:
    shift, lacking = float(table["onset_shift"].values[event]), []
    for end, style in _ENDS.items():
        member = f"{name}_{end}"
        if member not in table["member"].values:
            continue
        value = float(table["member_shift"].sel(member=member).values[event])
        if np.isnan(value):
            lacking.append(end)
            continue
        axes.plot([shift, value], [row, row], color=style["color"], linewidth=0.8)
        axes.plot(value, row, markersize=4.0, **_MARK, **style)
    if lacking:
        _say(axes, row + _HEIGHT_OF_ROW, f"none at {' and '.join(lacking)}")


def _say(axes: Axes, row: float, words: str) -> None:
    axes.annotate(
        words, (0.03, row), xycoords=("axes fraction", "data"), va="center", fontsize=6, color=_INK, fontstyle="italic"
    )


def _range(table: xr.Dataset, name: str) -> str:
    factors = table["factor"].sel(parameter=name)
    ends = [float(factors.sel(member=f"{name}_{end}")) for end in _ENDS if f"{name}_{end}" in table["member"].values]
    return "× " + " and ".join(f"{value:g}" for value in ends) if ends else f"× {NOMINAL:g}"


def _extent(table: xr.Dataset) -> tuple[float, float]:
    values = np.concatenate([[0.0], *span(table), table["member_shift"].values.ravel()])
    low, high = np.nanmin(values), np.nanmax(values)
    room = _ROOM * (high - low) or 0.01
    return low - room, high + room


def _keys() -> list[Line2D]:
    return [
        Line2D([], [], color=_INK, marker="D", markersize=3.2, linewidth=0.8, label="shift, ways of computing"),
        Line2D([], [], marker="o", markersize=2.4, color=_DOTS, label="drawn member", **_MARK),
        Line2D([], [], color=_INK, linewidth=0.8, marker="|", markersize=6, label="5-95 %, median"),
        *(
            Line2D([], [], markersize=4.0, linewidth=0.8, label=f"one parameter {words}", **_ENDS[end])
            for end, words in (("low", "lowest"), ("high", "highest"))
        ),
    ]
