"""Seeds among the points of a sweep, and the branches that they lead to."""

import numpy as np

from gearwear.motions.settling import Settling
from gearwear.motions.sweep import sweep
from gearwear.orbits.continuation import Limits
from gearwear.orbits.seeds import branches_of_sweeps, seeds
from gearwear.oscillator.excitation import Excitation, SweptOscillator
from gearwear.oscillator.periodic import Harmonics


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


def test_the_branch_of_a_sweep_runs_through_its_motions():
    """Linear motion in contact: one orbit at every mesh frequency, its displacement at phase 0 in closed form."""
    dynamics = {
        "damping_ratio": 0.05,
        "tolerance": 1e-10,
        "torque_fluctuation": {"frequency_ratio": 1.0, "amplitudes": [], "phases": []},
        "start": {"at": "pair_entry", "displacement": 1.1, "velocity": 0.0},
    }
    waves, settling = Harmonics(0.0, (1.0,), (0.0,)), Settling(200, 800, 64, 8, 1e-7, 3e-3)
    source = Excitation(1.0, 1.0, 1.0, 0.1, 0.1, Harmonics(1.0), waves, 0.05, 0.05, 1.0, Harmonics(1.0), 0.5)
    swept = SweptOscillator(source, "mesh_frequency", dynamics)
    sweeps = [sweep(swept, np.array([0.4, 0.5, 0.6]), settling, direction) for direction in ("restart", "down")]
    branches = branches_of_sweeps(swept, sweeps, Limits(0.35, 0.65, 0.05), 1)
    assert [branch.period for branch in branches] == [1]
    values = np.array([node.orbit.value for node in branches[0].nodes])
    states = np.array([node.orbit.section[0, 0] for node in branches[0].nodes])
    assert (values[0], values[-1]) == (0.35, 0.65)
    response = 0.05 * values**2 / (1 - values**2 + 2j * 0.05 * values)
    np.testing.assert_allclose(states, 1.1 + response.real, atol=1e-9)
