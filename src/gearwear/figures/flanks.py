"""Panels, pinion and gear side by side, of a length on either flank along the path of contact."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, cast

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from gearwear.figures import legend, path_axis, states
from gearwear.figures.sheet import letter


def draw(
    figure: Figure,
    geometry: xr.Dataset,
    fields: Sequence[xr.DataArray],
    drawn: Sequence[dict[str, Any]],
    label: str,
    enlarged: bool = False,
) -> None:
    """Draw one line a state in either panel.

    Parameters
    ----------
    geometry : dataset of the geometry stage.
    fields : (gear, path) of every state, m.
    drawn : the states, in the order of `fields`.
    label : of the ordinate, in micrometres.
    enlarged : give either gear its own scale and add a row that ends at the largest value behind the first zone
        change; otherwise both share one scale.
    """
    members = [str(member) for member in geometry["gear"].values]
    rows = 2 if enlarged else 1
    panels = figure.subplots(rows, len(members), sharex=True, squeeze=False)
    behind = fields[0]["path"].values > float(geometry["lowest_single_contact"])
    for place, (row, column) in enumerate(np.ndindex(panels.shape)):
        axes, member = cast(Axes, panels[row, column]), members[column]
        of_member = [field.sel(gear=member) for field in fields]
        for i, (field, state) in enumerate(zip(of_member, drawn, strict=True)):
            path_axis.draw(axes, field, 1e6, **states.line(i, state))
        path_axis.mark(axes, geometry)
        if enlarged:
            _limit(axes, [field[behind] for field in of_member] if row else of_member)
        else:
            _limit(axes, fields)
        axes.set_title(
            f"{letter(place)} {member.capitalize()}{', enlarged' if row else ''}", loc="left", pad=13 - 9 * row
        )
        if row < rows - 1:
            axes.set_xlabel("")
    for axes, member in zip(panels[0], members, strict=True):
        path_axis.name_flanks(axes, geometry, member)
    for axes in panels[:, 0]:
        axes.set_ylabel(label)
    figure.align_ylabels(panels[:, 0])
    lines, _ = panels[0, 0].get_legend_handles_labels()
    legend.above(figure, [*lines, *path_axis.keys()], len(lines))


def _limit(axes: Axes, fields: Sequence[xr.DataArray]) -> None:
    highest = 1.07e6 * max(float(field.max()) for field in fields)
    if highest > 0:
        axes.set_ylim(-0.02 * highest, highest)
