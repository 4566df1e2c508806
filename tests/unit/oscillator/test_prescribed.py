"""Oscillators given by their equation become the excitation that a gear pair would give."""

import math

import numpy as np
import pytest

from gearwear.oscillator.excitation import swept_oscillator
from gearwear.oscillator.oscillator import Oscillator
from gearwear.oscillator.periodic import Harmonics
from gearwear.oscillator.prescribed import given_excitation

SETTINGS = {"damping_ratio": 0.05, "torque_fluctuation": {"frequency_ratio": 1.0, "amplitudes": [], "phases": []}}
SET_OF_1991 = {
    "mean_force": 0.1,
    "stiffness": {"amplitudes": [-0.2, -0.1, -0.05], "phases": [0.0, 0.0, 0.0]},
    "error": {"amplitudes": [0.01, 0.004, 0.002], "phases": [0.0, 0.0, 0.0]},
}
NONE = {"amplitudes": [], "phases": []}


def test_the_set_of_1991_is_the_oscillator_of_its_equation():
    found = given_excitation(SET_OF_1991).oscillator(SETTINGS, 0.5)
    stiffness = Harmonics(1.0, (-0.2, -0.1, -0.05), (0.0, 0.0, 0.0))
    written = Oscillator(0.5, 0.05, 0.1, stiffness, Harmonics(0.0, (0.01, 0.004, 0.002), (0.0, 0.0, 0.0)))
    np.testing.assert_allclose(found.coefficients.harmonics, written.coefficients.harmonics, rtol=1e-15, atol=0)
    assert found.coefficients.constants == written.coefficients.constants


def test_a_sweep_over_the_error_multiplies_it_and_one_over_the_backlash_divides_it():
    source = given_excitation(SET_OF_1991)
    double = swept_oscillator(source, "ste", 2.0, SETTINGS, {"mesh_frequency": 0.5})
    assert double.error.amplitudes == pytest.approx((0.02, 0.008, 0.004), rel=1e-14)
    narrow = swept_oscillator(source, "backlash", 0.5, SETTINGS, {"mesh_frequency": 0.5, "reading": "rescale"})
    assert narrow.error.amplitudes == double.error.amplitudes and narrow.clearance.mean == 1


@pytest.mark.parametrize(("amplitude", "phase"), [(-0.2, 0.0), (0.3, 1.0), (0.3, -2.5), (-0.1, 2.0)])
def test_the_stiffness_is_largest_at_the_stiffest_phase(amplitude, phase):
    source = given_excitation(SET_OF_1991 | {"stiffness": {"amplitudes": [amplitude], "phases": [phase]}})
    assert 0 <= source.stiffest_phase < 1
    assert source.stiffness.at(source.stiffest_phase)[()] == pytest.approx(1 + abs(amplitude), rel=1e-14)


def test_lists_of_unlike_length_and_none_at_all():
    short = given_excitation(SET_OF_1991 | {"stiffness": {"amplitudes": [0.2], "phases": [0.5]}})
    assert short.stiffness == Harmonics(1.0, (0.2, 0.0, 0.0), (0.5, 0.0, 0.0))
    quiet = given_excitation({"mean_force": 0.1, "stiffness": NONE, "error": NONE})
    assert (quiet.stiffness, quiet.shape, quiet.error_amplitude) == (Harmonics(1.0), Harmonics(0.0), 0.0)
    assert math.isnan(quiet.length) and quiet.stiffest_phase == 0
