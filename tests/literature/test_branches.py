"""Route of an oscillator with a large stiffness fluctuation; its special points are in config/validation.yaml."""

import pytest

from gearwear.codes.branch_codes import PERIOD_DOUBLING
from gearwear.orbits.branches import Seed, explore
from gearwear.orbits.continuation import Limits
from gearwear.orbits.return_map import return_maps
from gearwear.validation.oscillator import oscillator_of


def large_fluctuation(frequency):
    return oscillator_of(frequency, 0.1, 0.1, (-0.4,), (0.1,))


def values(branch, kind):
    return sorted(node.orbit.value for node in branch.nodes if node.special == kind)


def test_every_doubling_leads_to_a_branch_of_twice_the_period():
    seed = Seed(0.9, (0.72997, 0.10476), 1)
    branches = explore(return_maps(large_fluctuation), [seed], Limits(0.85, 1.3), 4)
    assert [branch.period for branch in branches] == [1, 2, 4]
    assert [branch.parent for branch in branches[1:]] == [0, 1]
    assert [len(values(branch, PERIOD_DOUBLING)) for branch in branches] == [1, 1, 1]


@pytest.mark.parametrize("tolerance", [1e-9, 1e-11])
def test_special_points_do_not_hang_on_the_integrator(tolerance):
    """A tolerance a thousand times coarser moves no doubling by 1e-8."""
    seed = Seed(1.0, (0.7, 0.1), 1)
    branch = explore(return_maps(large_fluctuation, tolerance), [seed], Limits(0.9, 1.1), 1)[0]
    assert values(branch, PERIOD_DOUBLING) == pytest.approx([1.032048228], abs=1e-8)
