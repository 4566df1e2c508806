"""Seeds among the points of a sweep."""

import numpy as np

from gearwear.orbits.seeds import seeds


def test_every_periodic_point_gives_a_seed_up_to_the_longest_period():
    classes = [1, 1, 2, 2, 101, 2, 8, 0, 1]
    values = np.linspace(0.1, 0.9, 9)
    section = np.arange(9)[:, None] + np.arange(10) / 10
    found = seeds(values, classes, np.full(9, 400), section, -section, 4)
    expected = [(0.1, 1), (0.2, 1), (0.3, 2), (0.4, 2), (0.6, 2), (0.9, 1)]
    assert [(round(seed.value, 3), seed.period) for seed in found] == expected
    assert found[0].state == (0.9, -0.9)


def test_the_state_is_a_whole_number_of_periods_after_the_start():
    """The last of ten states is 21, 22 and 23 mesh periods after the start."""
    section = np.arange(10.0)[None]
    assert seeds([0.5], [3], [11], section, section, 4)[0].state == (9.0, 9.0)
    assert seeds([0.5], [3], [12], section, section, 4)[0].state == (8.0, 8.0)
    assert seeds([0.5], [3], [13], section, section, 4)[0].state == (7.0, 7.0)


def test_motions_that_do_not_repeat_give_none():
    nothing = np.full((3, 10), np.nan)
    assert seeds([0.1, 0.2, 0.3], [0, 100, 101], [400] * 3, nothing, nothing, 64) == []
