"""How points are dealt to the parts of a sweep."""

import numpy as np
import pytest

from gearwear.stages.parts import indices


@pytest.mark.parametrize("parts", [1, 2, 3, 7, 20])
def test_every_point_belongs_to_one_part(parts):
    dealt = [indices(11, f"{part}-of-{parts}") for part in range(1, parts + 1)]
    assert sorted(np.concatenate(dealt)) == list(range(11))
    assert max(map(len, dealt)) - min(map(len, dealt)) <= 1


def test_neighbours_go_to_different_parts():
    assert indices(11, "2-of-4").tolist() == [1, 5, 9]
