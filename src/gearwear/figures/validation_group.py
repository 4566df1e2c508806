"""A group of checks: how far every number is from the expected one over its tolerance, and curves beside it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

from gearwear.figures.sheet import DOUBLE, letter, sheet
from gearwear.validation.checks import read
from gearwear.validation.outcomes import Outcome, merged, read_rows

# Okabe and Ito (2008), safe for colour-blind readers; what differs has another mark, too.
_AGREES, _DIFFERS, _BAND = "#0072B2", "#D55E00", "#E6EEF4"
_CURVES = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000", "#8C6D00", "#7A5195", "#7F7F7F")
_MARKS = "osv^D<>pXh"
_COLUMNS = 2  # of panels
_ROW, _PANEL, _TOP, _BOTTOM = 3.3, 42.0, 6.0, 10.0  # mm, height of a row, of a panel, above and below both
_LABELS, _LEFT, _RIGHT = 74.0, 15.0, 3.0  # mm, left of the rows, of a panel, right of all
_FARTHEST = 1.45  # of the tolerance, where numbers farther off are shown
_AXES = {
    "root_over_bore": "Root radius over bore radius",
    "temperature": "Temperature, °C",
    "radius": "Radius, m",
    "contact": "Contact, 0 start, 1 end",
    "points": "Points of the Gauss rule",
    "cells": "Cells of the grid",
    "blocks": "Blocks of 2.1·10⁹ revolutions",
    "tolerance": "Tolerance of a step",
}


def height(outcomes: Sequence[Outcome]) -> float:
    """Return the height (mm) that a figure of the group needs."""
    lines = -(-len(_panels(outcomes)) // _COLUMNS)
    return _TOP + _ROW * len(outcomes) + _BOTTOM + lines * (_TOP + _PANEL + _BOTTOM)


def _height(checks: Path, found: Path, **_: Any) -> float:
    return height(_outcomes(checks, found))


@sheet(DOUBLE, _height, layout=None)
def draw(figure: Figure, checks: Path, found: Path, cfg: dict[str, Any]) -> None:
    """Draw the group of checks whose numbers are in the CSV file `found`.

    Parameters
    ----------
    checks, found : paths of all checks (YAML) and of what was found for those of the group (CSV).
    """
    draw_outcomes(figure, _outcomes(checks, found))


@lru_cache(1)
def _outcomes(checks: Path, found: Path) -> list[Outcome]:
    return merged(read(checks), read_rows(found))


def draw_outcomes(figure: Figure, outcomes: Sequence[Outcome]) -> None:
    """Draw a row for every check, below them a panel for every name of a panel; `height` high and DOUBLE wide."""
    total, panels = height(outcomes), _panels(outcomes)
    rows = _ROW * len(outcomes)
    strip = figure.add_axes(_place(_LABELS, total - _TOP - rows, DOUBLE - _LABELS - _RIGHT, rows, total))
    _draw_strip(strip, outcomes)
    if panels:
        strip.set_title(letter(0), loc="left")
    column = (DOUBLE - _RIGHT) / _COLUMNS
    for position, (name, members) in enumerate(panels.items()):
        line, place = divmod(position, _COLUMNS)
        bottom = total - (_TOP + rows + _BOTTOM) - (line + 1) * (_TOP + _PANEL + _BOTTOM) + _BOTTOM
        axes = figure.add_axes(_place(place * column + _LEFT, bottom, column - _LEFT, _PANEL, total))
        axes.set_title(f"{letter(position + 1)} {name}", loc="left")
        _draw_curves(axes, members)


def _panels(outcomes: Sequence[Outcome]) -> dict[str, list[Outcome]]:
    names = dict.fromkeys(outcome.check.panel for outcome in outcomes if outcome.check.panel)
    return {name: [one for one in outcomes if one.check.panel == name] for name in names}


def _place(left: float, bottom: float, width: float, tall: float, total: float) -> tuple[float, float, float, float]:
    return left / DOUBLE, bottom / total, width / DOUBLE, tall / total


def _draw_strip(axes: Axes, outcomes: Sequence[Outcome]) -> None:
    axes.axvspan(-1.0, 1.0, color=_BAND, linewidth=0)
    axes.axvline(0.0, color="#999999", linewidth=0.4)
    for row, outcome in enumerate(outcomes):
        check = outcome.check
        off = np.subtract(outcome.found, check.expected)
        beyond = np.where(off == 0, 0.0, np.copysign(np.inf, off))  # where no tolerance is given
        over = np.divide(off, check.tolerance, out=beyond, where=np.array(check.tolerance) > 0)
        good, shown = np.array(outcome.agreements), np.clip(over, -_FARTHEST, _FARTHEST)
        axes.plot(shown[good], np.full(good.sum(), row), "o", color=_AGREES, markersize=2.6, markeredgewidth=0)
        axes.plot(shown[~good], np.full((~good).sum(), row), "X", color=_DIFFERS, markersize=4.0, markeredgewidth=0)
        farthest = over[np.argmax(np.abs(over))]
        if abs(farthest) > _FARTHEST:
            place, side = (-1.3, "left") if farthest < 0 else (1.3, "right")
            axes.text(place, row, f"{farthest:.3g}", ha=side, va="center", fontsize=5.5, color=_DIFFERS)
    axes.set_yticks(range(len(outcomes)), [outcome.check.says for outcome in outcomes], fontsize=6)
    axes.yaxis.set_minor_locator(NullLocator())
    axes.tick_params(axis="y", which="both", length=0)
    axes.set_xlim(-1.6, 1.6)
    axes.set_ylim(len(outcomes) - 0.4, -0.6)
    axes.set_xlabel("Found less expected, over tolerance")


def _draw_curves(axes: Axes, members: Sequence[Outcome]) -> None:
    """Draw found as lines and expected as open marks; where zero is expected, errors on logarithmic scales."""
    errors = not any(any(outcome.check.expected) for outcome in members)
    expected = {value for outcome in members for value in outcome.check.expected}
    gate = not errors and len(expected) == 1
    names = list(dict.fromkeys(outcome.check.label for outcome in members))
    for number, name in enumerate(names):
        ink: dict[str, Any] = {"color": _CURVES[number], "label": name}
        for outcome in (one for one in members if one.check.label == name):
            check, x = outcome.check, np.array(outcome.check.at, dtype=float)
            found = np.abs(outcome.found) if errors else np.array(outcome.found)
            axes.plot(x, found, marker=_MARKS[number], markersize=3.0, markeredgewidth=0, linewidth=0.8, **ink)
            ink["label"] = None
            if errors:
                axes.plot(x, check.tolerance, "_", markersize=6, markeredgewidth=0.8, **ink)
            elif not gate:
                open_mark: dict[str, Any] = {
                    "fmt": _MARKS[number],
                    "markersize": 5.0,
                    "markerfacecolor": "none",
                    "elinewidth": 0.6,
                }
                axes.errorbar(x, check.expected, check.tolerance, markeredgewidth=0.5, **open_mark, **ink)
    if errors:
        axes.set_yscale("log")
        axes.yaxis.set_minor_locator(NullLocator())
        _logarithmic(axes, members)
    elif gate:
        (middle,), tolerance = expected, max(members[0].check.tolerance)
        axes.axhspan(middle - tolerance, middle + tolerance, color=_BAND, linewidth=0, zorder=0)
    axes.margins(x=0.06)
    axes.set_xlabel(_AXES[members[0].check.along])
    columns = 2 if len(names) > 3 else 1
    low, high = axes.get_ylim()
    if not errors:  # room for the legend
        axes.set_ylim(low, high + 0.09 * (high - low) * np.ceil(len(names) / columns))
    axes.legend(loc="best" if errors else "upper right", fontsize=5.5, ncols=columns, labelspacing=0.25)


def _logarithmic(axes: Axes, members: Sequence[Outcome]) -> None:
    """Scale the abscissa; over less than two decades its ticks are the values themselves."""
    axes.set_xscale("log")
    values = sorted({float(at) for outcome in members for at in outcome.check.at})
    if values[-1] < 100 * values[0]:
        axes.xaxis.set_major_locator(FixedLocator(values))
        axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axes.xaxis.set_minor_locator(NullLocator())
