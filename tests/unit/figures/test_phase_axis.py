"""Values of one mesh period, drawn over several, open where a pair enters or leaves."""

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from gearwear.figures import phase_axis


def test_two_periods_with_gaps_at_every_change_of_pairs():
    geometry = xr.Dataset({"leaving": ("mesh_phase", [3, 4, -1])}, {"mesh_phase": [1 / 6, 0.5, 5 / 6]})
    axes = Figure().subplots()
    phase_axis.draw(axes, geometry, np.array([2.0, 3.0, 1.0]))
    phase, value = axes.lines[0].get_data()
    np.testing.assert_allclose(value, [2, 3, np.nan, 1, np.nan] * 2)
    np.testing.assert_allclose(phase[[0, 1, 3, 5, 8]], [1 / 6, 0.5, 5 / 6, 7 / 6, 11 / 6])
