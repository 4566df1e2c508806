"""Tornado charts: what the options of the model and its open parameters change, the largest changes first."""

from __future__ import annotations

import textwrap
from typing import Any, NamedTuple

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator, NullLocator

from gearwear.config.parameters import ENDS, OPTION, PLACES
from gearwear.config.text import listed
from gearwear.figures.sheet import DOUBLE, legend_above, letter, sheet
from gearwear.sensitivity.quantities import QUANTITIES, Quantity

_COLUMNS = 3
_MOST_OPTIONS = 10  # rows of a panel; the smaller changes are told in words
_LEAST = 0.01  # of the largest change of an option, for a row of its own
_GAP = 1.4  # between the groups, in rows
_HEIGHT_OF_ROW = 0.74
_SMALL = 5.6  # points
_WIDTH = 150  # characters of a line
_PAPER = {"facecolor": "white", "edgecolor": "none", "pad": 0.4}
_WORDS: dict[str, Any] = {"fontsize": _SMALL - 0.4, "fontstyle": "italic", "bbox": _PAPER}
_PERCENT = 100.0

# Okabe and Ito (2008), safe for colour-blind readers; low and high differ in lightness.
_OPTION, _LOW, _HIGH, _INK = "#009E73", "#56B4E9", "#D55E00", "#000000"

_TITLES = {
    "mean_stiffness_with": "mean stiffness",
    "stiffness_ripple_with": "ripple κ",
    "relative_mean_error_with": "mean error",
    "deepest_wear_pinion_with": "wear of pinion",
    "deepest_wear_gear_with": "wear of gear",
    "mean_half_backlash_with": "half backlash",
    "first_doubling_with": "first doubling",
    "chaos_onset_with": "onset of chaos",
    "first_doubling_shift": "shift of doubling",
}


_SECTIONS = {"transmission_error": "STE", "mesh_stiffness": "mesh"}


class Row(NamedTuple):
    """One row of a panel: its label, and the change of each of its bars, by colour; nan where the quantity lacks."""

    label: str
    bars: tuple[tuple[float, str], ...]

    @property
    def size(self) -> float:
        """Its largest change, infinite where the quantity lacks."""
        return max(np.inf if np.isnan(change) else abs(change) for change, _ in self.bars)


@sheet(DOUBLE, 225.0)
def draw(figure: Figure, measures: xr.Dataset, cfg: dict[str, Any]) -> None:
    """Draw a panel for every quantity of case `with`; above the options, below the parameters.

    Parameters
    ----------
    measures : as sensitivity.table.compared gives it.
    """
    quantities = [quantity for quantity in QUANTITIES if quantity.name in _TITLES]
    panels = figure.subplots(-(-len(quantities) // _COLUMNS), _COLUMNS)
    for position, (axes, quantity) in enumerate(zip(panels.flat, quantities, strict=True)):
        _draw_panel(axes, quantity, measures)
        axes.set_title(f"{letter(position)} {_TITLES[quantity.name]}", loc="left")
    impossible = [_label(measures, int(i)) for i in np.flatnonzero(_hindered(measures))]
    if impossible:
        figure.supxlabel(textwrap.fill(f"Not possible: {listed(impossible)}.", _WIDTH), fontsize=_SMALL)
    legend_above(figure, _keys(), 3)


def options(table: xr.Dataset, quantity: Quantity) -> list[Row]:
    """Return a row for every option that can be computed, the largest change first."""
    change = _change(table, quantity)
    found = [
        Row(_label(table, i), ((change[i], _OPTION),))
        for i in _possible(table).values()
        if table["group"].values[i] == OPTION
    ]
    return sorted(found, key=lambda row: -row.size)


def parameters(table: xr.Dataset, quantity: Quantity) -> list[Row]:
    """Return a row for every parameter, both ends in it, the largest change first."""
    change, members = _change(table, quantity), _possible(table)
    found = []
    for name in PLACES:
        ends = [(f"{name}_{end}", colour) for end, colour in zip(ENDS, (_LOW, _HIGH), strict=True)]
        bars = tuple((change[members[member]], colour) for member, colour in ends if member in members)
        if bars:
            found.append(Row(name.replace("_", " "), bars))
    return sorted(found, key=lambda row: -row.size)


def _draw_panel(axes: Axes, quantity: Quantity, table: xr.Dataset) -> None:
    usual = quantity.of(table)[0]
    if np.isnan(usual):
        axes.text(0.5, 0.5, "the study has none", transform=axes.transAxes, ha="center", fontstyle="italic")
        axes.set_axis_off()
        return
    every, below = options(table, quantity), parameters(table, quantity)
    shown = [row for row in every[:_MOST_OPTIONS] if row.size >= _LEAST * _largest(every)]
    scale = _PERCENT if quantity.relative else 1.0
    places = [*range(len(shown)), *(_MOST_OPTIONS + _GAP + i for i in range(len(below)))]
    rows = [*shown, *below]
    changes = [change for row in rows for change, _ in row.bars if np.isfinite(change)]
    wider = 1 if max(changes, default=0.0) >= -min(changes, default=0.0) else -1
    for place, row in zip(places, rows, strict=True):
        _draw_row(axes, place, row, scale, wider)
    axes.axvline(0.0, color=_INK, linewidth=0.5)
    if left := every[len(shown) :]:
        words = f"{len(left)} more"
        if np.isfinite(left[0].size):
            words += f", at most {_above(scale * left[0].size):g}{' %' if quantity.relative else ''}"
        axes.text(0.98, len(shown), words, transform=axes.get_yaxis_transform(), ha="right", va="center", **_WORDS)
    axes.set_yticks(places, [row.label for row in rows], fontsize=_SMALL)
    axes.set_ylim(_MOST_OPTIONS + _GAP + len(PLACES) - 0.4, -0.6)
    axes.tick_params(axis="y", which="both", length=0)
    axes.yaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_locator(MaxNLocator(3))
    axes.margins(x=0.1)
    axes.set_xlabel(_measure(quantity, usual), fontsize=_SMALL + 0.4)


def _draw_row(axes: Axes, place: float, row: Row, scale: float, wider: int) -> None:
    """Draw the bars of a row above one another; where one lacks, say so on the free or the `wider` side of zero."""
    height = _HEIGHT_OF_ROW / len(row.bars)
    rightwards = (-np.nansum([change for change, _ in row.bars]) or wider) > 0
    for i, (change, colour) in enumerate(row.bars):
        middle = place + height * (i - (len(row.bars) - 1) / 2)
        if np.isfinite(change):
            axes.barh(middle, scale * change, height=height, color=colour, linewidth=0)
            continue
        side = ((3, 0), "left") if rightwards else ((-3, 0), "right")
        axes.annotate(
            "none", (0, middle), xytext=side[0], textcoords="offset points", ha=side[1], va="center", **_WORDS
        )


def _above(value: float) -> float:
    """Return the next number of two digits that is not below `value`, which is not negative."""
    if not 0.0 < value < np.inf:
        return value
    step = 10.0 ** (np.floor(np.log10(value)) - 1)
    return float(np.ceil(round(value / step, 6)) * step)


def _largest(rows: list[Row]) -> float:
    return max((row.size for row in rows if np.isfinite(row.size)), default=0.0)


def _possible(table: xr.Dataset) -> dict[str, int]:
    return {str(table["member"].values[i]): int(i) for i in np.flatnonzero(~_hindered(table))}


def _hindered(table: xr.Dataset) -> np.ndarray:
    """Return which members have a case that cannot be, (members,) bool."""
    return (table["hindrance"].values != "").any(axis=1)


def _measure(quantity: Quantity, usual: float) -> str:
    units = {"mean_stiffness": (1e-6, "N/µm"), "deepest_wear": (1e6, "µm"), "mean_half_backlash": (1e6, "µm")}
    factor, unit = units.get(quantity.variable, (1.0, ""))
    value = f"{factor * usual:.4g} {unit}".strip().replace("-", "−")
    return f"Change, % of {value}" if quantity.relative else f"Change from {value}"


def _change(table: xr.Dataset, quantity: Quantity) -> np.ndarray:
    values = quantity.of(table)
    return quantity.change(values, values[0])


def _label(table: xr.Dataset, i: int) -> str:
    """Return key and value in words; a key of one word takes its section along."""
    *_, section, key = str(table["key"].values[i]).split(".")
    words = key if "_" in key else f"{_SECTIONS.get(section, section)} {key}"
    return f"{words} {table['value'].values[i]}".replace("ste_", "STE_").replace("_", " ")


def _keys() -> list[Patch]:
    return [
        Patch(color=_OPTION, label="option of the model"),
        Patch(color=_LOW, label="parameter, low end"),
        Patch(color=_HIGH, label="parameter, high end"),
    ]
