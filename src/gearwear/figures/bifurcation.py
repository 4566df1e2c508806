"""Bifurcation diagrams, one below the other: classes, sections, periodic orbits and exponent along one sweep."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from gearwear.codes.motion_class import CONFLICTS
from gearwear.figures import branches, motion_classes, orders, sections, states, swept
from gearwear.figures.sheet import DOUBLE, letter

# Heights and margins, mm.
_LEFT, _RIGHT, _TOP, _BOTTOM = 18.0, 3.0, 14.0, 10.0
_ROW = 4.0  # of the legend
_TITLE, _STRIP, _SECTION, _EXPONENT, _GAP, _BETWEEN = 5.0, 13.0, 42.0, 14.0, 1.2, 5.0
_DIAGRAM = _TITLE + _STRIP + _GAP + _SECTION + _GAP + _EXPONENT
_LABEL = -9.5  # mm, right edge of the ordinate's label from the axis
_INK, _CHAOS = "#1A1A1A", "#D55E00"
_DOTS = (0.5, 1.0)
_DOUBT: dict[str, Any] = {"linestyle": "none", "marker": "v", "markersize": 3, "markeredgewidth": 0, "color": "#B8478F"}

Windows = Sequence[tuple[float, float, str]]


def height(count: int) -> float:
    """Return the height, mm, of a sheet with this number of diagrams."""
    return _TOP + _BOTTOM + count * _DIAGRAM + (count - 1) * _BETWEEN


def draw(
    figure: Figure,
    sweeps: Sequence[orders.Sweeps],
    orbits: Sequence[xr.Dataset],
    paper: Sequence[Windows],
    cfg: dict[str, Any],
) -> None:
    """Draw one diagram for every sweep, from top to bottom.

    Parameters
    ----------
    sweeps : for every diagram, the datasets of the sweep by `restart`, `up` and `down`.
    orbits : branches of periodic orbits, for every sweep.
    paper : (low, high, class) of the windows of motion the paper names, for every sweep.
    cfg : `sweep`, its settings `swept`, the `order` shown first, and the `states` in the order of `sweeps`.
    """
    names: set[str] = set()
    special: set[int] = set()
    apart, doubtful = False, False
    total = height(len(sweeps))
    for position, (by_order, followed, windows, state) in enumerate(
        zip(sweeps, orbits, paper, cfg["states"], strict=True)
    ):
        top = total - _TOP - position * (_DIAGRAM + _BETWEEN) - _TITLE
        strip = _place(figure, top - _STRIP, _STRIP, total)
        section = _place(figure, top - _STRIP - _GAP - _SECTION, _SECTION, total)
        exponent = _place(figure, top - _STRIP - _SECTION - 2 * _GAP - _EXPONENT, _EXPONENT, total)
        by_order = {order: dataset.sortby(cfg["sweep"]) for order, dataset in by_order.items()}
        dataset = by_order[cfg["order"]]
        values = dataset[cfg["sweep"]].values
        for axes in (strip, section, exponent):
            axes.set_xlim(values[0], values[-1])
        rows = ({"paper": windows} if windows else {}) | _classes(values, by_order, cfg["order"])
        names |= {name for zones in rows.values() for *_, name in zones}
        _draw_classes(strip, rows)
        doubts = values[dataset["conflict"].values != CONFLICTS["none"]]
        strip.plot(doubts, np.full(len(doubts), len(rows)), clip_on=False, **_DOUBT)
        doubtful = doubtful or bool(len(doubts))
        differing = orders.ranges(values, by_order)
        apart = apart or bool(differing)
        for axes in (section, exponent):
            orders.shade(axes, differing)
        orders.draw(section, values, by_order)
        sections.draw(section, values, dataset, _DOTS, color=_INK)
        section.tick_params(labelbottom=False)
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
    exponent.set_xlabel(swept.label(cfg["sweep"], cfg["states"][0]))
    keys: list[Artist] = [*motion_classes.keys(names)]
    if doubtful:
        keys.append(Line2D([], [], label="evidence disagrees", **_DOUBT))
    figure.legend(handles=keys, loc="upper center", ncols=len(keys), handlelength=1.2, columnspacing=1.2)
    lines = branches.keys(special, any(followed.sizes["node"] for followed in orbits))
    below: list[Sequence[Artist]] = [orders.keys(cfg["order"], apart), lines]
    for row, entries in enumerate(below, start=1):
        if entries:
            place = (0.5, 1 - row * _ROW / total)
            figure.legend(
                handles=entries, loc="upper center", bbox_to_anchor=place, ncols=len(entries), columnspacing=1.4
            )


def _place(figure: Figure, bottom: float, high: float, total: float) -> Axes:
    return figure.add_axes((_LEFT / DOUBLE, bottom / total, 1 - (_LEFT + _RIGHT) / DOUBLE, high / total))


def _classes(values: np.ndarray, by_order: orders.Sweeps, first: str) -> dict[str, Windows]:
    """Return the zones of the motion classes by the name of the order, from the lowest row to the order shown first."""
    rows: dict[str, Windows] = {}
    for order in [*(order for order in reversed(orders.NAMES) if order != first), first]:
        found = [motion_classes.name_of(code) for code in by_order[order]["motion_class"].values]
        rows[orders.NAMES[order]] = motion_classes.runs(values, found)
    return rows


def _draw_classes(axes: Axes, rows: dict[str, Windows]) -> None:
    axes.set_ylim(0, len(rows))
    for row, zones in enumerate(rows.values()):
        motion_classes.draw_strip(axes, row, zones)
    axes.set_yticks(np.arange(len(rows)) + 0.5, list(rows))
    axes.tick_params(which="both", length=0, labelbottom=False)
    axes.minorticks_off()


def _draw_exponent(axes: Axes, values: np.ndarray, exponent: np.ndarray) -> None:
    axes.axhline(0, color="black", linewidth=0.5)
    axes.plot(values, exponent, color=_INK, linewidth=0.6)
    axes.fill_between(values, 0, exponent, where=exponent > 0, interpolate=True, color=_CHAOS, linewidth=0)
