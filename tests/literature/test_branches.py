"""Folds and period doublings of two oscillators, through continuation.

The numbers were computed beforehand with independent codes; the sets are those of test_kahraman_singh. Where they
differ from ours in the sixth digit, an eighth-order integrator with events (Dormand and Prince's 8(5,3) of scipy)
decides.
"""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from gearwear.orbits.branches import Seed, explore
from gearwear.orbits.codes import FOLD, PERIOD_DOUBLING
from gearwear.orbits.continuation import Limits
from gearwear.orbits.return_map import return_maps
from gearwear.validation.oscillator import oscillator_of


def set_of_1991(frequency):
    return oscillator_of(frequency, 0.05, 0.1, (-0.2, -0.1, -0.05), (0.01, 0.004, 0.002))


def large_fluctuation(frequency):
    return oscillator_of(frequency, 0.1, 0.1, (-0.4,), (0.1,))


def values(branch, kind):
    return sorted(node.orbit.value for node in branch.nodes if node.special == kind)


def passage(oscillator, state, periods):
    """State after some periods and its derivative by the state before them, by DOP853 with the corners as events."""
    w, friction = oscillator.frequency, 2 * oscillator.damping_ratio
    orders = np.arange(1, len(oscillator.error.amplitudes) + 1)
    drive = oscillator.error.amplitudes * (orders * w) ** 2

    def rates(t, y, side):
        stiffness = oscillator.stiffness.at(w * t / (2 * np.pi)) if side else 0.0
        force = oscillator.mean_force + np.sum(drive * np.cos(orders * w * t))
        x, v, tangent = y[0] - side, y[1], y[2:].reshape(2, 2)
        turned = np.array([tangent[1], -friction * tangent[1] - stiffness * tangent[0]])
        return [v, force - friction * v - stiffness * x, *turned.ravel()]

    def corner(at, direction):
        def margin(t, y, side):
            return y[0] - at

        margin.terminal, margin.direction = True, direction
        return margin

    t, y, end = 0.0, np.array([*state, 1.0, 0.0, 0.0, 1.0]), periods * oscillator.period
    side = float(np.sign(y[0]) * (abs(y[0]) > 1))
    accuracy = {"rtol": 1e-12, "atol": 1e-13, "max_step": 0.3}
    while t < end:
        exits = [corner(side, -side)] if side else [corner(1.0, 1.0), corner(-1.0, -1.0)]
        piece = solve_ivp(rates, (t, end), y, "DOP853", events=exits, args=(side,), **accuracy)
        t, y = piece.t[-1], piece.y[:, -1]
        if piece.status == 1:
            side = 0.0 if side else float(np.sign(y[0]))
            y[0] = round(y[0])
    return y[:2], y[2:].reshape(2, 2)


def assert_confirmed(oscillator_at, branches):
    """Every fold and doubling is one by the other integrator: the orbit closes, with a multiplier of 1 or -1."""
    for branch in branches:
        for orbit, special in ((node.orbit, node.special) for node in branch.nodes if node.special):
            after, matrix = passage(oscillator_at(orbit.value), orbit.section[0], branch.period)
            assert after == pytest.approx(orbit.section[0], abs=1e-9)
            assert np.linalg.det(matrix - np.eye(2) * (1 if special == FOLD else -1)) == pytest.approx(0.0, abs=1e-7)


def test_folds_of_the_set_of_1991():
    """All four folds of period 1 to 1e-5; our own to 1e-7."""
    branch, *others = explore(return_maps(set_of_1991, 1e-12), [Seed(0.5, (1.0, 0.1), 1)], Limits(0.3, 1.2), 2)
    assert not others
    assert values(branch, FOLD) == pytest.approx([0.437007, 0.455324, 0.598153, 0.835839], abs=1e-5)
    assert values(branch, FOLD) == pytest.approx([0.4370071, 0.4553241, 0.5981531, 0.8358377], abs=1e-7)
    assert not values(branch, PERIOD_DOUBLING)
    assert_confirmed(set_of_1991, [branch])


def test_cascade_of_the_large_fluctuation():
    """Folds and the first three doublings to 1e-5, which needs a switch of branch at each of them."""
    seed = Seed(0.9, (0.72997, 0.10476), 1)
    branches = explore(return_maps(large_fluctuation, 1e-12), [seed], Limits(0.4, 1.3), 4)
    assert [branch.period for branch in branches] == [1, 2, 4]
    assert values(branches[0], FOLD) == pytest.approx([0.577217, 0.620486], abs=1e-5)
    doublings = [values(branch, PERIOD_DOUBLING) for branch in branches]
    assert doublings == [pytest.approx([v], abs=1e-5) for v in (1.032053, 1.183335, 1.263317)]
    assert doublings == [pytest.approx([v], abs=1e-7) for v in (1.0320482, 1.1833306, 1.2633173)]
    assert_confirmed(large_fluctuation, branches)


@pytest.mark.parametrize("tolerance", [1e-9, 1e-11])
def test_special_points_do_not_hang_on_the_integrator(tolerance):
    """A tolerance a thousand times coarser moves no doubling by 1e-8."""
    seed = Seed(1.0, (0.7, 0.1), 1)
    branch = explore(return_maps(large_fluctuation, tolerance), [seed], Limits(0.9, 1.1), 1)[0]
    assert values(branch, PERIOD_DOUBLING) == pytest.approx([1.032048228], abs=1e-8)
