"""Lines along the path of contact keep their jumps."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from gearwear.figures import path_axis


def test_line_is_open_between_the_two_values_of_a_doubled_node():
    field = xr.DataArray([1e-6, 2e-6, 5e-6, 6e-6], {"path": [1e-3, 2e-3, 2e-3, 3e-3]}, ("path",))
    axes = Figure().subplots()
    path_axis.draw(axes, field, 1e6)
    drawn = axes.lines[0].get_xydata()
    np.testing.assert_allclose(drawn, [[1, 1], [2, 2], [np.nan, np.nan], [2, 5], [3, 6]])


def test_line_without_doubled_nodes_is_whole():
    field = xr.DataArray([1.0, 2.0, 3.0], {"path": [0.0, 1.0, 2.0]}, ("path",))
    axes = Figure().subplots()
    path_axis.draw(axes, field, 1.0)
    assert np.isfinite(axes.lines[0].get_ydata()).all()
