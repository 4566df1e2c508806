"""Lines along the path of contact and over the mesh phase keep their jumps."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from gearwear.figures import contact_axes


def test_line_is_open_between_the_two_values_of_a_doubled_node():
    field = xr.DataArray([1e-6, 2e-6, 5e-6, 6e-6], {"path": [1e-3, 2e-3, 2e-3, 3e-3]}, ("path",))
    axes = Figure().subplots()
    contact_axes.draw_along_path(axes, field, 1e6)
    drawn = axes.lines[0].get_xydata()
    np.testing.assert_allclose(drawn, [[1, 1], [2, 2], [np.nan, np.nan], [2, 5], [3, 6]])


def test_line_without_doubled_nodes_is_whole():
    field = xr.DataArray([1.0, 2.0, 3.0], {"path": [0.0, 1.0, 2.0]}, ("path",))
    axes = Figure().subplots()
    contact_axes.draw_along_path(axes, field, 1.0)
    assert np.isfinite(axes.lines[0].get_ydata()).all()


def test_two_periods_with_gaps_at_every_change_of_pairs():
    geometry = xr.Dataset({"leaving": ("mesh_phase", [3, 4, -1])}, {"mesh_phase": [1 / 6, 0.5, 5 / 6]})
    axes = Figure().subplots()
    contact_axes.draw_over_phase(axes, geometry, np.array([2.0, 3.0, 1.0]))
    phase, value = axes.lines[0].get_data()
    np.testing.assert_allclose(value, [2, 3, np.nan, 1, np.nan] * 2)
    np.testing.assert_allclose(phase[[0, 1, 3, 5, 8]], [1 / 6, 0.5, 5 / 6, 7 / 6, 11 / 6])
