"""Steady response at the running speed and the dynamic mesh force along the path of contact."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.geometry.kinematics import angular_speed
from gearwear.integrate.strobe import trace
from gearwear.io.store import together
from gearwear.motions.motion_variables import end_of
from gearwear.motions.settling import Settling, settle
from gearwear.motions.start import rest_state
from gearwear.oscillator.excitation import excitation, restoring_force
from gearwear.oscillator.periodic import Harmonics


def response(
    cfg: dict[str, Any],
    geometry: xr.Dataset,
    mesh_stiffness: xr.Dataset,
    transmission_error: xr.Dataset,
    backlash: xr.Dataset,
    reference_stiffness: xr.Dataset,
    reference_error: xr.Dataset,
) -> xr.Dataset:
    """Return the motion, its mesh force and the parameters of the oscillator.

    Parameters
    ----------
    cfg : the slice `response`.
    reference_stiffness, reference_error : of the pristine reference case.
    """
    dynamics, speed = cfg["dynamics"], cfg["operation"]["pinion_speed"]
    state = together([mesh_stiffness, transmission_error, backlash])
    reference = together([reference_stiffness, reference_error])
    source = excitation(geometry, state, reference, cfg["operation"]["pinion_torque"], dynamics)
    mesh_frequency = float(geometry["teeth"][0]) * angular_speed(geometry, speed)[0]
    ratio = mesh_frequency / source.natural_frequency
    oscillator = source.oscillator(dynamics, ratio)
    settling = Settling(**cfg["settling"])
    motion = settle(oscillator, rest_state(source, oscillator, dynamics), settling, dynamics["tolerance"])
    periods = motion.period or settling.sampled_periods
    reached = motion.transient_periods + settling.sampled_periods
    path_phase = geometry["path_phase"].values
    phases, node = np.unique(path_phase, return_inverse=True)
    displacement, velocity = (
        one[:, node] for one in trace(oscillator, end_of(motion), phases, periods, reached, dynamics["tolerance"])
    )
    # the last node of a zone belongs to the phase just before the jump of a tabulated stiffness and error, the motion
    # traced to the phase just after; displacement plus error is continuous
    last = np.append(np.diff(path_phase) <= 0, True)
    side = np.where(last, np.nextafter(path_phase, 0), path_phase)
    displacement = displacement + np.where(last, oscillator.error.jump(path_phase), 0.0)
    force = source.mean_stiffness * source.length * restoring_force(oscillator, side, displacement)
    along = ("response_period", "path")
    speed_unit = source.length * source.natural_frequency
    values = {
        "mesh_force": ("mesh_phase", force[:, geometry["entering"].values].mean(axis=0)),
        "mesh_force_path": (along, force),
        "displacement": (along, source.length * displacement),
        "velocity": (along, speed_unit * velocity),
        "mesh_frequency_ratio": ratio,
        "natural_frequency": source.natural_frequency,
        "mean_force": source.mean_force,
        "force_parameter": source.force_parameter,
        "relative_mean_error": source.relative_mean_error,
        "mean_clearance": source.clearance.mean,
        "error_amplitude": source.error_amplitude,
        "motion_class": np.int32(motion.motion_class),
        "lyapunov_exponent": motion.exponent,
        "contact_loss_share": motion.contact_loss_share,
    }
    if isinstance(source.stiffness, Harmonics) and isinstance(source.shape, Harmonics):
        values["stiffness_amplitude"] = ("harmonic", np.array(source.stiffness.amplitudes))
        values["stiffness_phase"] = ("harmonic", np.array(source.stiffness.phases))
        values["error_phase"] = ("harmonic", np.array(source.shape.phases))
        values["harmonic"] = ("harmonic", np.arange(1.0, len(source.stiffness.amplitudes) + 1))
    return xr.Dataset(values, {name: geometry[name] for name in ("path", "mesh_phase")})
