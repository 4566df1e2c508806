"""A figure at print size: its sheet, letters and legends, and its files, with equal bytes for equal results."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import matplotlib.style
from matplotlib.artist import Artist
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from gearwear.io.atomic import atomic

SINGLE, DOUBLE = 85.0, 175.0  # column widths, mm
MILLIMETRE = 1 / 25.4  # inch
_MOST_COLUMNS = 4  # of a legend: more run off a sheet of two columns' width


@dataclass(frozen=True)
class Drawing:
    """A draw function, the size (mm) and layout engine of its sheet, and the variables that are read of its inputs."""

    draw: Callable[..., None]
    width: float
    height: float | Callable[..., float]
    layout: Literal["constrained"] | None
    variables: Mapping[str, tuple[str, ...]]

    def __call__(self, figure: Figure, *inputs: Any, **named: Any) -> None:
        """Draw on a figure."""
        self.draw(figure, *inputs, **named)

    def write(self, inputs: Mapping[str, Any], style: str | Path, svg: str | Path, png: str | Path) -> None:
        """Draw a figure and write it as SVG and PNG, both complete or not at all.

        Parameters
        ----------
        inputs : arguments of the draw function by name: datasets, paths of other files, lists of either, settings.
        style : a style of matplotlib.
        svg, png : paths of the files; both name the lineages of the datasets as their source.
        """
        height = self.height(**inputs) if callable(self.height) else self.height
        with matplotlib.style.context(style, after_reset=True):
            figure = Figure(figsize=(self.width * MILLIMETRE, height * MILLIMETRE), layout=self.layout)
            self.draw(figure, **inputs)
            source = " ".join(["gearwear", *_lineages(inputs)])
            with atomic(svg) as vector, atomic(png) as pixels:
                figure.savefig(vector, format="svg", metadata={"Date": None, "Creator": None, "Source": source})
                # with the layout of the first file, and without a second drawing to find one: half the time of savefig
                figure.set_layout_engine("none")
                figure.set_dpi(matplotlib.rcParams["savefig.dpi"])
                FigureCanvasAgg(figure).print_png(pixels, metadata={"Software": None, "Source": source})


def sheet(
    width: float,
    height: float | Callable[..., float],
    layout: Literal["constrained"] | None = "constrained",
    variables: Mapping[str, tuple[str, ...]] | None = None,
) -> Callable[[Callable[..., None]], Drawing]:
    """Give a draw function its sheet.

    Parameters
    ----------
    width, height : mm; a function for the height takes the arguments of the draw function but the figure, by name.
    layout : layout engine; None where the draw function places its axes itself.
    variables : to read of an input, by its name; of an input that is not named, all.
    """
    return lambda draw: Drawing(draw, width, height, layout, variables or {})


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
