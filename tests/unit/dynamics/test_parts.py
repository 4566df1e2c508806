import numpy as np
import pytest

from gearwear.dynamics.parts import indices


@pytest.mark.parametrize("parts", [1, 2, 3, 7, 20])
def test_every_point_belongs_to_one_part(parts):
    dealt = [indices(11, f"{part}-of-{parts}", "restart") for part in range(1, parts + 1)]
    assert sorted(np.concatenate(dealt)) == list(range(11))


@pytest.mark.parametrize(("order", "first"), [("up", 0), ("down", 10)])
def test_a_carried_sweep_is_one_chain(order, first):
    whole, *others = [indices(11, f"{part}-of-3", order) for part in range(1, 4)]
    assert whole[0] == first and sorted(whole) == list(range(11))
    assert all(len(other) == 0 for other in others)
