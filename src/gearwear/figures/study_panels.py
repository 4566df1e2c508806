"""Studies: classes of motion over the speed of the pinion and one axis, a panel for every value of the others."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import xarray as xr
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from gearwear.figures import motion_classes
from gearwear.figures.maps import edges_of
from gearwear.figures.sheet import DOUBLE, letter, sheet
from gearwear.studies import wording
from gearwear.studies.speeds import contact_limit, peak, period_one_limit
from gearwear.studies.table import AGE

_COLUMNS = 4
_ROW, _AROUND = 46.0, 24.0  # mm
_KRPM = 1e-3
_KEYS_IN_A_ROW = 6
_SHADES = "viridis"  # ordered values; its light end is too faint for lines
_LABELS = {AGE: "Revolutions, 10⁹"}


def _height(study: xr.Dataset, cfg: dict[str, Any]) -> float:
    return _AROUND + _ROW * math.ceil((len(_facets(study, cfg["axes"])[1]) + 1) / _COLUMNS)


@sheet(DOUBLE, _height)
def draw(figure: Figure, study: xr.Dataset, cfg: dict[str, Any]) -> None:
    """Draw the panels and, last, the limits of all of them.

    Parameters
    ----------
    study : as gearwear.studies.gathering gives it.
    cfg : `axes`, the keys of the grid, their `names` and `units`; `order`, that of the sweep whose classes are shown.
    """
    upright, facets = _facets(study, cfg["axes"])
    rows = math.ceil((len(facets) + 1) / _COLUMNS)
    panels = figure.subplots(rows, min(_COLUMNS, len(facets) + 1), squeeze=False).ravel()
    positions, ticks = _positions(study, upright)
    shown: set[str] = set()
    edges = edges_of(positions)
    if ticks is None and positions.size > 1:  # nothing lies before the first value or after the last
        edges[[0, -1]] = positions[[0, -1]]
    for place, (where, one) in enumerate(facets):
        axes = panels[place]
        shown |= _panel(axes, one, upright, edges, cfg["order"])
        axes.set_title(f"{letter(place)} {_title(where, cfg)}", loc="left")
        _ordinate(axes, upright, ticks, cfg, place % _COLUMNS == 0)
    _limits(panels[len(facets)], facets, upright, positions, cfg)
    panels[len(facets)].set_title(f"{letter(len(facets))} end of period 1,\nof contact (dashed)", loc="left")
    for axes in panels[len(facets) + 1 :]:
        axes.set_axis_off()
    for axes in panels[max(len(facets) + 1 - _COLUMNS, 0) : len(facets) + 1]:
        axes.set_xlabel("Pinion speed, 10³ rpm")
    lines = [
        Line2D([], [], color="black", linewidth=1.2, label="contact is lost beyond"),
        Line2D([], [], color="black", linewidth=0.8, dashes=(2, 1.5), label="running speed"),
    ]
    keys = motion_classes.keys(shown, hatched=False) + lines
    figure.legend(
        handles=keys, loc="outside upper center", ncols=math.ceil(len(keys) / math.ceil(len(keys) / _KEYS_IN_A_ROW))
    )


def _facets(study: xr.Dataset, axes: list[str]) -> tuple[str, list[tuple[dict[str, Any], xr.Dataset]]]:
    """Return the axis that is drawn upwards, that of age or else the last, and the values of the others with theirs."""
    upright = next((key for key in axes if key.endswith(AGE)), axes[-1])
    others = [key for key in axes if key != upright]
    places = itertools.product(*(range(study.sizes[key]) for key in others))
    found = []
    for place in places:
        one = study.isel(dict(zip(others, place, strict=True)))
        found.append(({key: one[key].item() for key in others}, one))
    return upright, found


def _positions(study: xr.Dataset, upright: str) -> tuple[np.ndarray, list[str] | None]:
    values = study[upright].values
    if values.dtype.kind == "f":
        return values * (1e-9 if upright.endswith(AGE) else 1.0), None
    return np.arange(len(values), dtype=float), [str(value) for value in values]


def _panel(axes: Axes, one: xr.Dataset, upright: str, edges: np.ndarray, order: str) -> set[str]:
    """Draw one row a member, over its own speeds, and where contact is first lost; return the classes drawn."""
    shown, lost = set(), []
    for row in range(one.sizes[upright]):
        member = one.isel({upright: row})
        if str(member["hindrance"].item()):
            lost.append(np.nan)
            continue
        codes = member["motion_class"].sel(order=order).values
        names = [motion_classes.name_of(code) for code in codes]
        colours = np.array([[to_rgb(motion_classes.colour(name)) for name in names]])
        speeds = edges_of(_KRPM * member["pinion_speed"].values)
        axes.pcolormesh(speeds, edges[row : row + 2], colours, rasterized=True)
        shown |= set(names)
        limit = contact_limit(member)
        lost.append(np.nan if limit.everywhere else _KRPM * limit.speed)
    axes.stairs(lost, edges, orientation="horizontal", baseline=None, color="black", linewidth=1.2)
    if not shown:
        axes.text(0.5, 0.5, "cannot be,\nsee the table", transform=axes.transAxes, ha="center", va="center")
        axes.set_xticks([])
    running = one["running_speed"].values
    if np.isfinite(running).any():
        axes.axvline(_KRPM * np.nanmax(running), color="black", linewidth=0.8, dashes=(2, 1.5))
    forces = [peak(one.isel({upright: row})) for row in range(one.sizes[upright])]
    highest = max(forces, key=lambda found: np.nan_to_num(found.force))
    if np.isfinite(highest.force):
        axes.text(
            0.98, 0.96, f"force ≤ {highest.force:.1f} × mean", transform=axes.transAxes, ha="right", va="top",
            fontsize=6, bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.2, "alpha": 0.85},
        )  # fmt: skip
    axes.set_ylim(edges[0], edges[-1])
    return shown


def _ordinate(axes: Axes, upright: str, ticks: list[str] | None, cfg: dict[str, Any], labelled: bool) -> None:
    if ticks is not None:
        axes.set_yticks(range(len(ticks)), ticks if labelled else [""] * len(ticks))
    if labelled and ticks is None:
        axes.set_ylabel(_LABELS[AGE] if upright.endswith(AGE) else wording.axis(upright, cfg["units"].get(upright, "")))


def _limits(axes: Axes, facets: Any, upright: str, positions: np.ndarray, cfg: dict[str, Any]) -> None:
    """Draw up to which speed the motion has period 1, and up to which contact is kept (dashed), over the age."""
    shades = colormaps[_SHADES](np.linspace(0.0, 0.85, len(facets)))
    for place, (where, one) in enumerate(facets):
        parts = [one.isel({upright: row}) for row in range(len(positions))]
        label = _title(where, cfg)
        axes.plot([_KRPM * period_one_limit(part).speed for part in parts], positions, color=shades[place], label=label)
        axes.plot(
            [_KRPM * contact_limit(part).speed for part in parts],
            positions,
            color=shades[place],
            dashes=(3, 1.5),
        )
    axes.set_xlim(left=0)
    if positions.size > 1:
        axes.set_ylim(positions[0], positions[-1])
    if len(facets) > 1:
        axes.legend(loc="center left", fontsize=6, handlelength=1.2)


def _title(values: dict[str, Any], cfg: dict[str, Any]) -> str:
    return ", ".join(wording.valued(value, cfg["units"].get(key, "")) for key, value in values.items()) or "all"
