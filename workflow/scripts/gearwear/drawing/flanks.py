"""Two panels, pinion and gear, of a length on either flank along the path of contact."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import xarray as xr
from matplotlib.figure import Figure

from gearwear.drawing import path_axis, states
from gearwear.drawing.sheet import letter


def draw(
    figure: Figure, geometry: xr.Dataset, fields: Sequence[xr.DataArray], drawn: Sequence[dict[str, Any]], label: str
) -> None:
    """Draw one line a state in either panel.

    Parameters
    ----------
    geometry : dataset of the geometry stage.
    fields : (gear, path) of every state, m.
    drawn : the states, in the order of `fields`.
    label : of the ordinate, in micrometres.
    """
    panels = figure.subplots(1, 2, sharey=True)
    for position, (axes, member) in enumerate(zip(panels, geometry["gear"].values, strict=True)):
        for place, (field, state) in enumerate(zip(fields, drawn, strict=True)):
            path_axis.draw(axes, field.sel(gear=member), 1e6, **states.line(place, state))
        path_axis.mark(axes, geometry)
        path_axis.name_flanks(axes, geometry, str(member))
        axes.set_title(f"{letter(position)} {str(member).capitalize()}", loc="left", pad=13)
    panels[0].set_ylabel(label)
    panels[0].set_ylim(bottom=0)
    lines, _ = panels[0].get_legend_handles_labels()
    figure.legend(handles=[*lines, *path_axis.keys()], loc="outside upper center", ncols=len(lines))
