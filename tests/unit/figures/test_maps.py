import numpy as np
import pytest
import xarray as xr
from matplotlib.colors import to_hex
from matplotlib.figure import Figure

from gearwear.codes.motion_class import CHAOTIC, NOT_CONVERGED
from gearwear.figures import maps
from gearwear.figures.motion_classes import colour

STATE = {"case": "with", "cycle": 3, "bulk_temperature": 100.0, "running_cycles": 3e8, "flash": True}


def plane(coordinate, values, exponent):
    codes = np.array([[1, 2, CHAOTIC], [NOT_CONVERGED, 4, 5]], dtype=np.int32)
    fields = {"motion_class": (("row", "column"), codes), "lyapunov_exponent": (("row", "column"), exponent)}
    return xr.Dataset(fields, {coordinate: ("row", values), "mesh_frequency": ("column", [0.5, 1.0, 1.5])})


EXPONENT = np.array([[-0.1, -0.05, 0.06], [np.nan, -0.02, -0.01]])


def drawn(name, dataset):
    figure = Figure(layout="constrained")
    maps.draw(figure, dataset, {"map": name, "state": STATE})
    figure.draw_without_rendering()
    return figure


def test_edges_lie_midway_and_the_outer_cells_are_symmetric():
    np.testing.assert_allclose(maps.edges_of(np.array([1.0, 2.0, 4.0])), [0.5, 1.5, 3.0, 5.0])
    np.testing.assert_allclose(maps.edges_of(np.array([3.0])), [2.5, 3.5])


def test_every_cell_has_the_colour_of_its_class():
    dataset = plane("ste", [0.5, 1.0], EXPONENT)
    mesh = drawn("ste", dataset).axes[0].collections[0]
    cells = mesh.get_array().reshape(2, 3, 3)
    expected = [["P1", "P2", "CH"], ["not_converged", "P4", "P5"]]
    assert [[to_hex(cell) for cell in row] for row in cells] == [
        [to_hex(colour(name)) for name in row] for row in expected
    ]


@pytest.mark.parametrize(
    "name, coordinate, values, label, said",
    [
        ("temperature", "bulk_temperature", [60.0, 100.0], "Bulk temperature, °C", "0.3 × 10⁹ cycles"),
        ("wear", "running_cycles", [0.0, 3e8], "Revolutions of the pinion, 10⁹", "100 °C"),
    ],
)
def test_what_the_rows_show_is_not_said_again(name, coordinate, values, label, said):
    figure = drawn(name, plane(coordinate, values, EXPONENT))
    assert figure.axes[0].get_ylabel() == label
    assert figure.legends[0].get_title().get_text() == f"Case “with”: {said}"


def test_a_map_without_any_exponent_is_drawn():
    drawn("ste", plane("ste", [0.5, 1.0], np.full((2, 3), np.nan)))


def test_what_is_not_decided_is_white_in_the_legend_as_in_the_map():
    patch = drawn("ste", plane("ste", [0.5, 1.0], EXPONENT)).legends[0].get_patches()[-1]
    assert patch.get_hatch() is None and to_hex(patch.get_facecolor()) == colour("not_converged").lower()
    assert patch.get_linewidth() > 0
