"""What another program needs of a case: the gears, and the mesh and the worn flanks at every wear cycle."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr

from gearwear.oscillator.harmonics import mean_over_mesh

_PAIR = (
    "teeth",
    "module",
    "face_width",
    "pressure_angle",
    "working_pressure_angle",
    "centre_distance",
    "reference_radius",
    "base_radius",
    "tip_radius",
    "root_radius",
    "bore_radius",
    "moment_of_inertia",
    "equivalent_mass",
    "contact_ratio",
    "pitch_point",
    "mesh_phase_width",
)
_STATE = (
    "running_cycles",
    "mesh_stiffness",
    "effective_stiffness",
    "transmission_error",
    "backlash",
    "wear_depth",
    "natural_frequency",
)


def handover(cfg: dict[str, Any], geometry: xr.Dataset, states: Sequence[xr.Dataset]) -> xr.Dataset:
    """Return the gears, and k(t), e(t), b(t) and wear(N, s) of every wear cycle.

    Parameters
    ----------
    cfg : the slice `handover`.
    states : wear, mesh stiffness, transmission error, backlash and response of every wear cycle, each as one dataset.
    """
    found = xr.concat([state[list(_STATE)] for state in states], "wear_cycle", coords="minimal", compat="override")
    found = found.merge(geometry[list(_PAIR)], compat="override", combine_attrs="drop")
    which = "mesh_stiffness" if cfg["dynamics"]["stiffness"] == "nominal" else "effective_stiffness"
    width = geometry["mesh_phase_width"].values
    mean = [mean_over_mesh(values, width) for values in found[which].transpose("wear_cycle", "mesh_phase").values]
    first = states[0]
    mesh_frequency = float(first["mesh_frequency_ratio"] * first["natural_frequency"])
    found = found.assign(mean_stiffness=("wear_cycle", mean), mean_force=first["mean_force"])
    return found.set_coords(["running_cycles", "mesh_phase_width"]).assign_coords(
        wear_cycle=np.arange(len(states), dtype=np.int32), mesh_time=geometry["mesh_phase"] * 2 * np.pi / mesh_frequency
    )
