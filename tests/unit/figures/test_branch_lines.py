"""Branches of periodic orbits over a diagram."""

import numpy as np
import pytest
import xarray as xr
from matplotlib.figure import Figure

from gearwear.codes.branch_codes import FOLD, PERIOD_DOUBLING
from gearwear.figures import branch_lines


@pytest.fixture
def followed():
    """A branch of period 1 with a fold and one of period 2 that begins at a doubling, with noise on its first flag."""
    section = [[1.0, np.nan], [1.2, np.nan], [1.4, np.nan], [1.6, np.nan], [1.8, np.nan], [0.0, 0.0], [0.5, -9.0]]
    return xr.Dataset(
        {
            "ste": ("node", [0.0, 0.5, 1.0, 0.5, 0.2, 0.2, 0.4]),
            "branch_index": ("node", [0, 0, 0, 0, 0, 1, 1]),
            "branch_displacement": (("node", "iterate"), section),
            "stable": ("node", [1, 1, 1, 0, 0, 0, 1]),
            "special_point": ("node", [0, 0, FOLD, 0, 0, 0, 0]),
            "branch_period": ("branch", [1, 2]),
        }
    )


def test_pieces_of_one_stability_meet_at_special_points(followed):
    pieces = [(nodes.tolist(), stability) for nodes, stability in branch_lines.runs(followed)]
    assert pieces == [([0, 1, 2], "stable"), ([2, 3, 4], "unstable"), ([5, 6], "stable")]


def test_lines_are_solid_or_dashed_and_every_iterate_is_drawn(followed):
    axes = Figure().add_subplot()
    axes.set_ylim(0.0, 2.0)
    branch_lines.draw(axes, "ste", followed)
    lines = [line for line in axes.lines if line.get_marker() == "None" and len(line.get_xdata())]
    assert [line.is_dashed() for line in lines] == [False, True, False, False]
    assert lines[2].get_ydata().tolist() == [0.0, 0.5] and lines[3].get_ydata().tolist() == [0.0, -9.0]
    marks = [line for line in axes.lines if line.get_marker() == "^"]
    assert [(x, y) for x, y in zip(*marks[0].get_data(), strict=True) if np.isfinite(y)] == [(1.0, 1.4)]


def test_special_points_have_their_value_beside_them_where_there_is_room(followed):
    followed["special_point"][:] = [0, FOLD, FOLD, FOLD, PERIOD_DOUBLING, PERIOD_DOUBLING, 0]
    followed["ste"].values[4:6] = 0.2, 0.201
    followed["branch_displacement"].values[5] = 1.8, np.nan
    axes = Figure().add_subplot()
    axes.set_ylim(0.0, 2.0)
    branch_lines.draw(axes, "ste", followed)
    assert [text.get_text() for text in axes.texts] == ["0.200", "0.500", "0.500", "1.000"]
    assert [text.xy for text in axes.texts] == [(0.2, 1.8), (0.5, 1.2), (0.5, 1.6), (1.0, 1.4)]


def test_far_orbits_do_not_squeeze_the_diagram(followed):
    axes = Figure().add_subplot()
    axes.set_ylim(0.0, 2.0)
    branch_lines.draw(axes, "ste", followed)
    low, high = axes.get_ylim()
    assert -0.6 < low < 0 and high == 2.0


def test_legend_names_what_is_drawn():
    labels = [key.get_label() for key in branch_lines.keys({0, FOLD, PERIOD_DOUBLING}, True)]
    assert labels == ["stable orbits", "unstable orbits", "fold", "period doubling"]
    assert branch_lines.keys({0}, False) == []


def test_nothing_followed_draws_nothing(followed):
    axes = Figure().add_subplot()
    limits = axes.get_ylim()
    branch_lines.draw(axes, "ste", followed.isel(node=[], branch=[]))
    assert axes.get_ylim() == limits
