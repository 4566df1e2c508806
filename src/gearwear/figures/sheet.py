"""A figure at print size: its sheet, letters and legends, and its files, with equal bytes for equal results."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal, NamedTuple, TypeVar

import matplotlib.style
from matplotlib.artist import Artist
from matplotlib.figure import Figure

from gearwear.io.atomic import atomic

SINGLE, DOUBLE = 85.0, 175.0  # column widths, mm
MILLIMETRE = 1 / 25.4  # inch
_MOST_COLUMNS = 4  # of a legend: more run off a sheet of two columns' width

Draw = TypeVar("Draw", bound=Callable[..., None])


class Sheet(NamedTuple):
    """Size (mm), layout engine, and the variables that are read of inputs of many files (None: all)."""

    width: float
    height: float | Callable[..., float]
    layout: Literal["constrained"] | None
    variables: Mapping[str, Sequence[str]]


def sheet(
    width: float,
    height: float | Callable[..., float],
    layout: Literal["constrained"] | None = "constrained",
    variables: Mapping[str, Sequence[str]] | None = None,
) -> Callable[[Draw], Draw]:
    """Give a draw function its sheet, as its attribute `sheet`.

    Parameters
    ----------
    width, height : mm; a function for the height takes the arguments of the draw function but the figure, by name.
    layout : layout engine; None where the draw function places its axes itself.
    variables : what is read of an input, by its name; of other inputs everything.
    """

    def give(draw: Draw) -> Draw:
        draw.sheet = Sheet(width, height, layout, variables or {})  # type: ignore[attr-defined]
        return draw

    return give


def write(draw: Callable[..., None], inputs: Mapping[str, Any], style: str, svg: str, png: str) -> None:
    """Draw a figure and write it as SVG and PNG, both complete or not at all.

    Parameters
    ----------
    draw : function of the figure and of `inputs`, with a sheet.
    inputs : datasets, lists of datasets, paths of other files, and settings, by name.
    style : path of a style of matplotlib.
    svg, png : paths of the files; both name the lineages of the datasets as their source.
    """
    width, height, layout, _ = draw.sheet  # type: ignore[attr-defined]
    if callable(height):
        height = height(**inputs)
    with matplotlib.style.context(style, after_reset=True):
        figure = Figure(figsize=(width * MILLIMETRE, height * MILLIMETRE), layout=layout)
        draw(figure, **inputs)
        source = " ".join(["gearwear", *_lineages(inputs)])
        with atomic(svg) as vector, atomic(png) as pixels:
            figure.savefig(vector, format="svg", metadata={"Date": None, "Creator": None, "Source": source})
            figure.set_layout_engine("none")  # the second file has the places of the first: to find them takes a third
            figure.savefig(pixels, format="png", metadata={"Software": None, "Source": source})


def letter(position: int) -> str:
    """Return the letter of a panel: (a), (b), ..."""
    return f"({chr(ord('a') + position)})"


def legend_above(figure: Figure, keys: Sequence[Artist], columns: int) -> None:
    """Draw the legend of the figure above its panels, entries in rows of `columns`."""
    columns = min(columns, _MOST_COLUMNS)
    by_column = [key for column in range(columns) for key in keys[column::columns]]
    figure.legend(handles=by_column, loc="outside upper center", ncols=columns)


def _lineages(inputs: Mapping[str, Any]) -> list[str]:
    """Return the lineages of the datasets, input after input by name, each once an input."""
    found = []
    for _, value in sorted(inputs.items()):
        several = value if isinstance(value, list) else [value]
        found += sorted({one.attrs["lineage"] for one in several if "lineage" in getattr(one, "attrs", {})})
    return found
