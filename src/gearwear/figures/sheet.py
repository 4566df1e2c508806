"""One figure at print size, written as SVG and PNG, with the same bytes for the same results."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Literal

import matplotlib.style
from matplotlib.figure import Figure

from gearwear.io import store

SINGLE, DOUBLE = 85.0, 175.0  # column widths, mm
MILLIMETRE = 1 / 25.4  # inch


@contextmanager
def sheet(job, width: float, height: float, layout: Literal["constrained"] | None = "constrained") -> Iterator[Figure]:
    """Give an empty figure in the style of `job`; write it as the outputs of `job` if the body succeeds.

    Parameters
    ----------
    job : object with `input.style` and result files in `input`, `output.svg` and `output.png`.
    width, height : of the figure, mm.
    layout : layout engine; None where the body places its axes itself.
    """
    with matplotlib.style.context(job.input.style, after_reset=True):
        figure = Figure(figsize=(width * MILLIMETRE, height * MILLIMETRE), layout=layout)
        yield figure
        source = " ".join(["gearwear", *store.lineages(job).values()])
        with store.atomic(job.output.svg) as vector, store.atomic(job.output.png) as pixels:
            figure.savefig(vector, format="svg", metadata={"Date": None, "Creator": None, "Source": source})
            figure.set_layout_engine("none")  # the second file has the places of the first: to find them takes a third
            figure.savefig(pixels, format="png", metadata={"Software": None, "Source": source})


def letter(position: int) -> str:
    """Return the letter of a panel: (a), (b), ..."""
    return f"({chr(ord('a') + position)})"
