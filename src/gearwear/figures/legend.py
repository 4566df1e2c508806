"""Legends above the panels, read row by row."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.artist import Artist
from matplotlib.figure import Figure

MOST_COLUMNS = 4  # more run off a sheet of two columns' width


def above(figure: Figure, keys: Sequence[Artist], columns: int) -> None:
    """Draw the legend of the figure above its panels, entries in rows of `columns`."""
    columns = min(columns, MOST_COLUMNS)
    by_column = [key for column in range(columns) for key in keys[column::columns]]
    figure.legend(handles=by_column, loc="outside upper center", ncols=columns)
