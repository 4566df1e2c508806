"""Motion classes on paper: names, colours, and strips that show which class holds where."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Patch, Rectangle

from gearwear.codes.motion_class import MOTION_CLASSES

_NAMES = {code: name for name, code in MOTION_CLASSES.items()}
# Okabe and Ito (2008), safe for colour-blind readers; a lighter grey would look like QP to those who see no green.
_COLOURS = {
    "P1": "#0072B2",
    "P2": "#56B4E9",
    "P4": "#009E73",
    "P8": "#000000",
    "P3": "#F0E442",
    "P6": "#E69F00",
    "QP": "#CC79A7",
    "CH": "#D55E00",
}
_OTHER_PERIOD, _UNDECIDED = "#505050", "#FFFFFF"
_WORDS = {"CH": "chaotic", "QP": "quasi-periodic", "not_converged": "not decided"}
_BRIGHT = ("P2", "P3", "P6", "QP", "not_converged")
_OTHER = "other period"
_LEAST_WIDTH = 0.022  # of the axis, room for two letters


def name_of(code: int) -> str:
    """Return the name of a motion class by its code."""
    return _NAMES[int(code)]


def short(name: str) -> str:
    """Return the name of a class as panels show it."""
    return "?" if name == "not_converged" else name


def colour(name: str) -> str:
    """Return the colour of a class by its name; white for one that is not decided."""
    return _UNDECIDED if name == "not_converged" else _COLOURS.get(name, _OTHER_PERIOD)


def rank(name: str) -> tuple[int, str]:
    """Return a key that sorts names of classes: by period, then quasi-periodic, chaotic and undecided."""
    return (int(name[1:]) if name[1:].isdecimal() else 1000, name)


def runs(swept: np.ndarray, names: Sequence[str]) -> list[tuple[float, float, str]]:
    """Return (low, high, class) of neighbours of one class, meeting midway between points; `swept` ascends."""
    middles = (swept[1:] + swept[:-1]) / 2
    edges = np.concatenate([swept[:1], middles, swept[-1:]])
    changes = [i for i in range(1, len(names)) if names[i] != names[i - 1]]
    starts, ends = [0, *changes], [*changes, len(names)]
    return [(float(edges[i]), float(edges[j]), names[i]) for i, j in zip(starts, ends, strict=True)]


def draw_strip(axes: Axes, row: float, zones: Iterable[tuple[float, float, str]]) -> None:
    """Draw one row of height 1, its lower edge at `row`; wide zones carry the name of their class."""
    left, right = axes.get_xlim()
    for low, high, name in zones:
        axes.add_patch(Rectangle((low, row + 0.06), high - low, 0.88, linewidth=0, **_fill(name)))
        if high - low > _LEAST_WIDTH * (right - left):
            tint = "black" if name in _BRIGHT else "white"
            middle = (low + high) / 2
            axes.text(middle, row + 0.47, short(name), ha="center", va="center_baseline", color=tint, fontsize=6)


def keys(names: Iterable[str], hatched: bool = True) -> list[Patch]:
    """Return the legend entries of the classes named, in the order of the table of classes.

    Parameters
    ----------
    hatched : whether what is not decided is hatched, as in strips, or only white, as in maps.
    """
    found = set(names)
    listed: list[str] = [name for name in ("P1", "P2", "P4", "P8", "P3", "P6") if name in found]
    if any(name.startswith("P") and name not in _COLOURS for name in found):
        listed.append(_OTHER)
    listed += [name for name in ("QP", "CH", "not_converged") if name in found]
    patches = [Patch(**_fill(name), linewidth=0, label=_worded(name)) for name in listed]
    if not hatched and "not_converged" in found:
        patches[-1].set(hatch=None, linewidth=0.4)
    return patches


def _worded(name: str) -> str:
    return f"{short(name)}, {_WORDS[name]}" if name in _WORDS else name


def _fill(name: str) -> dict[str, Any]:
    if name == "not_converged":
        return {"facecolor": _UNDECIDED, "edgecolor": "#777777", "hatch": "//////"}
    return {"facecolor": colour(name)}
