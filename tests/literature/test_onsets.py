"""The route to chaos of the oscillator with a large stiffness fluctuation, as onsets along sweeps.

Doublings and fold as in test_branches. Chaos begins behind the limit of the cascade: the doublings of periods 8 and 16
lie at 1.2777931 and 1.2810147, which with the ratio 4.669 of Feigenbaum (1978) gives 1.2818928.
"""

import numpy as np
import pytest
import xarray as xr

from gearwear.codes.onset_codes import GENERAL, GENERAL_HALVED, MET, ORDERS, OTHER_START, PASSED_BY, VARIANTS
from gearwear.motions.settling import Settling
from gearwear.motions.sweep import sweep
from gearwear.onsets import route
from gearwear.orbits.branch_variables import columns as branch_columns
from gearwear.orbits.branches import Seed, explore
from gearwear.orbits.continuation import Limits
from gearwear.orbits.newton import minimal_period, periodic_orbit
from gearwear.orbits.return_map import return_maps
from gearwear.oscillator.excitation import Excitation
from gearwear.oscillator.periodic import Harmonics

SETTLING = Settling(200, 3200, 160, 16, 1e-7, 3e-3)
DYNAMICS = {
    "damping_ratio": 0.1,
    "tolerance": 1e-10,
    "torque_fluctuation": {"frequency_ratio": 1.0, "amplitudes": [], "phases": []},
    "start": {"at": "stiffest_mesh", "displacement": 0.0, "velocity": 0.0},
}
DOUBLINGS = (1.0320482, 1.1833306, 1.2633173)
LIMIT, FOLD = 1.2818928, 1.0018708
STEP = 0.005
CAUGHT = 1.29  # a stable orbit of period 12 lives beside chaos there


def behind_the_cascade(value):
    """Whether chaos begins at the limit or, round-off having led a motion to period 12, in the step above that."""
    return abs(value - LIMIT) < 2e-3 or CAUGHT < value <= CAUGHT + STEP


@pytest.fixture(scope="module")
def state():
    error, stiffness = Harmonics(0.0, (1.0,), (0.0,)), Harmonics(1.0, (-0.4,), (0.0,))
    source = Excitation(1.0, 1.0, 1.0, 0.1, 0.1, stiffness, error, 0.1, 0.1, 1.0, Harmonics(1.0), 0.5)
    maps = return_maps(lambda value: source.oscillator(DYNAMICS, value))
    branches = explore(maps, [Seed(1.0, (0.72997, 0.10476), 1)], Limits(0.95, 1.35), 4)
    table = xr.Dataset(branch_columns(branches, 4, "mesh_frequency")).set_coords("mesh_frequency")
    return route.State(source, DYNAMICS, SETTLING, table)


@pytest.fixture(scope="module")
def sweeps(state):
    values = np.arange(0.98, 1.33, STEP)
    return {order: sweep(state.swept, values, SETTLING, order) for order in ORDERS}


@pytest.fixture(scope="module")
def ways(state, sweeps):
    found = {order: route.along(state, sweeps[order], order, 10) for order in ORDERS}
    return found | route.varied(state, sweeps["restart"], found["restart"], 10)


@pytest.mark.parametrize("order", ["restart", "up"])
def test_a_sweep_goes_through_the_doublings(ways, order):
    doublings = ways[order][:3]
    assert [one.how for one in doublings] == [MET] * 3
    assert [one.value for one in doublings] == pytest.approx(DOUBLINGS, abs=1e-6)


def test_downwards_period_2_lasts_to_its_fold_and_passes_the_first_doubling_by(ways):
    first, *others = ways["down"][:3]
    assert (first.how, first.value) == (PASSED_BY, pytest.approx(DOUBLINGS[0], abs=1e-6))
    assert abs(first.seen - FOLD) < STEP / 2
    assert [one.value for one in others] == pytest.approx(DOUBLINGS[1:], abs=1e-6)


def test_a_stable_orbit_lives_beside_chaos(state):
    maps = return_maps(lambda value: state.source.oscillator(DYNAMICS, value))
    orbit = periodic_orbit(maps, CAUGHT, (0.346412, -0.124278), 12).orbit
    assert minimal_period(orbit) == 12 and orbit.stable


@pytest.mark.parametrize("order", ORDERS)
def test_chaos_begins_behind_the_limit_of_the_cascade(ways, order):
    chaos = ways[order][3]
    assert chaos.how == MET and chaos.resolution == pytest.approx(STEP / 10)
    assert chaos.value > LIMIT and behind_the_cascade(chaos.value)


def test_the_same_events_come_out_in_every_other_way(ways):
    assert set(ways) == set(VARIANTS)
    for name, events in ways.items():
        places = [one.seen for one in events]
        assert places[1:3] == pytest.approx(DOUBLINGS[1:], abs=1e-6)
        assert name in ("down", OTHER_START) or places[0] == pytest.approx(DOUBLINGS[0], abs=1e-6)
        assert behind_the_cascade(places[3])


def test_another_integrator_moves_the_doublings_by_its_tolerance_only(ways):
    for one, other, usual in zip(ways[GENERAL], ways[GENERAL_HALVED], ways["restart"], strict=True):
        if usual is ways["restart"][3]:
            continue
        assert 0 < abs(one.seen - usual.seen) < 1e-7
        assert one.seen != other.seen


def test_other_start_is_the_other_one(state, sweeps, monkeypatch):
    starts = []

    def record(state, values, tolerance=None, backend="automatic"):
        at, sampled = state.dynamics["start"]["at"], state.settling.sampled_periods
        starts.append((at, sampled, len(values), tolerance, backend))
        return np.ones(len(values), dtype=int)

    monkeypatch.setattr(route, "classes_from_rest", record)
    events = route.along(state, sweeps["up"], "up", 1)
    found = route.varied(state, sweeps["restart"], events, 1)
    points = sweeps["restart"].sizes["point"]
    assert starts == [
        ("pair_entry", 160, points, None, "automatic"),
        ("stiffest_mesh", 320, points, None, "automatic"),
        ("stiffest_mesh", 160, 2 * points - 1, None, "automatic"),
        ("stiffest_mesh", 160, points, 1e-10, "general"),
        ("stiffest_mesh", 160, points, 5e-11, "general"),
    ]
    assert list(found)[0] == OTHER_START
