"""Traced orbits: linear motion in contact, whose response has a closed form."""

import numpy as np
import pytest

from gearwear.motions import trace
from gearwear.motions.settling import Settling
from gearwear.motions.sweep import sweep
from gearwear.oscillator.excitation import Excitation, SweptOscillator
from gearwear.oscillator.periodic import Harmonics

SETTLING = Settling(200, 800, 64, 8, 1e-7, 3e-3)
DYNAMICS = {
    "damping_ratio": 0.05,
    "tolerance": 1e-10,
    "torque_fluctuation": {"frequency_ratio": 1.0, "amplitudes": [], "phases": []},
    "start": {"at": "pair_entry", "displacement": 1.1, "velocity": 0.0},
}
FREQUENCY, FORCE, AMPLITUDE = 0.5, 0.1, 0.05


@pytest.fixture(scope="module")
def swept():
    waves = Harmonics(0.0, (1.0,), (0.0,))
    mesh = Harmonics(1.0), waves, AMPLITUDE, AMPLITUDE, 1.0, Harmonics(1.0), 0.5
    return SweptOscillator(Excitation(1.0, 1.0, 100.0, FORCE, FORCE, *mesh), "mesh_frequency", DYNAMICS)


@pytest.fixture(scope="module")
def exact():
    """Displacement and velocity over one mesh period of the linear oscillator in contact."""
    phase = np.arange(trace.STEPS + 1) / trace.STEPS
    response = AMPLITUDE * FREQUENCY**2 / (1 - FREQUENCY**2 + 2j * 0.05 * FREQUENCY)
    wave = response * np.exp(2j * np.pi * phase)
    return 1 + FORCE + wave.real, (1j * FREQUENCY * wave).real


def test_a_portrait_is_one_period_of_the_settled_motion(swept, exact):
    found = trace.portraits(swept, np.array([FREQUENCY]), SETTLING)
    for name, values in zip(("displacement", "velocity"), exact, strict=True):
        orbit = found[f"orbit_{name}"].values[0]
        np.testing.assert_allclose(orbit[: trace.STEPS + 1], values, atol=1e-9)
        assert np.isnan(orbit[trace.STEPS + 1 :]).all()
    assert found["orbit_period"].values[[0, trace.STEPS, -1]].tolist() == [0.0, 1.0, trace.LONGEST_PORTRAIT]
    assert found["motion_class"].values.tolist() == [1]


def test_a_steady_motion_has_its_mesh_force(swept, exact):
    found = trace.steady_motions(swept, sweep(swept, np.array([FREQUENCY]), SETTLING))
    force = found["orbit_force"].values[0]
    np.testing.assert_allclose(force[: trace.STEPS + 1], (exact[0] - 1) / FORCE, atol=1e-7)
    assert np.isnan(force[trace.STEPS + 1 :]).all()
    assert found["natural_frequency"] == 100.0


def test_a_motion_that_does_not_repeat_is_traced_to_the_end_and_a_lost_one_not_at_all(swept):
    points = sweep(swept, np.array([FREQUENCY, 0.6]), SETTLING)
    points["period"][:] = 0
    points["section_displacement"][1] = np.nan
    orbits = trace.steady_motions(swept, points)["orbit_displacement"].values
    assert np.isfinite(orbits[0]).all() and orbits.shape[1] == trace.LONGEST_MOTION * trace.STEPS + 1
    assert np.isnan(orbits[1]).all()
