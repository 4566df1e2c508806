import numpy as np
import pytest
import xarray as xr
from matplotlib.collections import PathCollection
from matplotlib.figure import Figure

from gearwear.figures import exponents

STATE = {"case": "with", "bulk_temperature": 100.0, "running_cycles": 2.1e9}
PANEL = {"sweep": "mesh_frequency", "swept": {}, "state": STATE}


def sweep(exponent):
    """Return a sweep of period 1, chaos, and a point that is not decided."""
    section = np.array([[0.5, 0.5, 0.5], [0.1, 0.2, 0.3], [0.7, 0.8, np.nan]])
    values = {
        "section_displacement": (("point", "sample"), section),
        "period": ("point", [1, 0, 0]),
        "lyapunov_exponent": ("point", exponent),
    }
    return xr.Dataset(values, {"mesh_frequency": ("point", [0.5, 1.0, 1.5])})


def test_zero_is_in_the_middle_and_strong_contraction_takes_no_colours():
    scale = exponents.norm(np.append(np.linspace(-0.1, 0.05, 200), [-4.0, np.nan]))
    assert scale(0.0) == 0.5
    assert scale(0.05) == 1.0
    assert -0.2 < scale.vmin < -0.09


@pytest.mark.parametrize("values", [[-0.1, -0.2], [0.0], [0.3, np.nan]])
def test_a_scale_has_both_sides_even_if_the_exponents_have_one(values):
    scale = exponents.norm(np.array(values))
    assert scale.vmin < 0 < scale.vmax


def test_a_dot_for_every_mesh_period_with_the_colour_of_its_motion():
    figure = Figure()
    exponents.draw(figure, [sweep([-0.08, 0.04, np.nan])], {"panels": [PANEL]})
    figure.draw_without_rendering()
    endless, repeats = (one for one in figure.axes[0].collections if isinstance(one, PathCollection))
    assert np.asarray(repeats.get_offsets()).tolist() == [[0.5, 0.5]]
    assert len(endless.get_offsets()) == 5
    blue, orange, grey = repeats.get_facecolors()[0], endless.get_facecolors()[0], endless.get_facecolors()[-1]
    assert blue[2] > blue[0] and orange[0] > orange[2] and grey[0] == grey[1] == grey[2]


def test_the_grid_has_no_empty_panel():
    figure = Figure()
    exponents.draw(figure, [sweep([-0.08, 0.04, 0.0])] * 3, {"panels": [PANEL] * 3})
    assert len(figure.axes) == 3 + 1  # with the colour bar
