"""Units, amplitudes and phases of the excitation made from a rectangular mesh with known answers."""

import math

import numpy as np
import pytest
import xarray as xr

from gearwear.oscillator.excitation import excitation, swept_oscillator
from gearwear.oscillator.harmonics import mean_over_mesh
from gearwear.oscillator.oscillator import ExternalTorque
from gearwear.oscillator.periodic import PeriodicTable

RATIO, MASS, TORQUE, BASE = 1.6, 0.5, 130.0, 28e-3
FORCE = TORQUE / BASE
SETTINGS = {
    "model": "torsional",
    "damping_ratio": 0.08,
    "stiffness": "nominal",
    "harmonics": 1,
    "ste_amplitude": "nominal",
    "clearance": "mean",
    "torque_fluctuation": {"frequency_ratio": 1.0, "amplitudes": [], "phases": []},
}


@pytest.fixture(scope="module")
def geometry():
    pieces = [(0, 0.25, 200), (0.25, RATIO - 1, 400), (RATIO - 1, 1, 400)]
    edges = np.append(np.concatenate([np.linspace(*piece, endpoint=False) for piece in pieces]), 1.0)
    phase = (edges[1:] + edges[:-1]) / 2
    return xr.Dataset(
        {
            "mesh_phase_width": ("mesh_phase", np.diff(edges)),
            "leaving": ("mesh_phase", np.where(phase < RATIO - 1, 7, -1)),
            "base_radius": ("gear", [BASE, 70e-3]),
            "equivalent_mass": MASS,
        },
        {"mesh_phase": phase},
    )


def mesh(geometry, double=4e8, single=2.5e8, error=1.0, gap=65e-6):
    """Return a state with a rectangular stiffness, the error of an ideal pair times a factor, and a varying gap."""
    two = geometry["leaving"].values >= 0
    stiffness = np.where(two, double, single)
    tau = geometry["mesh_phase"].values
    values = {
        "mesh_stiffness": stiffness,
        "effective_stiffness": 0.9 * stiffness,
        "transmission_error": error * FORCE / stiffness,
        "backlash": gap + 2e-6 * np.cos(2 * np.pi * tau - 1),
    }
    dataset = xr.Dataset({name: ("mesh_phase", value) for name, value in values.items()})
    return dataset.assign(initial_half_backlash=65e-6)


@pytest.fixture
def reference(geometry):
    return mesh(geometry)


@pytest.fixture
def worn(geometry):
    return mesh(geometry, 3.8e8, 2.4e8, 1.12, 62e-6)


def of(geometry, state, reference, **changes):
    return excitation(geometry, state, reference, TORQUE, SETTINGS | changes)


def test_units_are_the_initial_backlash_and_the_own_natural_frequency(geometry, reference, worn):
    found = of(geometry, worn, reference)
    mean = 0.6 * 3.8e8 + 0.4 * 2.4e8
    assert found.length == 65e-6
    assert found.mean_stiffness == pytest.approx(mean, rel=1e-12)
    assert found.natural_frequency == pytest.approx(math.sqrt(mean / MASS), rel=1e-12)
    assert found.mean_force == pytest.approx(FORCE, rel=1e-12)
    assert found.force_parameter == pytest.approx(FORCE / (mean * 65e-6), rel=1e-12)
    assert found.clearance.mean == pytest.approx(62 / 65, rel=1e-3)


def test_first_harmonic_of_stiffness_and_error_are_in_antiphase_for_an_ideal_pair(geometry, reference):
    found = of(geometry, reference, reference)
    assert found.stiffness.mean == 1
    mean = 0.6 * 4e8 + 0.4 * 2.5e8
    expected = 2 / math.pi * 1.5e8 * math.sin(0.6 * math.pi) / mean
    assert found.stiffness.amplitudes[0] == pytest.approx(expected, rel=1e-3)
    assert found.stiffness.phases[0] == pytest.approx(-0.6 * math.pi, abs=1e-5)
    assert found.shape.amplitudes == pytest.approx((1.0,))
    assert found.shape.phases[0] == pytest.approx(0.4 * math.pi, abs=1e-5)


def test_meanings_of_the_error_amplitude(geometry, reference, worn):
    ratio = (0.6 / 3.8e8 + 0.4 / 2.4e8) * 1.12 / (0.6 / 4e8 + 0.4 / 2.5e8)
    found = {name: of(geometry, worn, reference, ste_amplitude=name) for name in ("nominal", "mean", "harmonic")}
    for one in found.values():
        assert one.relative_mean_error == pytest.approx(ratio, rel=1e-12)
    nominal = FORCE / (0.6 * 4e8 + 0.4 * 2.5e8) / 65e-6
    assert found["nominal"].reference_amplitude == pytest.approx(nominal, rel=1e-12)
    assert found["nominal"].error_amplitude == pytest.approx(ratio * nominal, rel=1e-12)
    mean = FORCE * (0.6 / 4e8 + 0.4 / 2.5e8) / 65e-6
    assert found["mean"].reference_amplitude == pytest.approx(mean, rel=1e-12)
    assert found["mean"].error_amplitude == pytest.approx(ratio * mean, rel=1e-12)
    step = 1.12 * FORCE * (1 / 2.4e8 - 1 / 3.8e8) / 65e-6
    first = 2 / math.pi * step * math.sin(0.6 * math.pi)
    assert found["harmonic"].error_amplitude == pytest.approx(first, rel=1e-3)


def test_effective_stiffness_replaces_the_nominal_one_throughout(geometry, reference, worn):
    nominal, effective = of(geometry, worn, reference), of(geometry, worn, reference, stiffness="effective")
    assert effective.mean_stiffness == pytest.approx(0.9 * nominal.mean_stiffness, rel=1e-12)
    assert effective.reference_amplitude == pytest.approx(nominal.reference_amplitude / 0.9, rel=1e-12)
    assert effective.stiffness.amplitudes == pytest.approx(nominal.stiffness.amplitudes)


def test_all_harmonics_are_scaled_with_the_first(geometry, reference, worn):
    found = of(geometry, worn, reference, harmonics=3)
    orders = np.arange(1, 4)
    ratios = np.abs(np.sin(0.6 * np.pi * orders)) / orders / math.sin(0.6 * math.pi)
    np.testing.assert_allclose(found.shape.amplitudes, ratios, rtol=5e-3)
    oscillator = found.oscillator(SETTINGS, 0.7)
    np.testing.assert_allclose(oscillator.error.amplitudes, found.error_amplitude * ratios, rtol=5e-3)


def test_full_tables_pass_through_the_cells_and_jump_only_between_zones(geometry, reference, worn):
    found = of(geometry, worn, reference, harmonics="full")
    for table, values in ((found.stiffness, worn["mesh_stiffness"]), (found.shape, worn["transmission_error"])):
        assert isinstance(table, PeriodicTable)
        scale = values.values[0] / table.at(geometry["mesh_phase"].values)[0]
        np.testing.assert_allclose(table.at(geometry["mesh_phase"].values) * scale, values.values, rtol=1e-9)
        gaps = np.abs(np.array(table.start[1:]) - np.array(table.end[:-1]))
        assert np.flatnonzero(gaps > 1e-9).tolist() == [599]
        assert abs(table.start[0] - table.end[-1]) > 1e-9
    assert found.stiffness.breaks == found.shape.breaks
    assert mean_over_mesh(found.stiffness.at(geometry["mesh_phase"].values), geometry["mesh_phase_width"].values) == (
        pytest.approx(1, rel=1e-12)
    )


def test_tables_are_exact_for_functions_linear_in_each_zone(geometry, reference):
    tau = geometry["mesh_phase"].values
    two = geometry["leaving"].values >= 0

    def linear(phase, double):
        return np.where(double, 4e8 + 1e8 * phase, 2.5e8 - 3e7 * phase)

    state = reference.assign(mesh_stiffness=("mesh_phase", linear(tau, two)))
    found = of(geometry, state, reference, harmonics="full")
    inside = np.concatenate([np.linspace(0, 0.6, 50, endpoint=False), np.linspace(0.6 + 1e-12, 1, 50, endpoint=False)])
    np.testing.assert_allclose(
        found.stiffness.at(inside) * found.mean_stiffness, linear(inside, inside < 0.6), rtol=1e-9
    )


def test_clearance_varies_only_if_asked(geometry, reference, worn):
    assert of(geometry, worn, reference).clearance.amplitudes == ()
    varying = of(geometry, worn, reference, clearance="varying").clearance
    assert varying.amplitudes == pytest.approx((2 / 65,), rel=1e-3)
    assert varying.phases == pytest.approx((-1.0,), abs=1e-3)
    assert len(of(geometry, worn, reference, clearance="varying", harmonics="full").clearance.amplitudes) == 16


def test_oscillator_takes_damping_force_and_torque_from_the_settings(geometry, reference, worn):
    torque = {"frequency_ratio": 0.5, "amplitudes": [0.2, 0.1], "phases": [1.5, 0.3]}
    found = of(geometry, worn, reference)
    oscillator = found.oscillator(SETTINGS | {"torque_fluctuation": torque}, 0.7)
    assert (oscillator.frequency, oscillator.damping_ratio) == (0.7, 0.08)
    assert oscillator.mean_force == found.force_parameter
    force = found.force_parameter
    assert oscillator.torque == ExternalTorque(0.5, (0.2 * force, 0.1 * force), (1.5, 0.3))
    assert oscillator.error.amplitudes == pytest.approx((found.error_amplitude,))
    assert oscillator.error.mean == 0


def test_sweep_of_the_mesh_frequency_changes_the_frequency_only(geometry, reference, worn):
    source = of(geometry, worn, reference)
    assert swept_oscillator(source, "mesh_frequency", 1.3, SETTINGS, {}) == source.oscillator(SETTINGS, 1.3)


def test_sweep_of_the_error_is_in_units_of_the_reference_case(geometry, reference, worn):
    source, swept = of(geometry, worn, reference), {"mesh_frequency": 1.0}
    own = swept_oscillator(source, "ste", source.relative_mean_error, SETTINGS, swept)
    assert own.error.amplitudes == pytest.approx(source.oscillator(SETTINGS, 1.0).error.amplitudes, rel=1e-12)
    twice = swept_oscillator(source, "ste", 2.0, SETTINGS, swept)
    assert twice.error.amplitudes == pytest.approx((2 * source.reference_amplitude,), rel=1e-12)
    assert twice.clearance == source.clearance


def test_sweep_of_the_backlash_scales_the_error_or_the_clearance(geometry, reference, worn):
    source = of(geometry, worn, reference)
    rescaled = swept_oscillator(source, "backlash", 0.5, SETTINGS, {"mesh_frequency": 1.0, "reading": "rescale"})
    assert rescaled.error.amplitudes == pytest.approx((2 * source.reference_amplitude,), rel=1e-12)
    assert rescaled.clearance == source.clearance
    assert rescaled.mean_force == source.force_parameter
    wider = swept_oscillator(source, "backlash", 0.5, SETTINGS, {"mesh_frequency": 1.0, "reading": "clearance"})
    assert wider.clearance.mean == pytest.approx(0.5, rel=1e-12)
    assert wider.error == source.oscillator(SETTINGS, 1.0).error


def test_an_error_that_is_none_excites_nothing(geometry, reference):
    flat = reference.assign(transmission_error=("mesh_phase", np.full(1000, 1e-17)))
    alone = of(geometry, flat, flat, ste_amplitude="harmonic")
    assert alone.error_amplitude == 0 and not any(alone.shape.amplitudes)
    assert math.isnan(alone.relative_mean_error)
    worn = of(geometry, reference, flat, ste_amplitude="harmonic")
    assert worn.reference_amplitude == worn.error_amplitude > 0


@pytest.mark.parametrize("key", ["spacing_error", "base_pitch_difference"])
def test_error_of_the_spacing_alone_is_a_rectangle_or_a_sawtooth_with_its_jumps(geometry, reference, key):
    """Without load e is the least material that a pair in contact lacks: -E_s while two pairs are, or E_s tau."""
    spacing, tau = 4e-6, geometry["mesh_phase"].values
    error = np.where(tau < RATIO - 1, -spacing, 0.0) if key == "spacing_error" else spacing * tau
    state = reference.assign(transmission_error=("mesh_phase", error))
    first = of(geometry, state, reference, ste_amplitude="harmonic")
    full = of(geometry, state, reference, ste_amplitude="harmonic", harmonics="full")
    if key == "spacing_error":
        amplitude, phase = 2 / math.pi * spacing * math.sin(0.6 * math.pi), 0.4 * math.pi
        jumps = {0.0: -spacing, RATIO - 1: spacing}
    else:
        amplitude, phase, jumps = spacing / math.pi, math.pi / 2, {0.0: -spacing, RATIO - 1: 0.0}
    assert first.error_amplitude == full.error_amplitude == pytest.approx(amplitude / 65e-6, rel=1e-3)
    assert first.shape.phases[0] == pytest.approx(phase, abs=1e-5)
    table = full.shape.scaled(full.error_amplitude)
    for place, jump in jumps.items():
        assert table.jump(np.array([place]))[0] == pytest.approx(jump / 65e-6, abs=1e-9)
    np.testing.assert_allclose(table.at(tau), error / 65e-6, atol=1e-12)
