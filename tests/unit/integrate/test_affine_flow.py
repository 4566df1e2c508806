"""The tabulated affine map against a stored 80-bit reference, closed forms and the Dormand-Prince integrator."""

import dataclasses
import math
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import expm

from gearwear.integrate.affine import affine_table
from gearwear.integrate.status import GROWTH, MAPS, RECORDS, STATES
from gearwear.integrate.strobe import GENERAL, monodromy, strobe, trace
from gearwear.oscillator.oscillator import ExternalTorque, Oscillator
from gearwear.oscillator.periodic import Harmonics, PeriodicTable

# States over ten periods by heyoka 7.13 in 80-bit arithmetic, corners as events: benchmarks/heyoka_oracle.py.
REFERENCE = np.load(Path(__file__).with_name("affine_reference.npz"))
CHAOTIC = Oscillator(1.4, 0.1, 0.1, Harmonics(1.0, (-0.4,), (0.0,)), Harmonics(0.0, (0.1,), (0.0,)))


def reference_oscillator(frequency, damping_ratio, mean_force, kappa, error, phase, clearance):
    return Oscillator(
        frequency,
        damping_ratio,
        mean_force,
        Harmonics(1.0, (kappa,), (0.0,)),
        Harmonics(0.0, (error,), (phase,)),
        Harmonics(clearance),
    )


def random_oscillator(seed, clearance):
    """Any combination of harmonics, tables with kicks, varying clearance and a torque in step with the mesh."""
    random = np.random.default_rng(seed)
    count = seed % 4 + 1
    breaks = np.concatenate([[0.0], np.sort(random.uniform(0.1, 0.9, 3)), [1.0]])
    stiffness = Harmonics(1.0, random.uniform(0, 0.8 / count, count), random.uniform(0, 6, count))
    error = Harmonics(0.0, random.uniform(0, 0.3, count) / np.arange(1, count + 1) ** 2, random.uniform(0, 6, count))
    if seed % 3 == 1:
        stiffness = PeriodicTable(breaks, random.uniform(0.5, 1.5, 4), random.uniform(0.5, 1.5, 4))
    if seed % 3 == 2:
        error = PeriodicTable(breaks, random.uniform(-0.1, 0.1, 4), random.uniform(-0.1, 0.1, 4))
    waves = seed // 2 % 3
    return Oscillator(
        random.uniform(0.1, 2.2),
        random.uniform(0.01, 0.1),
        random.uniform(-0.3, 0.5),
        stiffness,
        error,
        Harmonics(clearance, clearance * random.uniform(0, 0.4, waves), random.uniform(0, 6, waves)),
        ExternalTorque(2.0, (0.05, 0.0, 0.02), (0.3, 0.0, 1.2)) if seed % 5 == 0 else ExternalTorque(),
    )


@pytest.mark.parametrize("name, chaotic", [("sweep", 50), ("random", 0)])
def test_every_point_agrees_with_the_reference(name, chaotic):
    """400 points of a sweep and 320 random ones with clearances down to 0.001, over ten periods."""
    parameters, expected = REFERENCE[f"{name}_parameters"], REFERENCE[f"{name}_states"]
    errors, growing = [], 0
    for values, states in zip(parameters, expected, strict=True):
        motion = strobe(reference_oscillator(*values), states[0], len(states) - 1, detail=GROWTH)
        errors.append(np.abs(motion.states - states).max())
        growing += motion.growth.sum() > 0
    assert len(errors) >= 320 and growing > chaotic
    assert np.median(errors) < 2e-14
    assert max(errors) < 1e-11


@pytest.mark.parametrize("seed", range(40))
def test_agrees_with_dormand_prince(seed):
    oscillator = random_oscillator(seed, (1.0, 0.1, 0.01, 0.001)[seed % 4])
    start = np.random.default_rng(seed).uniform(-1, 1, 2)
    motion = strobe(oscillator, start, 3)
    other = strobe(oscillator, start, 3, tolerance=1e-13, backend=GENERAL)
    np.testing.assert_allclose(motion.states, other.states, atol=1e-9)
    np.testing.assert_allclose(motion.tangent_maps, other.tangent_maps, atol=1e-7)
    np.testing.assert_allclose(motion.growth, other.growth, atol=1e-6)
    np.testing.assert_allclose(motion.lost, other.lost, atol=1e-8)
    np.testing.assert_array_equal(motion.impacts, other.impacts)
    for name in ("displacement_min", "displacement_max", "force_max"):
        np.testing.assert_allclose(getattr(motion, name), getattr(other, name), atol=1e-7)


def test_determinant_of_every_period_is_the_contraction_to_round_off():
    for oscillator in (CHAOTIC, *(random_oscillator(seed, 0.05) for seed in range(12))):
        maps = strobe(oscillator, (0.3, 0.1), 60, detail=MAPS).tangent_maps
        determinants = maps[:, 0, 0] * maps[:, 1, 1] - maps[:, 0, 1] * maps[:, 1, 0]
        scale = np.abs(maps[:, 0, 0] * maps[:, 1, 1]) + np.abs(maps[:, 0, 1] * maps[:, 1, 0])
        contraction = math.exp(-2 * oscillator.damping_ratio * oscillator.period)
        # Round-off is relative to the two products of which the determinant is the difference.
        assert np.all(np.abs(determinants - contraction) < 1e-12 * np.maximum(contraction, 0.01 * scale))


def test_free_flight_is_exact():
    z, force = 0.05, 0.1
    oscillator = Oscillator(0.3, z, force, clearance=Harmonics(100.0))
    phases = np.linspace(0, 1, 7)
    x, v = trace(oscillator, (0.2, -0.4), phases, 2)
    t = oscillator.period * (phases + np.array([[0.0], [1.0]]))
    drift, c = force / (2 * z), 2 * z
    np.testing.assert_allclose(x, 0.2 + drift * t - (-0.4 - drift) * np.expm1(-c * t) / c, rtol=2e-14)
    np.testing.assert_allclose(v, drift + (-0.4 - drift) * np.exp(-c * t), atol=2e-14)


def test_monodromy_of_contact_is_exact():
    oscillator = Oscillator(0.8, 0.05, 5.0)
    _, matrix = monodromy(oscillator, (6.0, 0.0), 3)
    np.testing.assert_allclose(matrix, expm(3 * oscillator.period * np.array([[0, 1], [-1, -0.1]])), atol=1e-14)


def test_rectangular_stiffness_is_exact():
    """Three cells of constant stiffness in contact: matrix exponentials."""
    table = PeriodicTable((0.0, 0.25, 0.6, 1.0), (1.1, 0.9, 1.05), (1.1, 0.9, 1.05))
    oscillator = Oscillator(0.6, 0.05, 20.0, table)
    y = np.array([19.2, 0.1, 1.0])
    for length, stiffness in ((0.25, 1.1), (0.35, 0.9), (0.4, 1.05)):
        y = expm(np.array([[0, 1, 0], [-stiffness, -0.1, 20.0], [0, 0, 0]]) * length * oscillator.period) @ y
    motion = strobe(oscillator, (20.2, 0.1), 1)
    assert motion.lost[0] == 0.0
    np.testing.assert_allclose(motion.states[1], y[:2] + (1.0, 0.0), rtol=5e-14)


def test_turning_point_walks_through_the_corner():
    """Free flights that turn around the corner in steps of 1e-9: in contact exactly those that reach it.

    A flight that turns at depth d in contact leaves it after 2 sqrt(2 d / |a|), but for higher orders of sqrt(d).
    """
    z, force, duration = 0.05, -0.2, 1.7
    drift, c = force / (2 * z), 2 * z
    v = drift - drift * math.exp(c * duration)
    rise = drift * duration - (v - drift) * math.expm1(-c * duration) / c
    oscillator = Oscillator(2 * np.pi / (1.3 * duration), z, force)
    depths = np.arange(-40, 41) * 1e-9 + 5e-10
    for depth in depths:
        motion = strobe(oscillator, (1.0 + depth - rise, v), 1)
        assert motion.impacts[0] == (1 if depth > 0 else 0)
        contact = (1 - motion.lost[0]) * oscillator.period
        expected = 2 * math.sqrt(2 * depth / -force) if depth > 0 else 0.0
        assert contact == pytest.approx(expected, rel=1e-3, abs=1e-13)
        assert motion.force_max[0] == pytest.approx(max(depth, 0.0), rel=1e-3, abs=1e-15)
        assert motion.displacement_max[0] == pytest.approx(1 + depth, abs=1e-14)


def test_states_do_not_depend_on_the_detail():
    runs = [strobe(CHAOTIC, (0.3, 0.1), 200, detail=detail) for detail in (STATES, GROWTH, MAPS, RECORDS)]
    for run in runs[:-1]:
        np.testing.assert_array_equal(run.states, runs[-1].states)
    assert runs[0].growth is None and runs[1].tangent_maps is None and runs[2].lost is None


def test_shorter_cells_give_the_same_motion():
    """Phases to be visited cut the cells: 64 of them make another table, with other crossings in each cell."""
    x, v = trace(CHAOTIC, (0.3, 0.1), np.arange(1, 65) / 64, 10)
    states = strobe(CHAOTIC, (0.3, 0.1), 10, detail=STATES).states
    np.testing.assert_allclose(np.column_stack([x[:, -1], v[:, -1]]), states[1:], atol=2e-13)


@pytest.mark.parametrize("ratio", [0.25, 1.5, 1 / 19, 24 / 19])
def test_a_torque_that_repeats_after_some_mesh_periods_is_served(ratio):
    """Harmonics of a shaft, over two of its turns, from any mesh period of it."""
    torque = ExternalTorque(ratio, (0.03, 0.02), (0.4, 1.3))
    oscillator = dataclasses.replace(CHAOTIC, frequency=0.9, torque=torque)
    assert affine_table.affine_table(oscillator) is not None and oscillator.has_second_frequency
    motion = strobe(oscillator, (0.3, 0.1), 38, first_period=3)
    other = strobe(oscillator, (0.3, 0.1), 38, first_period=3, tolerance=1e-13, backend=GENERAL)
    for name in ("states", "lost", "displacement_max", "force_max"):
        np.testing.assert_allclose(getattr(motion, name), getattr(other, name), atol=1e-7, err_msg=name)
    rest = strobe(oscillator, motion.states[20], 18, first_period=23)
    np.testing.assert_array_equal(rest.states, motion.states[20:])
    early = strobe(oscillator, (0.3, 0.1), 38, first_period=3, detect_cycles=True)
    np.testing.assert_array_equal(early.states, motion.states)
    x, v = trace(oscillator, (0.3, 0.1), (0.4, 1.0), 5, first_period=3)
    np.testing.assert_allclose(np.column_stack([x[:, 1], v[:, 1]]), motion.states[1:6], atol=1e-12)


def test_torque_that_does_not_repeat_and_endless_periods_are_left_to_dormand_prince():
    torque = dataclasses.replace(CHAOTIC, torque=ExternalTorque(0.618, (0.05,), (0.4,)))
    for oscillator in (torque, dataclasses.replace(CHAOTIC, frequency=1e-4)):
        assert affine_table.affine_table(oscillator) is None
    general = strobe(torque, (0.0, 0.0), 2, backend=GENERAL)
    np.testing.assert_array_equal(strobe(torque, (0.0, 0.0), 2).states, general.states)


@pytest.mark.parametrize("change, message", [({"detail": 4}, "detail: 4"), ({"backend": "euler"}, "backend: 'euler'")])
def test_unknown_requests_are_refused(change, message):
    with pytest.raises(ValueError, match=message):
        strobe(CHAOTIC, (0.0, 0.0), 1, **change)
