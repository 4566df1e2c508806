"""Bifurcation diagrams, one below the other: classes, section, periodic orbits and exponent along one sweep."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from gearwear.drawing import branches, motion_classes, states, swept
from gearwear.drawing.sheet import DOUBLE, letter

# Heights and margins, mm.
_LEFT, _RIGHT, _TOP, _BOTTOM = 18.0, 3.0, 11.0, 10.0
_ROW = 4.0  # of the legend
_TITLE, _STRIP, _SECTION, _EXPONENT, _GAP, _BETWEEN = 5.0, 7.0, 42.0, 14.0, 1.2, 5.0
_DIAGRAM = _TITLE + _STRIP + _GAP + _SECTION + _GAP + _EXPONENT
_LABEL = -9.5  # mm, right edge of the ordinate's label from the axis
_INK, _CHAOS = "#1A1A1A", "#D55E00"

Windows = Sequence[tuple[float, float, str]]


def height(count: int) -> float:
    """Return the height, mm, of a sheet with this number of diagrams."""
    return _TOP + _BOTTOM + count * _DIAGRAM + (count - 1) * _BETWEEN


def draw(
    figure: Figure,
    sweeps: Sequence[xr.Dataset],
    orbits: Sequence[xr.Dataset],
    paper: Sequence[Windows],
    cfg: dict[str, Any],
) -> None:
    """Draw one diagram for every sweep, from top to bottom.

    Parameters
    ----------
    sweeps : datasets of the sweep of `cfg["sweep"]`.
    orbits : branches of periodic orbits, for every sweep.
    paper : (low, high, class) of the windows of motion the paper names, for every sweep.
    cfg : `sweep`, its settings `swept`, and the `states` in the order of `sweeps`.
    """
    names: set[str] = set()
    special: set[int] = set()
    total = height(len(sweeps))
    for position, (dataset, followed, windows, state) in enumerate(
        zip(sweeps, orbits, paper, cfg["states"], strict=True)
    ):
        top = total - _TOP - position * (_DIAGRAM + _BETWEEN) - _TITLE
        strip = _place(figure, top - _STRIP, _STRIP, total)
        section = _place(figure, top - _STRIP - _GAP - _SECTION, _SECTION, total)
        exponent = _place(figure, top - _STRIP - _SECTION - 2 * _GAP - _EXPONENT, _EXPONENT, total)
        dataset = dataset.sortby(cfg["sweep"])
        values = dataset[cfg["sweep"]].values
        for axes in (strip, section, exponent):
            axes.set_xlim(values[0], values[-1])
        found = [motion_classes.name_of(code) for code in dataset["motion_class"].values]
        names |= {*found, *(window[2] for window in windows)}
        _draw_classes(strip, motion_classes.runs(values, found), windows)
        _draw_section(section, values, dataset)
        branches.draw(section, cfg["sweep"], followed)
        special |= {int(code) for code in followed["special_point"].values}
        _draw_exponent(exponent, values, dataset["lyapunov_exponent"].values)
        fixed = swept.condition(cfg["sweep"], cfg["swept"])
        title = ", ".join(filter(None, [states.case(state), fixed]))
        panel = f"{letter(position)} " if len(sweeps) > 1 else ""
        strip.set_title(f"{panel}{title}", loc="left")
        section.set_ylabel(f"Section displacement over\n{swept.length_unit(cfg['sweep'], cfg['swept'])}")
        exponent.set_ylabel("Lyapunov\nexponent")
        for axes in (section, exponent):
            axes.yaxis.set_label_coords(_LABEL / (DOUBLE - _LEFT - _RIGHT), 0.5)
    exponent.set_xlabel(swept.LABELS[cfg["sweep"]])
    keys = motion_classes.keys(names)
    figure.legend(handles=keys, loc="upper center", ncols=len(keys), handlelength=1.2, columnspacing=1.2)
    keys = branches.keys(special, any(followed.sizes["node"] for followed in orbits))
    if keys:
        place = (0.5, 1 - _ROW / total)
        figure.legend(handles=keys, loc="upper center", bbox_to_anchor=place, ncols=len(keys), columnspacing=1.4)


def _place(figure: Figure, bottom: float, high: float, total: float) -> Axes:
    return figure.add_axes((_LEFT / DOUBLE, bottom / total, 1 - (_LEFT + _RIGHT) / DOUBLE, high / total))


def _draw_classes(axes: Axes, computed: Windows, windows: Windows) -> None:
    axes.set_ylim(0, 2)
    motion_classes.draw_strip(axes, 1, computed)
    motion_classes.draw_strip(axes, 0, windows)
    axes.set_yticks([0.5, 1.5], ["paper", "this run"])
    axes.tick_params(which="both", length=0, labelbottom=False)
    axes.minorticks_off()


def _draw_section(axes: Axes, values: np.ndarray, dataset: xr.Dataset) -> None:
    displacement, period = dataset["section_displacement"].values, dataset["period"].values
    sample = np.arange(displacement.shape[1])
    swept_values = np.broadcast_to(values[:, None], displacement.shape)
    finite = np.isfinite(displacement)
    repeats = finite & (sample < period[:, None])
    endless = finite & (period == 0)[:, None]
    dots = {"linestyle": "none", "marker": "o", "markeredgewidth": 0, "color": _INK, "rasterized": True}
    axes.plot(swept_values[endless], displacement[endless], markersize=0.5, alpha=0.6, **dots)
    axes.plot(swept_values[repeats], displacement[repeats], markersize=1.0, **dots)
    axes.tick_params(labelbottom=False)


def _draw_exponent(axes: Axes, values: np.ndarray, exponent: np.ndarray) -> None:
    axes.axhline(0, color="black", linewidth=0.5)
    axes.plot(values, exponent, color=_INK, linewidth=0.6)
    axes.fill_between(values, 0, exponent, where=exponent > 0, interpolate=True, color=_CHAOS, linewidth=0)
