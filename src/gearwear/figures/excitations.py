"""Figures of the excitations: mesh stiffness, transmission error, the lengths behind it, and backlash."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from gearwear.figures import contact_axes, labels
from gearwear.figures.sheet import DOUBLE, SINGLE, legend_above, letter, sheet
from gearwear.geometry.path_mean import path_mean

_STIFFNESS = {"nominal": (), "effective": (3, 1.2)}  # dashes
_LENGTHS: dict[str, dict[str, Any]] = {
    "growth of the four flanks": {"color": "#D55E00", "dashes": ()},
    "elastic deflection": {"color": "#0072B2", "dashes": (5, 1.4)},
    "wear of both flanks": {"color": "#000000", "dashes": (5, 1.4, 1, 1.4)},
}


@sheet(DOUBLE, 72.0)
def draw_stiffness(
    figure: Figure,
    geometry: xr.Dataset,
    mesh_stiffness: Sequence[xr.Dataset],
    transmission_error: Sequence[xr.Dataset],
    cfg: dict[str, Any],
) -> None:
    """Draw the mesh stiffness of every state, nominal and effective, and its change from the first state."""
    stiffness = {
        "nominal": [one["mesh_stiffness"].values for one in mesh_stiffness],
        "effective": [one["effective_stiffness"].values for one in transmission_error],
    }
    states, panels = cfg["states"], figure.subplots(1, 2)
    for kind, dashes in _STIFFNESS.items():
        for place, values in enumerate(stiffness[kind]):
            line = {"color": labels.colour(place), "dashes": dashes}
            contact_axes.draw_over_phase(panels[0], geometry, 1e-8 * values, **line)
            contact_axes.draw_over_phase(panels[1], geometry, 100 * (values / stiffness[kind][0] - 1), **line)
    colours = [Line2D([], [], color=labels.colour(i), label=labels.name(one)) for i, one in enumerate(states)]
    kinds = [Line2D([], [], color="black", dashes=dashes, label=kind) for kind, dashes in _STIFFNESS.items()]
    _label_phases(panels[0], geometry, f"{letter(0)} Mesh stiffness", "Mesh stiffness (10⁸ N/m)")
    title = f"{letter(1)} Change from {labels.name(states[0])}"
    _label_phases(panels[1], geometry, title, "Change of mesh stiffness (%)")
    legend_above(figure, [*colours, *kinds, *contact_axes.keys(with_pitch_point=False)], len(states))


@sheet(DOUBLE, 68.0)
def draw_transmission_error(
    figure: Figure, geometry: xr.Dataset, transmission_error: Sequence[xr.Dataset], cfg: dict[str, Any]
) -> None:
    """Draw the static transmission error of every state, and its rise from the first state."""
    errors = [one["transmission_error"].values for one in transmission_error]
    states, panels = cfg["states"], figure.subplots(1, 2)
    for place, (error, state) in enumerate(zip(errors, states, strict=True)):
        line = labels.line(place, state)
        contact_axes.draw_over_phase(panels[0], geometry, 1e6 * error, **line)
        contact_axes.draw_over_phase(panels[1], geometry, 1e6 * (error - errors[0]), **line)
    lines: list[Artist] = panels[0].get_legend_handles_labels()[0]
    _label_phases(panels[0], geometry, f"{letter(0)} Transmission error", "Static transmission error (µm)")
    title = f"{letter(1)} Rise from {labels.name(states[0])}"
    _label_phases(panels[1], geometry, title, "Rise of transmission error (µm)")
    legend_above(figure, [*lines, *contact_axes.keys(with_pitch_point=False)], len(states))


@sheet(DOUBLE, 72.0)
def draw_lengths(
    figure: Figure,
    geometry: xr.Dataset,
    deformation: Sequence[xr.Dataset],
    transmission_error: Sequence[xr.Dataset],
    wear: Sequence[xr.Dataset],
    cfg: dict[str, Any],
) -> None:
    """Draw growth of the four flanks, deflection and wear: along the path in the last state, means in every state."""
    states = cfg["states"]
    fields = [
        (2 * grown["thermal_growth"].sum("gear"), error["elastic_deflection"], worn["wear_depth"].sum("gear"))
        for grown, error, worn in zip(deformation, transmission_error, wear, strict=True)
    ]
    means = np.array([[1e6 * path_mean(field) for field in state] for state in fields])
    means = np.round(means, 3) + 0.0  # no label may read -0.0
    along, grouped = figure.subplots(1, 2, sharey=True, width_ratios=(1, 1.15))
    width = 0.84 / len(_LENGTHS)
    for place, (label, line) in enumerate(_LENGTHS.items()):
        contact_axes.draw_along_path(along, fields[-1][place], 1e6, label=label, **line)
        along.axhline(means[-1, place], 0, 1, color=line["color"], linewidth=0.6)
        at = np.arange(len(states)) + (place - 1) * width
        bars = grouped.bar(at, means[:, place], width, color=line["color"])
        grouped.bar_label(bars, fmt="%.1f", padding=1.5, fontsize=6.5)
    contact_axes.mark_path(along, geometry)
    along.set_ylabel("Length on the line of action (µm)")
    along.set_ylim(0, 1.08 * 1e6 * max(float(field.max()) for state in fields for field in state))
    along.set_title(f"{letter(0)} {labels.name(states[-1])}; thin lines: means", loc="left")
    grouped.set_ylabel("Mean length (µm)")
    grouped.tick_params(labelleft=True)
    grouped.set_title(f"{letter(1)} Means over the path", loc="left")
    ticks = [f"{labels.temperature(one)}\n{labels.cycles(one)}".replace(" cycles", "\ncycles") for one in states]
    grouped.set_xticks(range(len(states)), ticks)
    grouped.tick_params(axis="x", which="both", length=0)
    keys = [*along.get_legend_handles_labels()[0], *contact_axes.keys()]
    legend_above(figure, keys, len(keys))


@sheet(SINGLE, 74.0)
def draw_backlash(figure: Figure, geometry: xr.Dataset, backlash: Sequence[xr.Dataset], cfg: dict[str, Any]) -> None:
    """Draw half the backlash of one pair along the path of contact, of every state."""
    axes = figure.subplots()
    for place, (clearance, state) in enumerate(zip(backlash, cfg["states"], strict=True)):
        contact_axes.draw_along_path(axes, clearance["backlash_path"], 1e6, **labels.line(place, state))
    initial = 1e6 * float(backlash[0]["initial_half_backlash"])
    axes.axhline(initial, color="#777777", linewidth=0.6, label=f"initial, {initial:g} µm")
    contact_axes.mark_path(axes, geometry)
    axes.set_ylabel("Half backlash (µm)")
    legend_above(figure, [*axes.get_legend_handles_labels()[0], *contact_axes.keys()], 2)


def _label_phases(axes: Axes, geometry: xr.Dataset, title: str, label: str) -> None:
    contact_axes.mark_phase(axes, geometry)
    axes.set_title(title, loc="left")
    axes.set_ylabel(label)
