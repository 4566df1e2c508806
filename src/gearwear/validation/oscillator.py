"""Motions of the oscillator that are known in closed form or from other programs."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from scipy.optimize import brentq

from gearwear.integrate.status import MAPS
from gearwear.integrate.strobe import strobe
from gearwear.motions.settling import Attractor, Settling, settle
from gearwear.oscillator.oscillator import Oscillator
from gearwear.oscillator.periodic import Harmonics

_SETTLING = Settling(400, 6400, 240, 16, 1e-7, 3e-3)


def oscillator_of(
    frequency: float, damping_ratio: float, mean_force: float, stiffness: Any = (), error: Any = ()
) -> Oscillator:
    """Return k = 1 + sum k_j cos j w t, forced by F + sum e_j (j w)^2 cos j w t."""
    waves = [(tuple(amplitudes), (0.0,) * len(amplitudes)) for amplitudes in (stiffness, error)]
    return Oscillator(frequency, damping_ratio, mean_force, Harmonics(1.0, *waves[0]), Harmonics(0.0, *waves[1]))


def contact_loss_edge(damping_ratio: float, mean_force: float, amplitude: float, low: float, high: float) -> float:
    """Return the frequency between `low` and `high` where the harmonic motion of constant stiffness touches x = b."""

    def loses(frequency: float) -> bool:
        steady = amplitude * frequency**2 / (1 - frequency**2 + 2j * damping_ratio * frequency)
        state = (1 + mean_force + steady.real, (1j * frequency * steady).real)
        oscillator = oscillator_of(frequency, damping_ratio, mean_force, (), (amplitude,))
        return bool(strobe(oscillator, state, 3).lost[1] > 0)

    first = loses(low)
    while high - low > 1e-8:
        middle = (low + high) / 2
        low, high = (middle, high) if loses(middle) == first else (low, middle)
    return (low + high) / 2


def determinant_error(system: dict[str, Any], frequency: float, periods: int = 400) -> float:
    """Return the largest departure of det(one-period map) / exp(-2 zeta T) from 1 from rest on."""
    oscillator = oscillator_of(frequency, **system)
    maps = strobe(oscillator, (0.0, 0.0), periods, detail=MAPS).tangent_maps
    exact = math.exp(-2 * oscillator.damping_ratio * oscillator.period)
    return float(np.abs(np.linalg.det(maps) / exact - 1).max())


def parametric_onset(damping_ratio: float) -> float:
    """Return k_1 over zeta at which the motion of k = 1 + k_1 cos 2 t without contact loss becomes unstable."""

    def growth(factor: float) -> float:
        oscillator = oscillator_of(2.0, damping_ratio, 1.0, (factor * damping_ratio,))
        return max(abs(np.linalg.eigvals(strobe(oscillator, (2.0, 0.0), 1).tangent_maps[0]))) - 1

    return brentq(growth, 3.0, 5.0)


def _settled(system: dict[str, Any], frequency: float) -> Attractor:
    return settle(oscillator_of(frequency, **system), (0.0, 0.0), _SETTLING)


def period(system: dict[str, Any], frequency: float) -> int:
    """Return the class of the motion from rest: its period in mesh periods, 0 if undecided."""
    return _settled(system, frequency).motion_class


def section(system: dict[str, Any], frequency: float) -> tuple[Any, Any]:
    """Return displacement and velocity at mesh phase 0 of a motion of period 1."""
    motion = _settled(system, frequency)
    return motion.displacement[-1], motion.velocity[-1]


def displacements(system: dict[str, Any], frequency: float) -> list[Any]:
    """Return the displacements at mesh phase 0 over one period of the motion, largest first."""
    motion = _settled(system, frequency)
    return sorted(motion.displacement[-max(motion.period, 1) :], reverse=True)


def multiplier(system: dict[str, Any], frequency: float) -> tuple[float, float]:
    """Return real part and modulus of the imaginary part of the largest Floquet multiplier."""
    motion = _settled(system, frequency)
    return motion.multiplier_real, abs(motion.multiplier_imag)


def extremes(system: dict[str, Any], frequency: float) -> tuple[float, float]:
    """Return the least and largest displacement."""
    motion = _settled(system, frequency)
    return motion.displacement_min, motion.displacement_max


def contact_loss(system: dict[str, Any], frequency: float) -> float:
    """Return the part of the time out of contact."""
    return _settled(system, frequency).contact_loss_share


QUANTITIES = {
    "contact_loss_edge": contact_loss_edge,
    "determinant_error": determinant_error,
    "parametric_onset": parametric_onset,
    "period": period,
    "section": section,
    "displacements": displacements,
    "multiplier": multiplier,
    "extremes": extremes,
    "contact_loss": contact_loss,
}
