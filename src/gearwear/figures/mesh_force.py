"""Dynamic mesh force over mesh periods, and its spectrum over the mesh harmonics, one strip a state."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from gearwear.figures import contact_axes, labels, motion_classes
from gearwear.figures.sheet import DOUBLE, legend_above, letter, sheet
from gearwear.oscillator.spectrum import spectrum

_HIGHEST = 10  # order of the mesh frequency
_EDGES = np.array([-1, 0, 1])  # of a cell, beside its midpoint along the path
_SIMPSON = np.array([1, 4, 1]) / 6
_LONGEST = 8  # mesh periods of a history
_DECADES = 1e-5  # of the largest amplitude, below which nothing is shown
_MANY_LINES = 80  # above, a spectrum is a curve
_NATURAL: dict[str, Any] = {"color": "#555555", "linestyle": ":", "linewidth": 0.8}
_MEAN: dict[str, Any] = {"color": "#777777", "linewidth": 0.6}


class Force(NamedTuple):
    """Force of one state over the periods until it repeats, and its spectrum.

    Mesh phases (m,), force at them (periods, m) and static force (N); orders of the mesh frequency and amplitudes at
    them (N); mesh frequency over natural frequency; class of the motion.
    """

    phase: np.ndarray
    history: np.ndarray
    mean: float
    orders: np.ndarray
    amplitudes: np.ndarray
    mesh_frequency_ratio: float
    motion: str


def _height(response: Sequence[xr.Dataset], **_: Any) -> float:
    return 30.0 + 24.0 * len(response)


@sheet(DOUBLE, _height)
def draw(figure: Figure, geometry: xr.Dataset, response: Sequence[xr.Dataset], cfg: dict[str, Any]) -> None:
    """Draw the mesh force of every state, its history on the left and its spectra on the right."""
    draw_forces(figure, geometry, [force_of(geometry, one) for one in response], cfg["states"])


def force_of(geometry: xr.Dataset, response: xr.Dataset) -> Force:
    """Return the mesh force of a response over mesh phase, and its spectrum."""
    nodes, phase, weight = cells(geometry)
    history = response["mesh_force_path"].values[:, nodes]
    lines = spectrum(history, phase, weight, min(_HIGHEST, geometry.sizes["mesh_phase"] // 4))
    ratio, mean = (float(response[name]) for name in ("mesh_frequency_ratio", "mean_force"))
    return Force(phase, history, mean, *lines, ratio, motion_classes.name_of(response["motion_class"].item()))


def cells(geometry: xr.Dataset) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return path nodes, mesh phases and weights of Simpson's rule over the cells, (3 m,) each."""
    middle, phase, width = (geometry[name].values[:, None] for name in ("entering", "mesh_phase", "mesh_phase_width"))
    return (middle + _EDGES).ravel(), (phase + _EDGES * width / 2).ravel(), (width * _SIMPSON).ravel()


def draw_forces(
    figure: Figure, geometry: xr.Dataset, forces: Sequence[Force], states: Sequence[dict[str, Any]]
) -> None:
    """Draw the histories on one panel, the spectra below each other."""
    grid = figure.add_gridspec(len(forces), 2)
    history = figure.add_subplot(grid[:, 0])
    periods = min(max(contact_axes.PERIODS, *(len(force.history) for force in forces)), _LONGEST)
    for place, (force, state) in enumerate(zip(forces, states, strict=True)):
        time = (np.arange(periods)[:, None] + force.phase).ravel()
        history.plot(time, 1e-3 * np.resize(force.history, time.shape), **labels.line(place, state))
    history.axhline(1e-3 * forces[0].mean, label="static", zorder=1, **_MEAN)
    contact_axes.mark_phase(history, geometry, periods)
    history.set_ylabel("Dynamic mesh force (kN)")
    history.set_title(f"{letter(0)} History", loc="left")
    shared = None
    largest = max(force.amplitudes.max() for force in forces)
    for place, (force, state) in enumerate(zip(forces, states, strict=True)):
        axes = shared = figure.add_subplot(grid[place, 1], sharex=shared, sharey=shared)
        _draw_spectrum(axes, force, labels.colour(place))
        axes.set_title(f"{letter(place + 1)} {labels.name(state)}: {motion_classes.short(force.motion)}", loc="left")
        axes.tick_params(labelbottom=place == len(forces) - 1)
        axes.set_yscale("log")
        axes.set_ylim(_DECADES * largest, 3 * largest)
        axes.set_xlim(0, _HIGHEST + 0.5)
    axes.set_xticks(range(_HIGHEST + 1))
    axes.set_xlabel("Order of the mesh frequency")
    lines, _ = history.get_legend_handles_labels()
    natural = Line2D([], [], label="natural frequency", **_NATURAL)
    legend_above(figure, [*lines, natural, *contact_axes.keys(with_pitch_point=False)], len(states))


def _draw_spectrum(axes: Axes, force: Force, colour: str) -> None:
    axes.axvline(1 / force.mesh_frequency_ratio, zorder=1, **_NATURAL)
    if len(force.orders) > _MANY_LINES:
        axes.plot(force.orders, force.amplitudes, color=colour, linewidth=0.4)
    else:
        axes.vlines(force.orders, 0, force.amplitudes, color=colour, linewidth=1.4)
    axes.set_ylabel("Amplitude (N)")
