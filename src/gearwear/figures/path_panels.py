"""Panels of several quantities along the path of contact, one line a state."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import xarray as xr
from matplotlib.figure import Figure

from gearwear.figures import legend, path_axis, states
from gearwear.figures.sheet import letter


class Panel(NamedTuple):
    """Title, label of the ordinate, and for every state the field over `path`, in the unit of the label."""

    title: str
    label: str
    fields: Sequence[xr.DataArray]


def draw(
    figure: Figure,
    geometry: xr.Dataset,
    panels: Sequence[Panel],
    drawn: Sequence[dict[str, Any]],
    columns: int = 2,
    one_scale: bool = False,
) -> None:
    """Draw the panels row by row, with the zones of contact.

    Parameters
    ----------
    geometry : dataset of the geometry stage.
    panels : as many as fill the rows.
    drawn : the states, in the order of the fields.
    columns : panels in a row.
    one_scale : whether all panels share one ordinate.
    """
    grid = figure.subplots(len(panels) // columns, columns, sharex=True, sharey=one_scale, squeeze=False)
    for position, (axes, panel) in enumerate(zip(grid.flat, panels, strict=True)):
        for place, (field, state) in enumerate(zip(panel.fields, drawn, strict=True)):
            path_axis.draw(axes, field, 1.0, **states.line(place, state))
        path_axis.mark(axes, geometry)
        axes.set_title(f"{letter(position)} {panel.title}", loc="left")
        axes.set_ylabel(panel.label)
    for axes in grid[:-1].flat:
        axes.set_xlabel("")
    for column in grid.T:
        figure.align_ylabels(column)
    lines, _ = grid[0, 0].get_legend_handles_labels()
    legend.above(figure, [*lines, *path_axis.keys()], len(drawn))
