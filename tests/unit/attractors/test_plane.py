import numpy as np

from gearwear.attractors.plane import values


def test_an_axis_has_both_its_ends():
    np.testing.assert_allclose(values({"first": 0.1, "last": 0.5, "points": 5}), [0.1, 0.2, 0.3, 0.4, 0.5])


def test_a_list_is_taken_as_it_is():
    found = values([20, 55.5, 90])
    assert found.dtype == float and found.tolist() == [20.0, 55.5, 90.0]
