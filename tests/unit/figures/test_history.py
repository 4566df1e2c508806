"""The wear history: a line for every case, a point for every wear cycle."""

import numpy as np
import pytest
import xarray as xr
from matplotlib.figure import Figure

from gearwear.figures import history

READ = history.draw.variables
STATES = [
    {"case": "short", "cycle": 1, "place": 0, "bulk_temperature": 20.0, "running_cycles": 1e8},
    {"case": "long", "cycle": 2, "place": 3, "bulk_temperature": 100.0, "running_cycles": 2e8},
]


def test_files_of_all_cases_become_a_line_for_each():
    cycles = [0, 1, 0, 1, 2]
    along = {"gear": ["pinion", "gear"]}
    wear = [
        xr.Dataset({"wear_depth": (("gear", "path"), [[0, 2e-6 * q], [1e-6 * q, 0]]), "running_cycles": 1e8 * q}, along)
        for q in cycles
    ]
    mesh = [
        xr.Dataset({name: ("mesh_phase", np.array([1.0, 3.0]) * (1 + q)) for name in READ["transmission_error"]})
        for q in cycles
    ]
    geometry = xr.Dataset({"mesh_phase_width": ("mesh_phase", [0.75, 0.25])})
    figure = Figure()
    history.draw(figure, geometry, wear, mesh, {"states": STATES})
    lines = [[line.get_ydata().tolist() for line in axes.lines] for axes in figure.axes]
    assert lines[0] == [pytest.approx([0, 2]), pytest.approx([0, 2, 4])]
    assert lines[1] == [pytest.approx([0, 1]), pytest.approx([0, 1, 2])]
    assert lines[2][1] == pytest.approx([1.5e6, 3e6, 4.5e6])
    assert lines[3][0] == pytest.approx([1.5e-8, 3e-8])
    assert figure.axes[0].lines[1].get_xdata() == pytest.approx([0, 0.1, 0.2])
    assert [text.get_text() for text in figure.legends[0].get_texts()] == ["short, 20 °C", "long, 100 °C"]
