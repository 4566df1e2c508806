"""The gear pair on bearings against independent integrations, closed forms and the torsional oscillator."""

import dataclasses

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import eigh

from gearwear.integrate.status import BLOW_UP
from gearwear.integrate.strobe import monodromy, strobe, visited
from gearwear.integrate.strobe_many import strobe_many
from gearwear.oscillator.oscillator import ExternalTorque, Oscillator
from gearwear.oscillator.periodic import Harmonics, PeriodicTable
from gearwear.oscillator.translational import PINION_ACROSS, Bearing, TranslationalOscillator

PINION, GEAR, ANGLE = Bearing(2.5, (0.5, 0.3), 0.03), Bearing(8.0, (0.4, 0.9), 0.05), 0.37
MESH = {
    "damping_ratio": 0.07,
    "mean_force": 0.1,
    "stiffness": Harmonics(1.0, (0.3,), (0.4,)),
    "error": Harmonics(0.0, (0.2, 0.05), (0.1, 0.8)),
}
LOADED = MESH | {"mean_force": 2.0}
TWO_SIDED = MESH | {
    "damping_ratio": 0.03,
    "mean_force": 0.02,
    "error": Harmonics(0.0, (0.5,), (0.1,)),
    "clearance": Harmonics(0.2, (0.02,), (0.3,)),
    "torque": ExternalTorque(0.618, (0.05, 0.03), (0.4, 1.1)),
}


def on_bearings(mesh, frequency=0.9, pinion=PINION, gear=GEAR):
    return TranslationalOscillator(frequency, **mesh, pinion=pinion, gear=gear, pressure_angle=ANGLE)


def on_springs(factor, ratio=0.05):
    bearings = [Bearing(mass, (factor, factor), ratio) for mass in (3.0, 9.0)]
    return on_bearings(MESH, 0.8, *bearings)


class Equations:
    """The pair as printed: turn of the mesh u, and both centres towards one another and across."""

    def __init__(self, oscillator):
        self.oscillator, w = oscillator, oscillator.frequency
        self.line = np.array([np.sin(ANGLE), np.cos(ANGLE)])
        self.across = np.array([np.cos(ANGLE), -np.sin(ANGLE)])
        order = np.arange(1, len(oscillator.error.amplitudes) + 1)
        amplitudes, phases = map(np.array, (oscillator.error.amplitudes, oscillator.error.phases))
        self.error = lambda t, d: np.sum(amplitudes * (order * w) ** d * np.cos(order * w * t + phases + d * np.pi / 2))

    def mesh(self, t, y):
        approach, rate = y[2:4] - y[6:8], y[4:6] - y[8:10]
        return y[0] + self.line @ approach - self.error(t, 0), y[1] + self.line @ rate - self.error(t, 1)

    def gap(self, side):
        def of(t, y):
            return self.mesh(t, y)[0] - side * self.oscillator.clearance.at(t / self.oscillator.period)

        of.terminal = True
        return of

    def rates(self, t, y):
        one, phase = self.oscillator, t / self.oscillator.period
        x, v = self.mesh(t, y)
        b = one.clearance.at(phase)
        force = one.stiffness.at(phase) * (x - np.clip(x, -b, b)) + 2 * one.damping_ratio * v
        order = np.arange(1, len(one.torque.amplitudes) + 1)
        torque = np.sum(
            one.torque.amplitudes * np.cos(order * one.torque.frequency_ratio * one.frequency * t + one.torque.phases)
        )
        parts = [[y[1], one.mean_force + torque - force]]
        for bearing, place, sign in ((one.pinion, 2, -1), (one.gear, 6, 1)):
            spring = np.array(bearing.stiffness)
            damper = 2 * bearing.damping_ratio * np.sqrt(bearing.mass * spring)
            load = sign * force * self.line - spring * y[place : place + 2] - damper * y[place + 2 : place + 4]
            parts += [y[place + 2 : place + 4], load / bearing.mass]
        return np.concatenate(parts)

    def states(self, state, times):
        """States as the oscillator has them, by DOP853 with an event at every corner, and the corners met."""
        y, t, found, corners = np.zeros(10), 0.0, [], [0, 0]
        y[:2] = state[0] + self.error(0.0, 0), state[1] + self.error(0.0, 1)
        settings = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-13}
        for end in times:
            while t < end:
                # off the corner on which the last part ended, before events are looked for again
                t_off = min(t + 1e-6, end)
                y = solve_ivp(self.rates, (t, t_off), y, **settings).y[:, -1]
                run = solve_ivp(
                    self.rates, (t_off, end), y, events=[self.gap(1), self.gap(-1)], max_step=0.1, **settings
                )
                corners = [count + len(hits) for count, hits in zip(corners, run.t_events, strict=True)]
                t, y = run.t[-1], run.y[:, -1]
            pairs = [self.mesh(t, y)]
            for place in (2, 6):
                pairs += [
                    (row @ y[place : place + 2], row @ y[place + 2 : place + 4]) for row in (self.line, self.across)
                ]
            found.append(np.concatenate(pairs))
        return np.array(found), corners


@pytest.mark.parametrize(
    ("mesh", "start", "met"),
    [(LOADED, (3.0, 0.0), (0, 0)), (MESH, (0.0, 0.0), (1, 0)), (TWO_SIDED, (0.0, 0.0), (1, 1))],
)
def test_agrees_with_an_independent_integration(mesh, start, met):
    """Without loss of contact, with impacts on one flank, and on both with an external torque."""
    oscillator, phases = on_bearings(mesh), np.array([0.4, 1.0])
    states = visited(oscillator, start, phases, 3).reshape(-1, 10)
    expected, corners = Equations(oscillator).states(start, oscillator.period * np.add.outer(range(3), phases).ravel())
    np.testing.assert_allclose(states, expected, rtol=0, atol=1e-9)
    assert [bool(count) for count in corners] == [bool(count) for count in met]
    motion = strobe(oscillator, start, 3)
    assert motion.impacts.sum() <= sum(corners) <= 2 * motion.impacts.sum() + 1
    np.testing.assert_allclose(motion.states[-1], states[-1], rtol=0, atol=1e-12)


def test_natural_frequencies_are_those_of_six_degrees_of_freedom():
    """Masses and radii in SI units, (x, y, theta) of either gear in the axes of the line of centres."""
    mass, inertia, radius = np.array([1.3, 6.0]), np.array([1.1e-3, 2.9e-2]), np.array([0.03, 0.075])
    spring, mesh_stiffness = np.array([[2e8, 5e8], [3e8, 9e8]]), 4e8
    equivalent = 1 / np.sum(radius**2 / inertia)
    line = np.array([np.sin(ANGLE), np.cos(ANGLE)])
    along = np.concatenate([line, radius[:1], -line, -radius[1:]])
    stiffness = np.diag([*spring[0], 0.0, *spring[1], 0.0]) + mesh_stiffness * np.outer(along, along)
    masses = np.diag([mass[0], mass[0], inertia[0], mass[1], mass[1], inertia[1]])
    squares = eigh(stiffness, masses, eigvals_only=True)
    pinion, gear = (Bearing(m / equivalent, tuple(k / mesh_stiffness), 0.0) for m, k in zip(mass, spring, strict=True))
    linear = on_bearings(MESH, pinion=pinion, gear=gear).linear_part
    own = np.linalg.eigvals(linear.stiffness + np.outer(linear.pull, np.eye(5)[0]))
    assert abs(squares[0]) < 1e-9 * squares[-1]  # the pair turns freely
    np.testing.assert_allclose(np.sort(own.real) * mesh_stiffness / equivalent, squares[1:], rtol=1e-10)
    assert not own.imag.any()


def test_stiff_bearings_lead_to_the_torsional_oscillator():
    single = strobe(Oscillator(0.8, **MESH), (0.0, 0.0), 150).states[-1]
    departures = [
        np.abs(strobe(on_springs(factor), (0.0, 0.0), 150, detail=0).states[-1, :2] - single).max()
        for factor in (1e3, 1e4)
    ]
    assert departures[0] < 3e-3
    assert np.log10(departures[0] / departures[1]) == pytest.approx(1.0, abs=0.03)


def test_determinant_of_every_period_is_the_contraction():
    oscillator = on_bearings(TWO_SIDED)
    maps = strobe(oscillator, (0.0, 0.0), 40).tangent_maps
    damping = oscillator.linear_part.damping
    bearings = sum(
        4 * one.damping_ratio * np.sqrt(np.array(one.stiffness) / one.mass).sum() / 2 for one in (PINION, GEAR)
    )
    assert np.trace(damping) == pytest.approx(2 * 0.03 * (1 + 1 / 2.5 + 1 / 8.0) + bearings, rel=1e-12)
    np.testing.assert_allclose(np.linalg.det(maps), np.exp(-np.trace(damping) * oscillator.period), rtol=1e-11)


def test_tangent_map_is_the_derivative_of_the_period_map():
    oscillator, state = on_bearings(MESH), np.linspace(0.4, -0.2, 10)
    motion, (_, matrix) = strobe(oscillator, state, 2), monodromy(oscillator, state, 2)
    for column, shift in enumerate(1e-5 * np.eye(10)):
        ahead, behind = (strobe(oscillator, state + sign * shift, 2, detail=0).states[-1] for sign in (1, -1))
        np.testing.assert_allclose((ahead - behind) / 2e-5, matrix[:, column], atol=1e-7)
    assert motion.growth.sum() == pytest.approx(np.log(np.linalg.norm(matrix[:, 0])), abs=1e-12)
    np.testing.assert_allclose(strobe(oscillator, state, 2, detail=1).growth, motion.growth, atol=1e-12)


def test_motion_across_the_line_of_action_needs_bearings_of_unlike_stiffness():
    alike = strobe(on_springs(0.4), (0.0, 0.0), 30, detail=0).states
    unlike = strobe(on_bearings(MESH), (0.0, 0.0), 30, detail=0).states
    across = slice(2 * PINION_ACROSS, 2 * PINION_ACROSS + 2)
    assert np.abs(alike[:, across]).max() < 1e-15
    assert np.abs(unlike[-10:, across]).max() > 0.01


def test_bearings_carry_the_mean_force():
    """Static: constant stiffness, no error; the gears part by F over the bearing stiffness on the line of action."""
    still = {"damping_ratio": 0.2, "mean_force": 0.3}
    bearings = Bearing(2.0, (0.5, 0.5), 0.3), Bearing(5.0, (0.8, 0.8), 0.3)
    rest = strobe(on_bearings(still, 0.5, *bearings), (0.0, 0.0), 40, detail=0).states[-1]
    np.testing.assert_allclose(rest[[0, 2, 6]], [1.3, -0.3 / 0.5, 0.3 / 0.8], atol=1e-9)


def test_jump_of_the_error_is_the_limit_of_a_steep_ramp():
    jumping = PeriodicTable((0.0, 0.4, 1.0), (0.0, 0.15), (0.05, 0.0))
    reference = strobe(on_bearings(MESH | {"error": jumping}), (0.3, 0.1), 2, detail=0).states[2]
    departures = []
    for width in (1e-3, 1e-4):
        ramp = PeriodicTable((0.0, 0.4, 0.4 + width, 1.0), (0.0, 0.05, 0.15), (0.05, 0.15, 0.0))
        motion = strobe(on_bearings(MESH | {"error": ramp}), (0.3, 0.1), 2, detail=0)
        departures.append(np.abs(motion.states[2] - reference).max())
    assert departures[1] < 0.15 * departures[0] < 5e-4


def test_period_map_does_not_depend_on_how_many_periods_a_call_runs():
    oscillator = on_bearings(TWO_SIDED)
    whole, first = strobe(oscillator, (0.0, 0.0), 20), strobe(oscillator, (0.0, 0.0), 8)
    rest = strobe(oscillator, first.states[-1], 12, first_period=8, tangent=first.tangent)
    np.testing.assert_array_equal(whole.states[8:], rest.states)
    np.testing.assert_array_equal(whole.tangent, rest.tangent)
    for name in ("growth", "lost", "impacts", "force_max", "displacement_min", "displacement_max", "tangent_maps"):
        np.testing.assert_array_equal(getattr(whole, name)[8:], getattr(rest, name))


def test_many_motions_are_those_alone():
    oscillators = [on_bearings(MESH, frequency) for frequency in (0.7, 1.1)]
    many = strobe_many(oscillators, (0.2, 0.0), 5)
    for oscillator, states, force in zip(oscillators, many.states, many.force_max, strict=True):
        alone = strobe(oscillator, (0.2, 0.0), 5)
        np.testing.assert_array_equal(states, alone.states)
        np.testing.assert_array_equal(force, alone.force_max)


def test_extremes_and_contact_loss_are_those_of_a_dense_trace():
    oscillator = on_bearings(MESH)
    motion = strobe(oscillator, (0.0, 0.0), 3)
    phases = np.linspace(0, 1, 4001)  # both ends: the extreme of a period may be there
    x = visited(oscillator, (0.0, 0.0), phases, 3)[:, :, 0]
    force = oscillator.stiffness.at(phases) * (x - np.clip(x, -1, 1))
    np.testing.assert_allclose(motion.displacement_max, x.max(axis=1), atol=1e-5)
    np.testing.assert_allclose(motion.displacement_min, x.min(axis=1), atol=1e-5)
    np.testing.assert_allclose(motion.force_max, np.abs(force).max(axis=1), atol=1e-5)
    np.testing.assert_allclose(motion.lost, (np.abs(x) < 1).mean(axis=1), atol=1e-3)


def test_blow_up_is_a_status():
    driven = dataclasses.replace(on_bearings(MESH), error=Harmonics(0.0, (3e6,), (0.0,)))
    motion = strobe(driven, (0.0, 0.0), 3)
    assert motion.status == BLOW_UP and np.isnan(motion.states[-1]).all()


@pytest.mark.parametrize(
    "wrong", [{"mass": 0.0}, {"stiffness": (1.0, -1.0)}, {"stiffness": (1.0,)}, {"damping_ratio": -0.1}]
)
def test_impossible_bearings_are_refused(wrong):
    with pytest.raises(ValueError, match="bearing: mass"):
        dataclasses.replace(PINION, **wrong)


def test_a_state_has_two_or_ten_numbers():
    with pytest.raises(ValueError, match="state: must be two or 10 finite numbers"):
        strobe(on_bearings(MESH), np.zeros(4), 1)
