"""Colours of basins and the height of their sheet."""

import numpy as np
import pytest
import xarray as xr
from matplotlib.colors import to_rgb

from gearwear.figures import basin_panels, motion_classes


def mapped(points, attractors, undecided=0.0):
    return xr.Dataset(
        {"attractors": ("point", [attractors] * points), "undecided_share": ("point", [undecided] * points)}
    )


def test_every_attractor_has_a_colour_of_its_own_and_the_first_of_a_class_that_of_the_class():
    names = ["P1", "P2", "P2", "P2", "P2", "P2", "P2", "CH", "not_converged"]
    found = basin_panels.colours(names)
    assert len(set(found)) == len(names)
    for name in set(names):
        assert found[names.index(name)] == pytest.approx(to_rgb(motion_classes.colour(name)))
    assert np.all((np.array(found) >= 0) & (np.array(found) <= 1))


def test_black_has_lighter_tints():
    first, second = basin_panels.colours(["P8", "P8"])
    assert sum(second) > sum(first) + 0.5


def test_a_sheet_grows_by_rows_of_panels_and_lines_of_legends():
    one = basin_panels.height(mapped(1, 2))
    assert basin_panels.height(mapped(3, 2)) == one
    assert basin_panels.height(mapped(4, 2)) > one + 40
    assert one < basin_panels.height(mapped(1, 3)) == basin_panels.height(mapped(1, 2, 0.1)) < one + 10
