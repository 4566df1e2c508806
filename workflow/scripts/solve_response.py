"""Steady response at the running speed and the dynamic mesh force along the path of contact."""

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from gearwear.attractors.record import end_of
from gearwear.attractors.settling import Settling, settle
from gearwear.dynamics.excitation import excitation, rest_state, restoring_force
from gearwear.dynamics.motion import trace
from gearwear.dynamics.motion_class import class_name
from gearwear.dynamics.periodic import Harmonics
from gearwear.geometry.kinematics import angular_speed
from gearwear.plumbing import stage, store

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    cfg, geometry = job.params.cfg, store.load(job.input.geometry)
    dynamics, speed = cfg["dynamics"], cfg["operation"]["pinion_speed"]
    state, reference = store.mesh_states(job.input)
    source = excitation(geometry, state, reference, cfg["operation"]["pinion_torque"], dynamics)
    mesh_frequency = float(geometry["teeth"][0]) * angular_speed(geometry, speed)[0]
    ratio = mesh_frequency / source.natural_frequency
    oscillator = source.oscillator(dynamics, ratio)
    settling = Settling(**cfg["settling"])
    motion = settle(oscillator, rest_state(source, oscillator, dynamics), settling, dynamics["tolerance"])
    stage.log.info("mesh frequency ratio %.4f: %s", ratio, class_name(motion.motion_class))
    if not motion.motion_class:
        stage.announce(f"warning: {job.output[0]}: the motion did not settle; forces are those of the sampled periods")
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
    if isinstance(source.stiffness, Harmonics):
        values["stiffness_amplitude"] = ("harmonic", np.array(source.stiffness.amplitudes))
        values["stiffness_phase"] = ("harmonic", np.array(source.stiffness.phases))
        values["error_phase"] = ("harmonic", np.array(source.shape.phases))
        values["harmonic"] = ("harmonic", np.arange(1.0, len(source.stiffness.amplitudes) + 1))
    coords = {name: geometry[name] for name in ("path", "mesh_phase")}
    store.save(xr.Dataset(values, coords), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
