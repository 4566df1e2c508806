import numpy as np
import pytest
import xarray as xr
from matplotlib.figure import Figure

from gearwear.figures import mesh_force

PHASE = (np.arange(40) + 0.5) / 40
GEOMETRY = xr.Dataset({"contact_ratio": 1.6})
STATE = {"case": "with", "bulk_temperature": 100.0, "running_cycles": 2.1e9}


def force(periods):
    """Return a force whose every mesh period has a level of its own."""
    history = np.repeat(4000.0 + 100 * np.arange(periods)[:, None], 40, axis=1)
    orders = np.arange(1, 10 * periods + 1) / periods
    return mesh_force.Force(PHASE, history, 4000.0, orders, np.exp(-orders), 0.25, "CH")


@pytest.mark.parametrize("periods, shown", [((1,), 2), ((1, 3), 3), ((2, 240), 8)])
def test_history_shows_whole_repetitions_up_to_eight_periods(periods, shown):
    figure = Figure()
    mesh_force.draw_forces(figure, GEOMETRY, [force(count) for count in periods], [STATE] * len(periods))
    history = figure.axes[0]
    assert history.get_xlim() == (0, shown)
    levels = history.lines[0].get_ydata()[::40]
    assert levels == pytest.approx(np.resize(4 + 0.1 * np.arange(periods[0]), shown))


def test_every_state_has_its_spectrum_and_the_natural_frequency():
    figure = Figure()
    mesh_force.draw_forces(figure, GEOMETRY, [force(1), force(240)], [STATE] * 2)
    few, many = figure.axes[1:]
    assert few.lines[0].get_xdata() == [4.0, 4.0]
    assert [segment[0, 0] for segment in few.collections[0].get_segments()] == list(range(1, 11))
    assert len(many.lines[1].get_xdata()) == 2400
