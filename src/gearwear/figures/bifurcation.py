"""Bifurcation diagrams, one below the other: classes, sections, periodic orbits and exponent along one sweep."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import xarray as xr
import yaml
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from gearwear.codes.motion_class import CONFLICTS
from gearwear.figures import branch_lines, labels, motion_classes, sections
from gearwear.figures.sheet import DOUBLE, letter, sheet

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


class Diagram(NamedTuple):
    """Sweeps of one case by direction, its branches of periodic orbits if they were followed, windows of the paper."""

    sweeps: sections.Sweeps
    branches: xr.Dataset | None
    windows: Windows
    state: dict[str, Any]


def _height(cfg: dict[str, Any], **_: Any) -> float:
    count = len(cfg["states"])
    return _TOP + _BOTTOM + count * _DIAGRAM + (count - 1) * _BETWEEN


@sheet(DOUBLE, _height, layout=None)
def draw(
    figure: Figure,
    restart: Sequence[xr.Dataset],
    up: Sequence[xr.Dataset],
    down: Sequence[xr.Dataset],
    branches: Sequence[xr.Dataset],
    claims: Sequence[Path],
    cfg: dict[str, Any],
) -> None:
    """Draw one diagram for every case, from top to bottom.

    Parameters
    ----------
    restart, up, down : the sweeps of every case, from rest and with continuation upwards and downwards.
    branches : branches of periodic orbits of every case, or nothing.
    claims : at most one path, of the claims of the paper.
    cfg : `sweep`, its settings `swept`, the `order` shown first, and the `states` of the cases.
    """
    stated = [claim for path in claims for claim in yaml.safe_load(path.read_text(encoding="utf-8"))["claims"]]
    diagrams = []
    for place, (state, *sweeps) in enumerate(zip(cfg["states"], restart, up, down, strict=True)):
        by_direction = {name: one.sortby(cfg["sweep"]) for name, one in zip(sections.DIRECTIONS, sweeps, strict=True)}
        followed = branches[place] if branches else None
        diagrams.append(Diagram(by_direction, followed, list(windows(stated, cfg["sweep"], state["case"])), state))
    total, top = _height(cfg), _height(cfg) - _TOP - _TITLE
    for position, diagram in enumerate(diagrams):
        strip = _place(figure, top - _STRIP, _STRIP, total)
        section = _place(figure, top - _STRIP - _GAP - _SECTION, _SECTION, total)
        exponent = _place(figure, top - _STRIP - _SECTION - 2 * _GAP - _EXPONENT, _EXPONENT, total)
        _draw_diagram((strip, section, exponent), diagram, cfg)
        panel = f"{letter(position)} " if len(diagrams) > 1 else ""
        strip.set_title(f"{panel}{labels.title(cfg, diagram.state)}", loc="left")
        top -= _DIAGRAM + _BETWEEN
    exponent.set_xlabel(labels.sweep(cfg["sweep"], cfg["states"][0]))
    _draw_legends(figure, diagrams, cfg, total)


def windows(claims: Sequence[dict[str, Any]], sweep: str, case: str) -> Iterator[tuple[float, float, str]]:
    """Yield (low, high, class) of the windows of motion that the paper names for a sweep of a case."""
    for claim in claims:
        if claim["kind"] != "window" or claim["sweep"] != sweep:
            continue
        if case in ([claim["case"]] if isinstance(claim["case"], str) else claim["case"]):
            yield *claim["range"], claim["class"][0]


def _place(figure: Figure, bottom: float, high: float, total: float) -> Axes:
    return figure.add_axes((_LEFT / DOUBLE, bottom / total, 1 - (_LEFT + _RIGHT) / DOUBLE, high / total))


def _draw_diagram(panels: tuple[Axes, Axes, Axes], diagram: Diagram, cfg: dict[str, Any]) -> None:
    strip, section, exponent = panels
    dataset = diagram.sweeps[cfg["order"]]
    values = dataset[cfg["sweep"]].values
    for axes in panels:
        axes.set_xlim(values[0], values[-1])
    rows = _rows(diagram, cfg)
    _draw_classes(strip, rows)
    doubts = values[_doubtful(dataset)]
    strip.plot(doubts, np.full(len(doubts), len(rows)), clip_on=False, **_DOUBT)
    differing = sections.differing_ranges(values, diagram.sweeps)
    for axes in (section, exponent):
        sections.shade(axes, differing)
    sections.draw_both(section, values, diagram.sweeps)
    sections.draw(section, values, dataset, _DOTS, color=_INK)
    section.tick_params(labelbottom=False)
    if diagram.branches is not None:
        branch_lines.draw(section, cfg["sweep"], diagram.branches)
    _draw_exponent(exponent, values, dataset["lyapunov_exponent"].values)
    section.set_ylabel(f"Section displacement over\n{labels.length_unit(cfg['sweep'], cfg['swept'])}")
    exponent.set_ylabel("Lyapunov\nexponent")
    for axes in (section, exponent):
        axes.yaxis.set_label_coords(_LABEL / (DOUBLE - _LEFT - _RIGHT), 0.5)


def _rows(diagram: Diagram, cfg: dict[str, Any]) -> dict[str, Windows]:
    """Return the zones of the classes by their label: of the paper, and of each direction, last that shown first."""
    rows: dict[str, Windows] = {"paper": diagram.windows} if diagram.windows else {}
    first = cfg["order"]
    for direction in [*(one for one in reversed(sections.DIRECTIONS) if one != first), first]:
        dataset = diagram.sweeps[direction]
        names = [motion_classes.name_of(code) for code in dataset["motion_class"].values]
        rows[sections.DIRECTIONS[direction]] = motion_classes.runs(dataset[cfg["sweep"]].values, names)
    return rows


def _doubtful(dataset: xr.Dataset) -> np.ndarray:
    return dataset["conflict"].values != CONFLICTS["none"]


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


def _draw_legends(figure: Figure, diagrams: Sequence[Diagram], cfg: dict[str, Any], total: float) -> None:
    """Draw the legends of the classes, of the dots and of the branches, one below the other."""
    sweep, first = cfg["sweep"], cfg["order"]
    names = {name for one in diagrams for zones in _rows(one, cfg).values() for *_, name in zones}
    keys: list[Artist] = [*motion_classes.keys(names)]
    if any(_doubtful(one.sweeps[first]).any() for one in diagrams):
        keys.append(Line2D([], [], label="evidence disagrees", **_DOUBT))
    figure.legend(handles=keys, loc="upper center", ncols=len(keys), handlelength=1.2, columnspacing=1.2)
    apart = any(sections.differing_ranges(one.sweeps[first][sweep].values, one.sweeps) for one in diagrams)
    followed = [one.branches for one in diagrams if one.branches is not None]
    special = {int(code) for one in followed for code in one["special_point"].values}
    lines = branch_lines.keys(special, any(one.sizes["node"] for one in followed))
    below: list[Sequence[Artist]] = [sections.keys(first, apart), lines]
    for row, entries in enumerate(below, start=1):
        if entries:
            place = (0.5, 1 - row * _ROW / total)
            figure.legend(
                handles=entries, loc="upper center", bbox_to_anchor=place, ncols=len(entries), columnspacing=1.4
            )
