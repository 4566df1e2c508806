"""The parameters of a search, in the terms of a gear engineer, and the keys of the configuration that they set."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

# Name: unit and meaning.
PARAMETERS = {
    "pinion_teeth": ("1", "number of teeth of the pinion"),
    "tooth_ratio": ("1", "teeth of the gear over those of the pinion"),
    "pinion_bore": ("1", "bore radius of the pinion over its reference radius"),
    "gear_bore": ("1", "bore radius of the gear over its reference radius"),
    "line_load": ("N m-1", "mean mesh force over the face width"),
    "pitch_speed": ("m s-1", "speed of the reference circles"),
    "damping_ratio": ("1", "damping ratio"),
    "pressure_viscosity": ("Pa-1", "pressure-viscosity coefficient"),
    "composite_roughness": ("m", "rms roughness of both flanks"),
    "shaft_temperature_drop": ("K", "how much cooler the shaft is than the base circle"),
}
# What they make of the oscillator of case `with`.
OSCILLATOR = {
    "force_parameter": ("1", "mean force over mean stiffness and half backlash"),
    "stiffness_ripple": ("1", "first harmonic of the mesh stiffness over its mean"),
    "error_over_force": ("1", "error amplitude over the force parameter"),
    "error_lag": ("rad", "phase of the error behind antiphase to the stiffness"),
}
NAMES = tuple(PARAMETERS)


def ends(settings: Mapping[str, Any]) -> tuple[np.ndarray, np.ndarray]:
    """Return the least and the greatest values of the parameters, in the order of NAMES.

    Parameters
    ----------
    settings : the section `calibration`.
    """
    low, high = (np.array([settings[name][end] for name in NAMES]) for end in ("low", "high"))
    return low, high


def with_values(config: Mapping[str, Any], values: np.ndarray) -> dict[str, Any]:
    """Return the configuration with other values of the parameters.

    Parameters
    ----------
    config : sections `gear_pair`, `operation`, `lubricant`, `heat` and `dynamics` among others.
    values : (parameters,) in the order of NAMES: tooth numbers are rounded; the bores are radii over the reference
        radii; the line load is the mesh force over the face width; the pitch speed that of the reference circles.
    """
    own = dict(zip(NAMES, map(float, values), strict=True))
    pair = config["gear_pair"]
    pinion = round(own["pinion_teeth"])
    teeth = {"pinion": pinion, "gear": round(own["tooth_ratio"] * pinion)}
    radius = {name: pair["module"] * count / 2 for name, count in teeth.items()}
    base = radius["pinion"] * math.cos(math.radians(pair["pressure_angle"]))
    bores = {name: own[f"{name}_bore"] * radius[name] for name in teeth}
    operation = {
        "pinion_torque": own["line_load"] * pair["face_width"] * base,
        "pinion_speed": own["pitch_speed"] / radius["pinion"] * 30 / math.pi,
    }
    oil = {name: own[name] for name in ("pressure_viscosity", "composite_roughness")}
    return {
        **config,
        "gear_pair": {**pair, "teeth": teeth, "bore_radius": bores},
        "operation": {**config["operation"], **operation},
        "lubricant": {**config["lubricant"], **oil},
        "heat": {**config["heat"], "shaft_temperature_drop": own["shaft_temperature_drop"]},
        "dynamics": {**config["dynamics"], "damping_ratio": own["damping_ratio"]},
    }


def values_of(config: Mapping[str, Any]) -> np.ndarray:
    """Return the values of the parameters in a configuration, in the order of NAMES."""
    pair, teeth = config["gear_pair"], config["gear_pair"]["teeth"]
    radius = {name: pair["module"] * count / 2 for name, count in teeth.items()}
    base = radius["pinion"] * math.cos(math.radians(pair["pressure_angle"]))
    own = {
        "pinion_teeth": teeth["pinion"],
        "tooth_ratio": teeth["gear"] / teeth["pinion"],
        "pinion_bore": pair["bore_radius"]["pinion"] / radius["pinion"],
        "gear_bore": pair["bore_radius"]["gear"] / radius["gear"],
        "line_load": config["operation"]["pinion_torque"] / (pair["face_width"] * base),
        "pitch_speed": config["operation"]["pinion_speed"] * math.pi / 30 * radius["pinion"],
        "damping_ratio": config["dynamics"]["damping_ratio"],
        "pressure_viscosity": config["lubricant"]["pressure_viscosity"],
        "composite_roughness": config["lubricant"]["composite_roughness"],
        "shaft_temperature_drop": config["heat"]["shaft_temperature_drop"],
    }
    return np.array([own[name] for name in NAMES])
