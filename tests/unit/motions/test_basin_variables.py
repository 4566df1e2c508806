"""Basins as variables."""

import numpy as np
import pytest

from gearwear.io.variables import variable_of
from gearwear.motions.basin_variables import basin_columns, basins_along
from gearwear.motions.basins import UNDECIDED, Basins
from gearwear.motions.settling import Settling, settle
from gearwear.oscillator.excitation import Excitation, SweptOscillator
from gearwear.oscillator.oscillator import Oscillator
from gearwear.oscillator.periodic import Harmonics

SETTLING = Settling(60, 240, 64, 8, 1e-7, 3e-3)


@pytest.fixture(scope="module")
def table():
    oscillator = Oscillator(0.6, 0.1, 0.2, Harmonics(1.0, (0.2,), (0.0,)), Harmonics(0.0, (0.1,), (3.1,)))
    motion = settle(oscillator, (0.0, 0.0), SETTLING)
    found = [
        Basins([motion], np.zeros(1), np.array([0, 0, UNDECIDED, UNDECIDED, 0, 0])),
        Basins([motion, motion._replace(motion_class=101)], np.array([0.0, 0.25]), np.array([0, 1, 1, 1, 1, 0])),
        Basins([], np.zeros(0), np.full(6, UNDECIDED)),
    ]
    return basin_columns(found, (2, 3), 64, 0.2)


def test_every_variable_has_its_entry_in_the_table_of_fields(table):
    for name, (dims, values) in table.items():
        dims = dims if isinstance(dims, tuple) else (dims,)
        field = variable_of(name, dims)
        assert values.ndim == len(dims)
        assert field.may_be_missing or np.isfinite(values).all()


def test_shares_have_their_standard_error(table):
    shares, errors = table["share"][1], table["share_error"][1]
    np.testing.assert_allclose(shares, [[4 / 6, np.nan], [2 / 6, 4 / 6], [np.nan, np.nan]])
    np.testing.assert_allclose(errors[1], np.sqrt(2 / 6 * 4 / 6 / 6))
    assert table["undecided_share"][1].tolist() == [2 / 6, 0.0, 1.0]
    assert table["attractors"][1].tolist() == [1, 2, 0]


def test_attractors_are_padded(table):
    assert table["motion_class"][1].tolist() == [[1, 0], [1, 101], [0, 0]]
    assert table["section_displacement"][1].shape == (3, 2, 64)
    assert np.isnan(table["section_displacement"][1][0, 1]).all()
    assert table["escaped_share"][1][1].tolist() == [0.0, 0.25]


def test_the_map_has_displacement_before_velocity(table):
    assert table["basin"][0] == ("point", "displacement_cell", "velocity_cell")
    assert table["basin"][1][1].tolist() == [[0, 1, 1], [1, 1, 0]]


def test_basins_of_a_linear_motion_are_one_for_all_states_and_values():
    """Small oscillations in contact, whose force is far from zero: every state near rest leads to them."""
    dynamics = {
        "damping_ratio": 0.05,
        "tolerance": 1e-10,
        "torque_fluctuation": {"frequency_ratio": 1.0, "amplitudes": [], "phases": []},
    }
    waves = Harmonics(0.0, (1.0,), (0.0,))
    source = Excitation(1.0, 1.0, 1.0, 0.1, 0.1, Harmonics(1.0), waves, 0.02, 0.02, 1.0, Harmonics(1.0), 0.5)
    swept = SweptOscillator(source, "mesh_frequency", dynamics)
    found = basins_along(swept, np.array([0.3, 0.4]), np.array([1.0, 1.1, 1.2]), np.array([0.0, 0.01]), SETTLING)
    assert found["basin"].dims == ("point", "displacement_cell", "velocity_cell")
    assert found["basin"].shape == (2, 3, 2) and (found["basin"] == 0).all()
    assert found["share"].values.tolist() == [[1.0], [1.0]]
    assert found["initial_velocity"].values.tolist() == [0.0, 0.01]
    assert found["mesh_frequency"].values.tolist() == [0.3, 0.4]
