"""From the mesh of one state to its oscillator: units, amplitudes and phases of the excitation.

Length unit is the initial half backlash b0, time unit the inverse natural frequency of the case.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from gearwear.errors import Infeasible
from gearwear.geometry.kinematics import mesh_force
from gearwear.oscillator.harmonics import harmonics, mean_over_mesh
from gearwear.oscillator.oscillator import ExternalTorque, Oscillator
from gearwear.oscillator.periodic import Harmonics, PeriodicTable
from gearwear.oscillator.translational import Bearing, TranslationalOscillator

_NO_ERROR = 1e-12  # m; round-off of an error that is none
_TABLE_CLEARANCE_HARMONICS = 16  # a clearance is a sum of harmonics even where k and e are tables


class Excitation(NamedTuple):
    """What drives the oscillator of one state.

    Attributes
    ----------
    length : b0, m.
    mean_stiffness : N/m; natural_frequency : rad/s; mean_force : N.
    force_parameter : F_m/(k_m b0).
    stiffness : over its mean.
    shape : transmission error scaled so that its first harmonic has amplitude 1.
    error_amplitude : of the first harmonic of the error excitation over b0, for this state.
    reference_amplitude : the same for the reference case; it belongs to a relative mean error of 1.
    relative_mean_error : mean transmission error over that of the reference case.
    clearance : over b0.
    stiffest_phase : mesh phase at which the first harmonic of the stiffness is largest.
    bearings : pinion, gear and pressure_angle of the translational oscillator; none in the torsional model.
    """

    length: float
    mean_stiffness: float
    natural_frequency: float
    mean_force: float
    force_parameter: float
    stiffness: Harmonics | PeriodicTable
    shape: Harmonics | PeriodicTable
    error_amplitude: float
    reference_amplitude: float
    relative_mean_error: float
    clearance: Harmonics
    stiffest_phase: float
    bearings: Mapping[str, Bearing | float] = MappingProxyType({})

    def oscillator(
        self, settings: dict[str, Any], frequency: float, error_amplitude: float | None = None
    ) -> Oscillator:
        """Return the oscillator at a mesh frequency (over the natural one) and an error amplitude (over b0)."""
        amplitude = self.error_amplitude if error_amplitude is None else error_amplitude
        torque = settings["torque_fluctuation"]
        model = TranslationalOscillator if self.bearings else Oscillator
        return model(
            frequency=frequency,
            damping_ratio=settings["damping_ratio"],
            mean_force=self.force_parameter,
            stiffness=self.stiffness,
            error=self.shape.scaled(amplitude),
            clearance=self.clearance,
            torque=ExternalTorque(torque["frequency_ratio"], torque["amplitudes"], torque["phases"]).scaled(
                self.force_parameter
            ),
            **self.bearings,
        )


def excitation(
    geometry: xr.Dataset, state: Any, reference: Any, pinion_torque: float, settings: dict[str, Any]
) -> Excitation:
    """Return the excitation of one state.

    Parameters
    ----------
    geometry : dataset of the geometry stage.
    state, reference : datasets that hold `mesh_stiffness`, `effective_stiffness`, `transmission_error` and, for
        `state`, `backlash` and `initial_half_backlash`; `reference` is the pristine reference case.
    pinion_torque : N m.
    settings : the section `dynamics`.

    Notes
    -----
    A transmission error without a first harmonic (below 1e-12 m, as of the pristine pair without load) excites nothing;
    where it is that of the reference case, the amplitude of the state itself belongs to a relative error of 1.
    """
    phase, width = geometry["mesh_phase"].values, geometry["mesh_phase_width"].values
    length, force = float(state["initial_half_backlash"]), mesh_force(geometry, pinion_torque)
    which = "mesh_stiffness" if settings["stiffness"] == "nominal" else "effective_stiffness"
    stiffness, error = state[which].values, state["transmission_error"].values
    mean = mean_over_mesh(stiffness, width)
    cold = mean_over_mesh(reference["transmission_error"].values, width)
    ratio = mean_over_mesh(error, width) / cold if cold > _NO_ERROR else np.nan
    if settings["ste_amplitude"] != "harmonic" and not (cold > 0 and ratio > 0):
        raise Infeasible(
            f"the mean transmission error is {1e6 * mean_over_mesh(error, width):.4g} um, {1e6 * cold:.4g} um in the "
            f"reference case; dynamics.ste_amplitude {settings['ste_amplitude']} needs both above 0: give harmonic, or "
            "another transmission_error.heat"
        )
    own, unit = _amplitudes(settings["ste_amplitude"], error, reference, which, force, ratio, phase, width)
    first = harmonics(error, phase, width, 1)[0][0]
    if first <= _NO_ERROR:
        error, first, own = np.zeros_like(error), 1.0, 0.0
    if unit <= _NO_ERROR:
        unit = own
    if settings["harmonics"] == "full":
        double = geometry["leaving"].values >= 0
        relative_stiffness: Harmonics | PeriodicTable = _table(stiffness / mean, width, double)
        shape: Harmonics | PeriodicTable = _table(error / first, width, double)
    else:
        relative_stiffness = _sum(1.0, stiffness / mean, phase, width, settings["harmonics"])
        shape = _sum(0.0, error / first, phase, width, settings["harmonics"])
    clearance = state["backlash"].values / length
    count = 0
    if settings["clearance"] == "varying":
        count = _TABLE_CLEARANCE_HARMONICS if settings["harmonics"] == "full" else settings["harmonics"]
    return Excitation(
        length=length,
        mean_stiffness=mean,
        natural_frequency=float(np.sqrt(mean / float(geometry["equivalent_mass"]))),
        mean_force=force,
        force_parameter=force / (mean * length),
        stiffness=relative_stiffness,
        shape=shape,
        error_amplitude=own / length,
        reference_amplitude=unit / length,
        relative_mean_error=ratio,
        clearance=_sum(mean_over_mesh(clearance, width), clearance, phase, width, count),
        stiffest_phase=float(-harmonics(stiffness, phase, width, 1)[1][0] / (2 * np.pi) % 1.0),
        bearings=_bearings(geometry, mean, settings) if settings["model"] == "translational" else {},
    )


def _sum(mean: float, values: np.ndarray, phase: np.ndarray, width: np.ndarray, count: int) -> Harmonics:
    amplitudes, phases = harmonics(values, phase, width, count)
    return Harmonics(mean, tuple(amplitudes), tuple(phases))


def _bearings(geometry: xr.Dataset, mesh_stiffness: float, settings: dict[str, Any]) -> dict[str, Bearing | float]:
    """Return the bearings over the equivalent mass and the mean mesh stiffness (N/m), and the angle of the mesh."""
    found: dict[str, Bearing | float] = {"pressure_angle": float(geometry["working_pressure_angle"])}
    for i, name in enumerate(geometry["gear"].values):
        own = settings["bearings"][name]
        mass = float(geometry["mass"][i]) if own["mass"] is None else own["mass"]
        found[str(name)] = Bearing(
            mass / float(geometry["equivalent_mass"]),
            (own["stiffness_along"] / mesh_stiffness, own["stiffness_across"] / mesh_stiffness),
            own["damping_ratio"],
        )
    return found


def swept_oscillator(
    source: Excitation, sweep: str, value: float, settings: dict[str, Any], swept: dict[str, Any]
) -> Oscillator:
    """Return the oscillator at one value of a sweep.

    Parameters
    ----------
    source : excitation of the case.
    sweep : `mesh_frequency`, mesh over natural frequency; `ste`, mean transmission error over that of the reference
        case; `backlash`, mean half clearance over b0. The last two at the mesh frequency of their section.
    value : of the swept quantity.
    settings, swept : the section `dynamics` and the section of the sweep. `swept["reading"]` of the backlash sweep:
        `rescale`, the clearance is the unit of length, so that the error amplitude falls as the clearance grows while
        the force parameter and the clearance in this unit stay; `clearance`, the clearance alone changes.
    """
    if sweep == "mesh_frequency":
        return source.oscillator(settings, value)
    frequency = swept["mesh_frequency"]
    if sweep == "ste":
        return source.oscillator(settings, frequency, value * source.reference_amplitude)
    if swept["reading"] == "rescale":
        return source.oscillator(settings, frequency, source.reference_amplitude / value)
    return source.oscillator(settings, frequency).with_clearance_scaled(value / source.clearance.mean)


class SweptOscillator(NamedTuple):
    """The oscillator of one state as a function of a swept quantity.

    Attributes
    ----------
    source : excitation of the state.
    quantity : `mesh_frequency`, `ste` or `backlash`, as in swept_oscillator.
    dynamics : the section of that name.
    settings : the section of the sweep; a sweep over the mesh frequency needs none.
    """

    source: Excitation
    quantity: str
    dynamics: dict[str, Any]
    settings: dict[str, Any] = {}  # noqa: RUF012 (never written to)

    def at(self, value: float) -> Oscillator:
        """Return the oscillator at a value of the swept quantity."""
        return swept_oscillator(self.source, self.quantity, float(value), self.dynamics, self.settings)


def _amplitudes(
    meaning: str,
    error: np.ndarray,
    reference: Any,
    stiffness_name: str,
    force: float,
    ratio: float,
    phase: np.ndarray,
    width: np.ndarray,
) -> tuple[float, float]:
    """Return the error amplitude (m) of the state and that of the reference case.

    `nominal`: mean force over the mean stiffness of the reference case, times the relative mean error; `mean`: mean
    transmission error; `harmonic`: its first harmonic.
    """
    cold = reference["transmission_error"].values
    if meaning == "nominal":
        unit = force / mean_over_mesh(reference[stiffness_name].values, width)
        return ratio * unit, unit
    if meaning == "mean":
        return mean_over_mesh(error, width), mean_over_mesh(cold, width)
    return float(harmonics(error, phase, width, 1)[0][0]), float(harmonics(cold, phase, width, 1)[0][0])


def _table(values: np.ndarray, width: np.ndarray, double: np.ndarray) -> PeriodicTable:
    """Return the piecewise linear function through cell midpoints, continuous but for the changes of zone."""
    breaks = np.concatenate([[0.0], np.cumsum(width)])
    breaks[-1] = 1.0
    start, end = np.empty_like(values), np.empty_like(values)
    for zone in (double, ~double):
        y, w = values[zone], width[zone]
        inner = (y[:-1] * w[1:] + y[1:] * w[:-1]) / (w[:-1] + w[1:])
        start[zone] = np.concatenate([[2 * y[0] - inner[0]], inner])
        end[zone] = np.concatenate([inner, [2 * y[-1] - inner[-1]]])
    return PeriodicTable(tuple(breaks), tuple(start), tuple(end))


def restoring_force(oscillator: Oscillator, phase: np.ndarray, displacement: np.ndarray) -> np.ndarray:
    """Return k(tau) f(X; b(tau)), the mesh force over mean stiffness times b0.

    Parameters
    ----------
    phase : mesh phase, shape (n,).
    displacement : X at these phases, shape (..., n).
    """
    clearance = oscillator.clearance.at(phase)
    return oscillator.stiffness.at(phase) * (displacement - np.clip(displacement, -clearance, clearance))
