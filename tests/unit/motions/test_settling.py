"""Classes of settled motion and their evidence."""

import dataclasses

import numpy as np
import pytest

from gearwear.codes import motion_class
from gearwear.integrate.status import GROWTH
from gearwear.motions.settling import Settling, settle, settle_many
from gearwear.oscillator.oscillator import ExternalTorque, Oscillator
from gearwear.oscillator.periodic import Harmonics
from gearwear.oscillator.translational import Bearing, TranslationalOscillator

SETTLING = Settling(200, 1600, 160, 16, 1e-7, 3e-3)
GENTLE = Oscillator(0.9, 0.1, 0.1, Harmonics(1.0, (-0.1,), (0.0,)), Harmonics(0.0, (0.02,), (0.0,)))


def look_alike(frequency):
    return Oscillator(frequency, 0.1, 0.1, Harmonics(1.0, (-0.4,), (0.0,)), Harmonics(0.0, (0.1,), (0.0,)))


def names_over(frequencies):
    return [motion_class.class_name(settle(look_alike(w), (0.0, 0.0), SETTLING).motion_class) for w in frequencies]


def test_route_to_chaos():
    assert names_over([0.4, 0.9, 1.1, 1.21, 1.28, 1.4]) == ["P1", "P1", "P2", "P4", "P16", "CH"]


def test_sweep_of_one_frequency_has_no_quasi_periodic_motion():
    names = names_over(np.linspace(0.4, 1.7, 27))
    assert "QP" not in names
    assert {"P1", "P2", "CH"} <= set(names)


def test_linear_motion_has_closed_form_evidence():
    oscillator = Oscillator(0.8, 0.05, 5.0, Harmonics(1.0), Harmonics(0.0, (0.3,), (0.7,)))
    point = settle(oscillator, (6.0, 0.0), SETTLING)
    rate = np.sqrt(1 - 0.05**2)
    multiplier = np.exp((-0.05 + 1j * rate) * oscillator.period)
    assert (point.motion_class, point.period, point.reason) == (1, 1, motion_class.SETTLED)
    assert abs(point.multiplier_real - multiplier.real) < 1e-7
    assert abs(point.multiplier_imag) == pytest.approx(abs(multiplier.imag), abs=1e-7)
    assert point.exponent == pytest.approx(-0.05, abs=4 * point.exponent_error + 1e-6)
    assert point.determinant_error < 1e-6
    assert (point.contact_loss_share, point.impacts_per_period) == (0.0, 0.0)
    steady = abs(0.3 * 0.8**2 / (1 - 0.8**2 + 0.08j))
    extremes = (point.displacement_min, point.displacement_max, point.force_max)
    assert extremes == pytest.approx((6 - steady, 6 + steady, 5 + steady), abs=1e-6)
    assert point.displacement.shape == point.velocity.shape == (SETTLING.sampled_periods,)


def test_exponent_of_a_periodic_point_is_that_of_its_multiplier():
    point = settle(look_alike(1.1), (0.0, 0.0), SETTLING)
    duration = 2 * look_alike(1.1).period
    expected = np.log(abs(complex(point.multiplier_real, point.multiplier_imag))) / duration
    assert point.exponent == pytest.approx(expected, abs=1e-7)


def test_chaotic_point_has_a_positive_exponent_and_no_period():
    point = settle(look_alike(1.4), (0.0, 0.0), SETTLING)
    assert point.exponent > 0.03 > 3 * point.exponent_error
    assert point.period == 0 and point.recurrence_distance > 0.01
    assert np.isnan(point.multiplier_real)
    assert point.determinant_error < 1e-7


def test_second_frequency_gives_a_quasi_periodic_motion():
    oscillator = dataclasses.replace(GENTLE, torque=ExternalTorque((np.sqrt(5) - 1) / 2, (0.02,), (0.0,)))
    point = settle(oscillator, (0.0, 0.0), SETTLING)
    assert motion_class.class_name(point.motion_class) == "QP"
    assert point.exponent < 0


@pytest.mark.parametrize("ratio, period", [(2.0, 1), (0.5, 2), (2 / 3, 3)])
def test_torque_in_a_simple_ratio_gives_a_periodic_motion(ratio, period):
    oscillator = dataclasses.replace(GENTLE, torque=ExternalTorque(ratio, (0.02,), (0.3,)))
    assert settle(oscillator, (0.0, 0.0), SETTLING).motion_class == period


def test_slow_point_runs_on_and_gives_up_with_a_reason():
    slow = look_alike(1.1834)
    point = settle(slow, (0.0, 0.0), SETTLING)
    assert point.motion_class == motion_class.NOT_CONVERGED
    assert point.reason == motion_class.SLOW_CONVERGENCE
    assert point.transient_periods == SETTLING.longest_transient
    longer = settle(look_alike(1.18), (0.0, 0.0), SETTLING)
    assert longer.motion_class == 2
    assert longer.transient_periods > SETTLING.transient_periods


def test_blow_up_has_not_converged_for_that_reason():
    driven = dataclasses.replace(GENTLE, error=Harmonics(0.0, (3e6,), (0.0,)))
    point = settle(driven, (0.0, 0.0), SETTLING)
    assert (point.motion_class, point.reason) == (motion_class.NOT_CONVERGED, motion_class.BLOWN_UP)
    assert np.isnan(point.exponent) and np.isnan(point.displacement).all()


def test_it_is_deterministic():
    first, second = (settle(look_alike(1.4), (0.0, 0.0), SETTLING) for _ in range(2))
    np.testing.assert_array_equal(first.displacement, second.displacement)
    assert first[:6] == second[:6]


@pytest.mark.parametrize(
    "change, message",
    [
        ({"transient_periods": -1}, "transient_periods: -1"),
        ({"longest_transient": 100}, "transient_periods: 200"),
        ({"sampled_periods": 60}, "sampled_periods: 60"),
        ({"largest_period": 0}, "largest_period: 0"),
        ({"largest_period": 65}, "largest_period: 65"),
        ({"recurrence_tolerance": 0.0}, "recurrence_tolerance"),
        ({"chaos_threshold": np.nan}, "chaos_threshold"),
    ],
)
def test_impossible_settings_are_refused(change, message):
    with pytest.raises(ValueError, match=message):
        settle(GENTLE, (0.0, 0.0), SETTLING._replace(**change))


def test_many_points_settle_as_each_alone():
    frequencies = [0.4, 1.0, 1.18, 1.1834, 1.4, 1.6]
    oscillators = [look_alike(w) for w in frequencies]
    oscillators += [dataclasses.replace(GENTLE, error=Harmonics(0.0, (3e6,), (0.0,)))]
    oscillators += [dataclasses.replace(GENTLE, torque=ExternalTorque(0.5, (0.02,), (0.0,)))]
    states = np.linspace(-1.0, 1.0, 2 * len(oscillators)).reshape(-1, 2)
    together = settle_many(oscillators, states, SETTLING)
    for oscillator, state, motion in zip(oscillators, states, together, strict=True):
        for one, other in zip(motion, settle(oscillator, state, SETTLING), strict=True):
            np.testing.assert_array_equal(one, other)


def test_less_detail_leaves_out_what_needs_more():
    whole = settle(look_alike(1.1), (0.0, 0.0), SETTLING)
    little = settle_many([look_alike(1.1)], (0.0, 0.0), SETTLING, detail=GROWTH)[0]
    missing = ("determinant_error", "contact_loss_share", "impacts_per_period")
    missing += ("displacement_min", "displacement_max", "force_max")
    for name, one, other in zip(whole._fields, whole, little, strict=True):
        np.testing.assert_allclose(other, np.nan if name in missing else one, rtol=1e-12)


def test_no_points_give_no_motions():
    assert settle_many([], np.empty((0, 2)), SETTLING) == []


def test_an_early_end_changes_nothing_but_round_off():
    oscillators = [look_alike(w) for w in (0.4, 0.9, 1.1, 1.21, 1.4)]
    whole = settle_many(oscillators, (0.0, 0.0), SETTLING)
    early = settle_many(oscillators, (0.0, 0.0), SETTLING._replace(early_end=True))
    for one, other in zip(whole, early, strict=True):
        for name in one._fields:
            rounded = name in ("exponent", "exponent_error")
            np.testing.assert_allclose(getattr(other, name), getattr(one, name), rtol=0, atol=1e-12 if rounded else 0)


def test_a_pair_on_stiff_bearings_settles_as_the_torsional_one():
    """Period 1, period 2 and chaos: class, exponent and, where it is periodic, the section."""
    bearings = {name: Bearing(mass, (2e3, 1e3), 0.05) for name, mass in (("pinion", 3.0), ("gear", 9.0))}
    for frequency, name in ((0.9, "P1"), (1.1, "P2"), (1.4, "CH")):
        single = look_alike(frequency)
        settled = settle(single, (0.0, 0.0), SETTLING)
        of_mesh = {field.name: getattr(single, field.name) for field in dataclasses.fields(single)}
        coupled = TranslationalOscillator(**of_mesh, **bearings, pressure_angle=0.35)
        motion = settle(coupled, (0.0, 0.0), SETTLING)
        assert motion_class.class_name(motion.motion_class) == name
        assert motion.exponent == pytest.approx(settled.exponent, abs=0.01)
        assert motion.contact_loss_share == pytest.approx(settled.contact_loss_share, abs=0.02)
        assert motion.end.shape == (10,)
        if motion.period:
            np.testing.assert_allclose(motion.displacement[-2:], settled.displacement[-2:], atol=5e-3)
            assert motion.stable_orbit_period == settled.stable_orbit_period == motion.period
            multiplier = abs(complex(motion.multiplier_real, motion.multiplier_imag))
            # over the sample the length of the tangent vector swings about its mean growth, by a factor below e
            swing = 1 / (SETTLING.sampled_periods * single.period)
            assert motion.exponent == pytest.approx(np.log(multiplier) / motion.period / single.period, abs=swing)
