"""The candidates of a calibration: how the sweeps trade off, and which claims the good candidates agree with."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator

from gearwear.calibration.table import STUDY, good
from gearwear.config.parameters import SWEEPS
from gearwear.figures.sheet import DOUBLE, legend_above, letter, sheet

_PAIRS = ((0, 1), (0, 2), (1, 2))  # of SWEEPS
_NAMES = {"mesh_frequency": "mesh frequency", "ste": "STE", "backlash": "backlash"}
# Okabe and Ito (2008), safe for colour-blind readers.
_COLOURS = {"mesh_frequency": "#0072B2", "ste": "#D55E00", "backlash": "#009E73", "states": "#999999"}
_CLOUD, _INK = "#9AA5B1", "#000000"
_LARGEST = 60.0  # area of the circle with most candidates, points squared


@sheet(DOUBLE, 130.0)
def draw(figure: Figure, calibration: xr.Dataset, cfg: dict[str, Any]) -> None:
    """Draw three panels of agreements, sweep against sweep, and below them a bar for every claim.

    Parameters
    ----------
    calibration : as calibration.verdict.compared gives it.
    """
    grid = figure.add_gridspec(2, 3, height_ratios=(1.0, 0.9))
    full = _members(calibration)
    for position, (across, up) in enumerate(_PAIRS):
        axes = figure.add_subplot(grid[0, position])
        _trade(axes, calibration, full, across, up)
        axes.set_title(letter(position), loc="left")
    _bars(figure.add_subplot(grid[1, :]), calibration)
    legend_above(figure, _keys(), 4)


def _members(found: xr.Dataset) -> np.ndarray:
    """Return the agreements of the members by sweep, (members, sweeps)."""
    about = found["claim_subject"].values
    agrees = found["member_agrees"].values
    return np.stack([agrees[:, about == name].sum(axis=1) for name in SWEEPS], axis=1)


def _trade(axes: Axes, found: xr.Dataset, full: np.ndarray, across: int, up: int) -> None:
    counted = found["candidate_agreements"].values[found["candidate_remark"].values == ""]
    places, number = np.unique(counted[:, [across, up]], axis=0, return_counts=True)
    axes.scatter(places[:, 0], places[:, 1], s=_LARGEST * number / number.max(), color=_CLOUD, linewidths=0)
    is_study = found["member"].values == STUDY
    axes.plot(*full[~is_study][:, [across, up]].T, "*", color=_COLOURS["ste"], markersize=7, markeredgewidth=0)
    axes.plot(*full[is_study][:, [across, up]].T, "x", color=_INK, markersize=6, markeredgewidth=1.4)
    for side, place in (("x", across), ("y", up)):
        total = int(found["claims_of_sweep"].values[place])
        getattr(axes, f"set_{side}lim")(-0.7, total + 0.7)
        getattr(axes, f"{side}axis").set_major_locator(MaxNLocator(integer=True))
        getattr(axes, f"set_{side}label")(f"Claims on {_NAMES[SWEEPS[place]]}, of {total}")


def _bars(axes: Axes, found: xr.Dataset) -> None:
    share = found["claim_agrees"].values[good(found)].mean(axis=0)
    subjects = found["claim_subject"].values
    axes.bar(range(len(share)), 100 * share, color=[_COLOURS[name] for name in subjects], width=0.75)
    axes.set_xticks(
        range(len(share)), found["claim"].values, rotation=60, ha="right", rotation_mode="anchor", fontsize=6
    )
    axes.tick_params(axis="x", which="both", length=0)
    axes.set_xlim(-0.7, len(share) - 0.3)
    axes.set_ylim(0, 105)
    axes.set_ylabel("Share of good candidates\nthat agree (%)")
    axes.set_title(letter(len(_PAIRS)), loc="left")


def _keys() -> list[Line2D]:
    dot: dict[str, Any] = {"linestyle": "none", "markeredgewidth": 0}
    return [
        Line2D([], [], marker="o", color=_CLOUD, label="candidates, by number", **dot),
        Line2D([], [], marker="*", color=_COLOURS["ste"], markersize=7, label="best, in full", **dot),
        Line2D(
            [], [], marker="x", color=_INK, markersize=6, linestyle="none", markeredgewidth=1.4, label="study, in full"
        ),
    ]
