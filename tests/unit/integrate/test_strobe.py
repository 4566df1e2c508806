"""The integrator against closed forms and independent integrations."""

import dataclasses
import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm

from gearwear.integrate.dormand_prince import period_flow
from gearwear.integrate.status import BLOW_UP, COMPLETED, TOO_MANY_STEPS
from gearwear.integrate.strobe import monodromy, strobe, trace
from gearwear.oscillator.oscillator import ExternalTorque, Oscillator
from gearwear.oscillator.periodic import Harmonics, PeriodicTable

CHAOTIC = Oscillator(1.4, 0.1, 0.1, Harmonics(1.0, (-0.4,), (0.0,)), Harmonics(0.0, (0.1,), (0.0,)))
WIDE = Harmonics(100.0)
TORQUE = ExternalTorque(0.618, (0.05, 0.03), (0.4, 1.1))


def free_flight(t, x, v, damping_ratio, force):
    c = 2 * damping_ratio
    drift = force / c
    return x + drift * t + (v - drift) * -np.expm1(-c * t) / c, drift + (v - drift) * np.exp(-c * t)


def independent(oscillator, state, phases):
    """States at mesh phases (increasing, in periods) by scipy's DOP853 on the equation as printed."""
    w = oscillator.frequency
    error = oscillator.error
    orders = np.arange(1, len(error.amplitudes) + 1)
    torque = oscillator.torque

    def rates(t, y):
        phase = w * t / (2 * np.pi)
        b = oscillator.clearance.at(phase)
        f = y[0] - np.clip(y[0], -b, b)
        force = oscillator.mean_force + np.sum(
            error.amplitudes * (orders * w) ** 2 * np.cos(orders * w * t + error.phases)
        )
        turns = np.arange(1, len(torque.amplitudes) + 1)
        force += np.sum(torque.amplitudes * np.cos(turns * torque.frequency_ratio * w * t + torque.phases))
        return y[1], force - 2 * oscillator.damping_ratio * y[1] - oscillator.stiffness.at(phase) * f

    times = np.asarray(phases) * oscillator.period
    solution = solve_ivp(rates, (0, times[-1]), state, "DOP853", t_eval=times, rtol=1e-12, atol=1e-13, max_step=0.05)
    return solution.y.T


def test_free_flight():
    oscillator = Oscillator(0.3, 0.05, 0.1, clearance=WIDE)
    phases = np.linspace(0, 1, 7)
    x, v = trace(oscillator, (0.2, -0.4), phases, 2)
    t = oscillator.period * (phases + np.array([[0.0], [1.0]]))
    exact_x, exact_v = free_flight(t, 0.2, -0.4, 0.05, 0.1)
    np.testing.assert_allclose(x, exact_x, rtol=1e-9)
    np.testing.assert_allclose(v, exact_v, rtol=1e-9)
    motion = strobe(oscillator, (0.2, -0.4), 2)
    np.testing.assert_allclose(motion.lost, 1.0, rtol=1e-12)
    assert not motion.impacts.any() and not motion.force_max.any()


def test_linear_oscillator_in_contact():
    w, z, amplitude, phase, force = 0.8, 0.05, 0.3, 0.7, 5.0
    oscillator = Oscillator(w, z, force, Harmonics(1.0), Harmonics(0.0, (amplitude,), (phase,)))
    steady = amplitude * w**2 / (1 - w**2 + 2j * z * w) * np.exp(1j * phase)
    start = (1 + force + steady.real, (1j * w * steady).real)
    phases = np.linspace(0, 1, 9)
    x, v = trace(oscillator, start, phases, 3)
    turning = steady * np.exp(2j * np.pi * phases)
    np.testing.assert_allclose(x, np.tile(1 + force + turning.real, (3, 1)), atol=2e-8)
    np.testing.assert_allclose(v, np.tile((1j * w * turning).real, (3, 1)), atol=2e-8)
    motion = strobe(oscillator, start, 3)
    np.testing.assert_allclose(motion.displacement_max, 1 + force + abs(steady), atol=2e-8)
    np.testing.assert_allclose(motion.displacement_min, 1 + force - abs(steady), atol=2e-8)
    np.testing.assert_allclose(motion.force_max, force + abs(steady), atol=1e-6)
    assert not motion.lost.any()


def test_monodromy_of_the_linear_oscillator():
    oscillator = Oscillator(0.8, 0.05, 5.0)
    _, matrix = monodromy(oscillator, (6.0, 0.0), 3)
    exact = expm(3 * oscillator.period * np.array([[0.0, 1.0], [-1.0, -0.1]]))
    np.testing.assert_allclose(matrix, exact, atol=1e-7)


@pytest.mark.parametrize("seed", range(12))
def test_agrees_with_an_independent_integration(seed):
    random = np.random.default_rng(seed)
    count = seed % 3 + 1
    mean_clearance = (1.0, 0.1, 0.01)[seed % 3]
    oscillator = Oscillator(
        random.uniform(0.3, 1.7),
        random.uniform(0.03, 0.1),
        random.uniform(-0.1, 0.3),
        Harmonics(1.0, random.uniform(0, 0.25, count), random.uniform(0, 6, count)),
        Harmonics(0.0, random.uniform(0, 0.3, count), random.uniform(0, 6, count)),
        Harmonics(mean_clearance, mean_clearance * random.uniform(0, 0.2, seed % 2), random.uniform(0, 6, seed % 2)),
        TORQUE if seed % 4 == 0 else ExternalTorque(),
    )
    start = random.uniform(-1, 1, 2)
    phases = np.array([0.25, 0.5, 0.8, 1.0])
    x, v = trace(oscillator, start, phases, 2)
    expected = independent(oscillator, start, np.concatenate([phases, 1 + phases]))
    np.testing.assert_allclose(np.column_stack([x.ravel(), v.ravel()]), expected, atol=5e-8)


def test_trace_and_strobe_agree():
    x, v = trace(CHAOTIC, (0.3, 0.1), [0.0, 0.4, 1.0], 4)
    states = strobe(CHAOTIC, (0.3, 0.1), 4).states
    np.testing.assert_allclose(np.column_stack([x[:, 0], v[:, 0]]), states[:-1], atol=1e-8)
    np.testing.assert_array_equal(x[1:, 0], x[:-1, 2])


@pytest.mark.parametrize("depth", [1e-3, 1e-5, 1e-7, 1e-8])
def test_grazing_contacts_are_neither_missed_nor_invented(depth):
    """A free flight that turns at b + depth or at b - depth, wherever the turn lies in its steps."""
    z, force = 0.05, -0.2
    drift, c = force / (2 * z), 2 * z
    for duration in np.linspace(0.3, 3.5, 80):
        v = drift - drift * math.exp(c * duration)
        rise = free_flight(duration, 0.0, v, z, force)[0]
        oscillator = Oscillator(2 * np.pi / (1.3 * duration), z, force)
        touching = strobe(oscillator, (1.0 + depth - rise, v), 1)
        missing = strobe(oscillator, (1.0 - depth - rise, v), 1)
        assert touching.impacts[0] == 1
        assert touching.lost[0] < 1 and touching.force_max[0] > 0.9 * depth
        assert missing.impacts[0] == 0 and missing.lost[0] == pytest.approx(1.0, abs=1e-14)
        assert missing.displacement_max[0] - 1.0 == pytest.approx(-depth, abs=2e-9)


def test_contact_left_from_the_corner_returns_by_the_closed_form():
    """No force: half a damped oscillation in contact, then free flight to the other corner and on."""
    z, v = 0.05, 0.6
    rate = math.sqrt(1 - z * z)
    oscillator = Oscillator(2 * np.pi / 10.0, z, 0.0)
    half, leaving = math.pi / rate, -v * math.exp(-z * math.pi / rate)
    flight = -math.log1p(2 * 2 * z / leaving) / (2 * z)
    arriving = leaving * math.exp(-2 * z * flight)
    rest = 10.0 - half - flight
    decay = math.exp(-z * rest)
    expected = (
        -1 + arriving / rate * decay * math.sin(rate * rest),
        arriving * decay * (math.cos(rate * rest) - z / rate * math.sin(rate * rest)),
    )
    motion = strobe(oscillator, (1.0, v), 1)
    np.testing.assert_allclose(motion.states[1], expected, atol=5e-9)
    assert motion.lost[0] == pytest.approx(flight / 10.0, abs=1e-9)
    assert motion.impacts[0] == 1


def test_determinant_of_every_period_is_the_contraction():
    for oscillator in (CHAOTIC, dataclasses.replace(CHAOTIC, torque=TORQUE)):
        maps = strobe(oscillator, (0.0, 0.0), 200).tangent_maps
        contraction = math.exp(-2 * oscillator.damping_ratio * oscillator.period)
        np.testing.assert_allclose(np.linalg.det(maps), contraction, rtol=1e-7)


def test_tangent_map_is_the_derivative_of_the_period_map():
    motion = strobe(CHAOTIC, (0.3, 0.1), 3, tolerance=1e-12)
    _, matrix = monodromy(CHAOTIC, (0.3, 0.1), 3, tolerance=1e-12)
    d = 1e-5
    for column, shift in enumerate(np.eye(2) * d):
        ahead = strobe(CHAOTIC, (0.3, 0.1) + shift, 3, tolerance=1e-12).states[-1]
        behind = strobe(CHAOTIC, (0.3, 0.1) - shift, 3, tolerance=1e-12).states[-1]
        np.testing.assert_allclose((ahead - behind) / (2 * d), matrix[:, column], rtol=2e-4, atol=2e-4)
    assert motion.growth.sum() == pytest.approx(math.log(np.hypot(*matrix[:, 0])), abs=1e-12)


def test_exponents_sum_to_the_contraction():
    motion = strobe(CHAOTIC, (0.0, 0.0), 400)
    frame, second, first = np.eye(2), 0.0, 0.0
    for tangent_map in motion.tangent_maps:
        frame, triangle = np.linalg.qr(tangent_map @ frame)
        first += math.log(abs(triangle[0, 0]))
        second += math.log(abs(triangle[1, 1]))
    duration = 400 * CHAOTIC.period
    assert motion.growth.sum() / duration == pytest.approx(first / duration, abs=1e-9)
    assert (first + second) / duration == pytest.approx(-2 * CHAOTIC.damping_ratio, abs=1e-8)
    assert first / duration > 0.03


def test_period_map_does_not_depend_on_how_many_periods_a_call_runs():
    oscillator = dataclasses.replace(CHAOTIC, torque=TORQUE)
    whole = strobe(oscillator, (0.0, 0.0), 60)
    first = strobe(oscillator, (0.0, 0.0), 25)
    rest = strobe(oscillator, first.states[-1], 35, first_period=25, tangent=first.tangent)
    np.testing.assert_array_equal(whole.states[25:], rest.states)
    np.testing.assert_array_equal(whole.growth[25:], rest.growth)
    np.testing.assert_array_equal(whole.tangent, rest.tangent)


def test_phase_of_the_torque_does_not_drift():
    oscillator = dataclasses.replace(CHAOTIC, torque=ExternalTorque(0.25, (0.1,), (0.4,)))
    near, far = strobe(oscillator, (0.0, 0.0), 4), strobe(oscillator, (0.0, 0.0), 4, first_period=4_000_000_000)
    other = strobe(oscillator, (0.0, 0.0), 4, first_period=1)
    np.testing.assert_array_equal(near.states, far.states)
    assert np.abs(near.states[1] - other.states[1]).max() > 1e-3


def piecewise_exact(oscillator, state, cells):
    """State after one period of contact with constant stiffness and force per cell: matrix exponentials."""
    y = np.array([state[0] - 1.0, state[1], 1.0])
    for length, stiffness in cells:
        matrix = np.zeros((3, 3))
        matrix[0, 1], matrix[1] = 1.0, (-stiffness, -2 * oscillator.damping_ratio, oscillator.mean_force)
        y = expm(matrix * length * oscillator.period) @ y
    return y[:2] + (1.0, 0.0)


def test_rectangular_stiffness_is_exact_and_the_limit_of_many_harmonics():
    table = PeriodicTable((0.0, 0.6, 1.0), (1.2, 0.7), (1.2, 0.7))
    oscillator = Oscillator(0.6, 0.05, 3.0, table)
    start = (4.2, 0.1)
    after = strobe(oscillator, start, 1).states[1]
    np.testing.assert_allclose(after, piecewise_exact(oscillator, start, [(0.6, 1.2), (0.4, 0.7)]), atol=1e-8)
    departures = []
    for count in (20, 80):
        j = np.arange(1, count + 1)
        wave = 2 * 0.5 * (1 - np.exp(-2j * np.pi * j * 0.6)) / (2j * np.pi * j)
        harmonics = Harmonics(1.0, np.abs(wave), np.angle(wave))
        smooth = dataclasses.replace(oscillator, stiffness=harmonics)
        departures.append(np.abs(strobe(smooth, start, 1).states[1] - after).max())
    assert departures[1] < 0.3 * departures[0] < 0.03


def test_error_table_with_fine_cells_is_the_smooth_error():
    wave = Harmonics(0.0, (0.1,), (0.5,))
    smooth = strobe(dataclasses.replace(CHAOTIC, error=wave), (0.3, 0.1), 2)
    departures = []
    for cells in (100, 400):
        breaks = np.arange(cells + 1) / cells
        values = wave.at(breaks)
        table = PeriodicTable(breaks, values[:-1], values[1:])
        # The table's state at phase 0 is the one after its kick: half a kick later than the smooth one.
        half = 0.5 * (table.slopes()[0] - table.slopes()[-1]) / CHAOTIC.period
        motion = strobe(dataclasses.replace(CHAOTIC, error=table), (0.3, 0.1 - half), 2)
        departures.append(np.abs(motion.states[2] + (0.0, half) - smooth.states[2]).max())
    assert departures[1] < 0.1 * departures[0] < 1e-3


def test_jump_of_the_error_is_the_limit_of_a_steep_ramp():
    jumping = PeriodicTable((0.0, 0.4, 1.0), (0.0, 0.15), (0.05, 0.0))
    reference = strobe(dataclasses.replace(CHAOTIC, error=jumping), (0.3, 0.1), 2).states[2]
    departures = []
    for width in (1e-3, 1e-4):
        ramp = PeriodicTable((0.0, 0.4, 0.4 + width, 1.0), (0.0, 0.05, 0.15), (0.05, 0.15, 0.0))
        motion = strobe(dataclasses.replace(CHAOTIC, error=ramp), (0.3, 0.1), 2)
        departures.append(np.abs(motion.states[2] - reference).max())
    assert departures[1] < 0.15 * departures[0] < 5e-4


def test_jump_of_the_error_leaves_the_absolute_motion_continuous():
    """y = x + e in y'' + 2 zeta (y' - e') + k f(y - e) = F, with the jump of y' alone put in by hand."""
    jumping = PeriodicTable((0.0, 0.4, 1.0), (0.0, 0.15), (0.05, 0.02))
    oscillator = Oscillator(1.1, 0.1, 0.1, Harmonics(1.0, (-0.4,), (0.0,)), jumping)
    w, c, period = oscillator.frequency, 0.2, oscillator.period
    y = np.array([0.3 + 0.0, 0.1 + 0.05 / 0.4 / period])
    for start, stop, low, high in ((0.0, 0.4, 0.0, 0.05), (0.4, 1.0, 0.15, 0.02)):
        slope = (high - low) / (stop - start) / period

        def rates(t, y, start=start, low=low, slope=slope):
            e = low + slope * (t - start * period)
            f = (y[0] - e) - np.clip(y[0] - e, -1, 1)
            return y[1], 0.1 - c * (y[1] - slope) - (1 - 0.4 * np.cos(w * t)) * f

        if start:
            y[1] += c * (0.15 - 0.05)
        y = solve_ivp(rates, (start * period, stop * period), y, "DOP853", rtol=1e-12, atol=1e-13, max_step=0.02).y[
            :, -1
        ]
    y[1] += c * (0.0 - 0.02)
    expected = (y[0] - 0.0, y[1] - 0.05 / 0.4 / period)
    np.testing.assert_allclose(strobe(oscillator, (0.3, 0.1), 1).states[1], expected, atol=1e-8)


def test_blow_up_is_a_status():
    driven = dataclasses.replace(CHAOTIC, error=Harmonics(0.0, (3e6,), (0.0,)))
    motion = strobe(driven, (0.0, 0.0), 3)
    assert motion.status == BLOW_UP
    assert np.isnan(motion.states[-1]).all()
    assert strobe(CHAOTIC, (0.0, 0.0), 1).status == COMPLETED


def test_too_many_steps_are_a_status():
    slow = dataclasses.replace(CHAOTIC, frequency=2e-6)
    assert slow.period * 3 > period_flow.MOST_STEPS
    assert strobe(slow, (0.0, 0.0), 1).status == TOO_MANY_STEPS


@pytest.mark.parametrize(
    "arguments, message",
    [
        (((0.0,), 1), "state"),
        (((0.0, np.nan), 1), "state"),
        (((0.0, 0.0), -1), "periods: -1"),
        (((0.0, 0.0), 1.5), "periods: 1.5"),
        (((0.0, 0.0), 1, -2), "first_period: -2"),
        (((0.0, 0.0), 1, 0, 1e-16), "tolerance: 1e-16"),
        (((0.0, 0.0), 1, 0, np.nan), "tolerance: nan"),
        (((0.0, 0.0), 1, 0, 1e-10, (0.0, 0.0)), "tangent"),
    ],
)
def test_impossible_requests_are_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        strobe(CHAOTIC, *arguments)


@pytest.mark.parametrize("phases", [[0.2, 0.1], [0.1, 0.1], [-0.1], [1.1], [np.nan]])
def test_impossible_phases_are_refused(phases):
    with pytest.raises(ValueError, match="phases"):
        trace(CHAOTIC, (0.0, 0.0), phases, 1)
