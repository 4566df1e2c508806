"""Dynamic mesh force over mesh periods, and its spectrum over the mesh harmonics, one strip a state."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from gearwear.figures import legend, motion_classes, path_axis, phase_axis, states
from gearwear.figures.sheet import letter

HIGHEST = 10  # order of the mesh frequency
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


def draw(figure: Figure, geometry: xr.Dataset, forces: Sequence[Force], drawn: Sequence[dict[str, Any]]) -> None:
    """Draw the histories on the left, the spectra below each other on the right.

    Parameters
    ----------
    geometry : dataset of the geometry stage.
    forces, drawn : of every state.
    """
    grid = figure.add_gridspec(len(forces), 2)
    history = figure.add_subplot(grid[:, 0])
    periods = min(max(phase_axis.PERIODS, *(len(force.history) for force in forces)), _LONGEST)
    for place, (force, state) in enumerate(zip(forces, drawn, strict=True)):
        time = (np.arange(periods)[:, None] + force.phase).ravel()
        history.plot(time, 1e-3 * np.resize(force.history, time.shape), **states.line(place, state))
    history.axhline(1e-3 * forces[0].mean, label="static", zorder=1, **_MEAN)
    phase_axis.mark(history, geometry, periods)
    history.set_ylabel("Dynamic mesh force (kN)")
    history.set_title(f"{letter(0)} History", loc="left")
    shared = None
    largest = max(force.amplitudes.max() for force in forces)
    for place, (force, state) in enumerate(zip(forces, drawn, strict=True)):
        axes = shared = figure.add_subplot(grid[place, 1], sharex=shared, sharey=shared)
        _draw_spectrum(axes, force, states.colour(place))
        axes.set_title(f"{letter(place + 1)} {states.name(state)}: {motion_classes.short(force.motion)}", loc="left")
        axes.tick_params(labelbottom=place == len(forces) - 1)
        axes.set_yscale("log")
        axes.set_ylim(_DECADES * largest, 3 * largest)
        axes.set_xlim(0, HIGHEST + 0.5)
    axes.set_xticks(range(HIGHEST + 1))
    axes.set_xlabel("Order of the mesh frequency")
    lines, _ = history.get_legend_handles_labels()
    natural = Line2D([], [], label="natural frequency", **_NATURAL)
    legend.above(figure, [*lines, natural, *path_axis.keys(with_pitch_point=False)], len(drawn))


def _draw_spectrum(axes: Axes, force: Force, colour: str) -> None:
    axes.axvline(1 / force.mesh_frequency_ratio, zorder=1, **_NATURAL)
    if len(force.orders) > _MANY_LINES:
        axes.plot(force.orders, force.amplitudes, color=colour, linewidth=0.4)
    else:
        axes.vlines(force.orders, 0, force.amplitudes, color=colour, linewidth=1.4)
    axes.set_ylabel("Amplitude (N)")
