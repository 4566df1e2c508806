"""Sweeps up and down side by side."""

import numpy as np
import pytest
import xarray as xr
from matplotlib.figure import Figure

from gearwear.figures import sections

VALUES = np.array([1.0, 2.0, 3.0, 4.0, 5.0])


def sweep(classes, levels):
    section = np.repeat(np.array(levels, dtype=float)[:, None], 6, axis=1)
    return xr.Dataset(
        {
            "section_displacement": (("point", "sample"), section),
            "section_velocity": (("point", "sample"), 0 * section),
            "motion_class": ("point", classes),
            "period": ("point", [code if code < 100 else 0 for code in classes]),
        }
    )


@pytest.fixture
def sweeps():
    """Two different motions of period 1 at the second and third point, chaos against period 1 at the last one."""
    up = sweep([1, 1, 1, 1, 101], [0, 0, 0, 0, 0])
    return {"restart": up, "up": up, "down": sweep([1, 1, 1, 1, 1], [0, 1, 1, 0, 0])}


def test_ranges_end_midway_between_points(sweeps):
    assert sections.differing_ranges(VALUES, sweeps) == [(1.5, 3.5), (4.5, 5.0)]
    assert sections.differing_ranges(VALUES, sweeps | {"down": sweeps["up"]}) == []


def test_both_motions_are_drawn_where_they_differ_and_nowhere_else(sweeps):
    axes = Figure().add_subplot()
    sections.draw_both(axes, VALUES, sweeps)
    dots = {(line.get_marker(), *point) for line in axes.lines for point in zip(*line.get_data(), strict=True)}
    assert dots == {("^", 2, 0), ("^", 3, 0), ("^", 5, 0), ("v", 2, 1), ("v", 3, 1), ("v", 5, 0)}
    up, down = (next(line for line in axes.lines if line.get_marker() == marker) for marker in "^v")
    assert up.get_color() != down.get_color()


def test_legend_names_up_and_down_only_where_they_are_drawn():
    assert [key.get_label() for key in sections.keys("down", False)] == ["section, downwards"]
    words = [key.get_label() for key in sections.keys("restart", True)]
    assert words == ["section, from rest", "upwards", "downwards", "up and down differ"]
