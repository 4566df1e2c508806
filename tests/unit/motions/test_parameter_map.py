import numpy as np
import xarray as xr

from gearwear.motions import parameter_map
from gearwear.oscillator.excitation import Excitation
from gearwear.oscillator.periodic import Harmonics

CFG = {
    "dynamics": {
        "damping_ratio": 0.05,
        "tolerance": 1e-10,
        "torque_fluctuation": {"frequency_ratio": 1.0, "amplitudes": [], "phases": []},
        "start": {"at": "pair_entry", "displacement": 1.1, "velocity": 0.0},
    },
    "settling": {
        "transient_periods": 50,
        "longest_transient": 200,
        "sampled_periods": 32,
        "largest_period": 8,
        "recurrence_tolerance": 1e-7,
        "chaos_threshold": 3e-3,
    },
}


def test_an_axis_has_both_its_ends():
    np.testing.assert_allclose(
        parameter_map.values({"first": 0.1, "last": 0.5, "points": 5}), [0.1, 0.2, 0.3, 0.4, 0.5]
    )


def test_a_list_is_taken_as_it_is():
    found = parameter_map.values([20, 55.5, 90])
    assert found.dtype == float and found.tolist() == [20.0, 55.5, 90.0]


def test_a_row_too_long_for_the_memory_is_made_piece_by_piece(monkeypatch):
    waves = Harmonics(0.0, (1.0,), (0.0,))
    source = Excitation(1.0, 1.0, 1.0, 0.1, 0.1, Harmonics(1.0), waves, 0.05, 0.05, 1.0, Harmonics(1.0), 0.5)
    rows, frequencies = np.array([0.5, 1.0]), np.array([0.4, 0.7, 0.75, 0.9, 1.3])

    def made():
        row = [source.oscillator(CFG["dynamics"], one) for one in frequencies]
        return parameter_map.tile("ste", rows, frequencies, [(source, row), (source, row[::-1])], CFG)

    whole = made()
    monkeypatch.setattr("gearwear.motions.sweep._AT_ONCE", 2)
    xr.testing.assert_identical(made(), whole)
    assert whole["motion_class"].shape == (2, 5) and whole["motion_class"].dtype == np.int32
    np.testing.assert_array_equal(whole["force_max"][0], whole["force_max"][1, ::-1])


def test_a_tile_without_rows_has_the_types_of_any_other():
    empty = parameter_map.tile("ste", np.array([]), np.array([0.4, 0.7]), [], CFG)
    assert empty["period"].shape == (0, 2) and empty["period"].dtype == np.int32
