"""Figures of the flanks along the path of contact: wear, growth, contact temperature and the load of a pair."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple, cast

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from gearwear.figures import contact_axes, labels
from gearwear.figures.sheet import DOUBLE, legend_above, letter, sheet
from gearwear.mesh.sharing import share, springs_of

States = Sequence[dict[str, Any]]

_CONTACT = {
    "contact_temperature": ("Contact temperature", "Contact temperature (°C)"),
    "flash_temperature": ("Flash temperature", "Flash temperature rise (K)"),
    "friction_coefficient": ("Friction", "Coefficient of friction (1)"),
    "film_ratio": ("Film thickness over roughness", "Film ratio (1)"),
}
_LOAD = "Load of the pair\nover mean mesh force"


class Panel(NamedTuple):
    """Title, label of the ordinate, and for every state the field over `path`, in the unit of the label."""

    title: str
    label: str
    fields: Sequence[xr.DataArray]


@sheet(DOUBLE, 105.0)
def draw_wear(figure: Figure, geometry: xr.Dataset, wear: Sequence[xr.Dataset], cfg: dict[str, Any]) -> None:
    """Draw the wear depth of both flanks; the second row ends at the largest value behind the first zone change.

    Parameters
    ----------
    geometry, wear : datasets of these stages, wear of every state.
    cfg : the `states`.
    """
    depths = [one["wear_depth"] for one in wear]
    _draw_gears(figure, geometry, depths, cfg["states"], "Wear depth (µm)", enlarged=True)


@sheet(DOUBLE, 68.0)
def draw_growth(figure: Figure, geometry: xr.Dataset, deformation: Sequence[xr.Dataset], cfg: dict[str, Any]) -> None:
    """Draw the thermal growth of one flank of either gear, of every state."""
    growths = [one["thermal_growth"] for one in deformation]
    _draw_gears(figure, geometry, growths, cfg["states"], "Thermal growth of one flank (µm)")


@sheet(DOUBLE, 105.0)
def draw_contact_temperature(
    figure: Figure, geometry: xr.Dataset, temperature: Sequence[xr.Dataset], cfg: dict[str, Any]
) -> None:
    """Draw contact and flash temperature, friction and film ratio of every state."""
    panels = [Panel(*words, [one[name] for one in temperature]) for name, words in _CONTACT.items()]
    draw_panels(figure, geometry, panels, cfg["states"])


@sheet(DOUBLE, 68.0)
def draw_load_sharing(
    figure: Figure,
    geometry: xr.Dataset,
    mesh_stiffness: Sequence[xr.Dataset],
    transmission_error: Sequence[xr.Dataset],
    response: Sequence[xr.Dataset],
    cfg: dict[str, Any],
) -> None:
    """Draw the load of one pair under the static and under the dynamic mesh force, of every state."""
    files = zip(mesh_stiffness, transmission_error, response, strict=True)
    panels = (
        Panel("Static mesh force", _LOAD, [one["load_share_path"] for one in transmission_error]),
        Panel("Dynamic mesh force", _LOAD, [dynamic_load(geometry, *state) for state in files]),
    )
    draw_panels(figure, geometry, panels, cfg["states"], one_scale=True)


def dynamic_load(
    geometry: xr.Dataset, stiffness: xr.Dataset, transmission: xr.Dataset, response: xr.Dataset
) -> xr.DataArray:
    """Return the load of the pair over the mean mesh force (path,), mean over the periods of the response."""
    springs, removed = springs_of(geometry, stiffness), transmission["sharing_error"].values
    forces = response["mesh_force_path"].values
    loads = [np.maximum(force, 0) * share(springs, removed, force).load_share for force in forces]
    return transmission["load_share_path"].copy(data=np.mean(loads, axis=0) / float(response["mean_force"]))


def draw_panels(
    figure: Figure, geometry: xr.Dataset, panels: Sequence[Panel], states: States, one_scale: bool = False
) -> None:
    """Draw panels of several quantities along the path, two in a row, a line for every state; maybe on one scale."""
    grid = figure.subplots(len(panels) // 2, 2, sharex=True, sharey=one_scale, squeeze=False)
    for position, (axes, panel) in enumerate(zip(grid.flat, panels, strict=True)):
        for place, (field, state) in enumerate(zip(panel.fields, states, strict=True)):
            contact_axes.draw_along_path(axes, field, 1.0, **labels.line(place, state))
        contact_axes.mark_path(axes, geometry)
        axes.set_title(f"{letter(position)} {panel.title}", loc="left")
        axes.set_ylabel(panel.label)
    for axes in grid[:-1].flat:
        axes.set_xlabel("")
    for column in grid.T:
        figure.align_ylabels(column)
    lines, _ = grid[0, 0].get_legend_handles_labels()
    legend_above(figure, [*lines, *contact_axes.keys()], len(states))


def _draw_gears(
    figure: Figure,
    geometry: xr.Dataset,
    fields: Sequence[xr.DataArray],
    states: States,
    label: str,
    enlarged: bool = False,
) -> None:
    """Draw a length on either flank, (gear, path) in m, pinion and gear side by side.

    If `enlarged`, either gear has its own scale and a second row; otherwise both share one scale.
    """
    members = [str(member) for member in geometry["gear"].values]
    rows = 2 if enlarged else 1
    panels = figure.subplots(rows, len(members), sharex=True, squeeze=False)
    behind = fields[0]["path"].values > float(geometry["lowest_single_contact"])
    for place, (row, column) in enumerate(np.ndindex(panels.shape)):
        axes, member = cast(Axes, panels[row, column]), members[column]
        of_member = [field.sel(gear=member) for field in fields]
        for i, (field, state) in enumerate(zip(of_member, states, strict=True)):
            contact_axes.draw_along_path(axes, field, 1e6, **labels.line(i, state))
        contact_axes.mark_path(axes, geometry)
        if enlarged:
            _limit(axes, [field[behind] for field in of_member] if row else of_member)
        else:
            _limit(axes, fields)
        words = f"{letter(place)} {member.capitalize()}{', enlarged' if row else ''}"
        axes.set_title(words, loc="left", pad=13 - 9 * row)
        if row < rows - 1:
            axes.set_xlabel("")
    for axes, member in zip(panels[0], members, strict=True):
        contact_axes.name_flanks(axes, geometry, member)
    for axes in panels[:, 0]:
        axes.set_ylabel(label)
    figure.align_ylabels(panels[:, 0])
    lines, _ = panels[0, 0].get_legend_handles_labels()
    legend_above(figure, [*lines, *contact_axes.keys()], len(lines))


def _limit(axes: Axes, fields: Sequence[xr.DataArray]) -> None:
    highest = 1.07e6 * max(float(field.max()) for field in fields)
    if highest > 0:
        axes.set_ylim(-0.02 * highest, highest)
