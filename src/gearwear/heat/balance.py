"""Bulk temperature at which the losses of the gears equal the heat that leaves them: one scalar balance.

Gears and oil are one body of one temperature.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

from gearwear.contact.oil import dynamic_viscosity
from gearwear.errors import Infeasible

GRAVITY = 9.80665  # m/s2
_LAMINAR, _TURBULENT = 6000.0, 9000.0  # Reynolds numbers between which the two fits of churning are blended
_MEAN_OF_RMS = 0.8  # mean roughness over rms roughness, of a normal distribution of heights
_HOTTER = 1e4  # K above the surroundings; no balance is looked for beyond


class Gear(NamedTuple):
    """One gear as the oil sees it: m, m, m, rad/s, m of its tip circle below the oil."""

    tip_radius: float
    bore_radius: float
    face_width: float
    speed: float
    immersion: float


class HeatFlows(NamedTuple):
    """Heat that the gears set free by friction and in the oil, and heat that leaves them, W."""

    mesh_loss: float
    churning_loss: float
    convection: float


def heat_flows(
    geometry: Any,
    temperature: float,
    operation: dict[str, Any],
    lubricant: dict[str, Any],
    settings: dict[str, Any],
) -> HeatFlows:
    """Return the heat flows of gears at a bulk temperature.

    Parameters
    ----------
    geometry : dataset of the geometry stage, or its variables by name.
    temperature : degC.
    operation, lubricant, settings : the sections `operation`, `lubricant` and `heat_balance`.
    """

    def of(name: str) -> list[float]:
        return [float(geometry[name][i]) for i in range(2)]

    teeth, pitch_point = of("teeth"), float(geometry["pitch_point"])
    speed = 2 * math.pi * operation["pinion_speed"] / 60
    width, pitch = float(geometry["face_width"]), float(geometry["base_pitch"])
    viscosity, density = dynamic_viscosity(temperature, lubricant), settings["oil_density"]
    immersion = [settings["immersion"][name] for name in ("pinion", "gear")]
    speeds = (speed, speed * teeth[0] / teeth[1])
    gears = [
        Gear(*one) for one in zip(of("tip_radius"), of("bore_radius"), (width, width), speeds, immersion, strict=True)
    ]
    friction = mean_friction(
        operation["pinion_torque"] / (of("base_radius")[0] * width),
        2 * speed * pitch_point,
        pitch_point * (1 - pitch_point / float(geometry["line_of_action"])),
        viscosity,
        lubricant["composite_roughness"],
    )
    tips = (float(geometry["end_of_contact"]) - pitch_point, pitch_point - float(geometry["start_of_contact"]))
    factor = loss_factor(teeth[0], teeth[1] / teeth[0], tips[0] / pitch, tips[1] / pitch)
    churning = [one.speed * churning_torque(one, viscosity, density, settings["oil_volume"]) for one in gears]
    area = surface(gears) if settings["area"] is None else settings["area"]
    return HeatFlows(
        operation["pinion_torque"] * speed * friction * factor,
        sum(churning),
        settings["heat_transfer"] * area * (temperature - settings["surroundings"]),
    )


def loss_factor(teeth: float, ratio: float, pinion_tip: float, gear_tip: float) -> float:
    """Return the tooth loss factor H_v (1) of a spur pair: Ohlendorf (1958), as in Niemann and Winter.

    H_v = pi (u + 1)/(z_1 u) (1 - eps + eps_1^2 + eps_2^2), the mean sliding over the pitch line speed where each of two
    pairs carries half of the load and the pitch point lies in the single contact; where it does not, squares of
    negative lengths count negative.

    Parameters
    ----------
    teeth : of the pinion; ratio : u, teeth of the gear over those of the pinion.
    pinion_tip, gear_tip : eps_1 and eps_2, parts of the contact ratio eps from the pitch point to the tip of either.
    """
    lengths = (pinion_tip, gear_tip, 1 - pinion_tip, 1 - gear_tip)
    return math.pi * (ratio + 1) / (teeth * ratio) * sum(one * abs(one) for one in lengths) / 2


def mean_friction(load_per_width: float, sum_speed: float, radius: float, viscosity: float, roughness: float) -> float:
    """Return the mean coefficient of friction of the mesh: Schlenk (1994), ISO/TR 14179-2.

    mu = 0.048 (F'/(v_S R_e))^0.2 eta^-0.05 Ra^0.25, in N/mm, m/s, mm, mPa s and um, at the pitch point.

    Parameters
    ----------
    load_per_width : N/m; sum_speed : sum of the surface speeds, m/s; radius : effective, m; viscosity : Pa s.
    roughness : composite rms roughness of both flanks, m; Ra is the mean roughness of flanks alike and of normal
        heights.
    """
    mean_roughness = 1e6 * _MEAN_OF_RMS * roughness / math.sqrt(2)
    load = 1e-3 * load_per_width / (sum_speed * 1e3 * radius)
    return 0.048 * load**0.2 * (1e3 * viscosity) ** -0.05 * mean_roughness**0.25


def churning_torque(gear: Gear, viscosity: float, density: float, oil_volume: float) -> float:
    """Return the torque of a gear that dips into oil (N m): Changenet and Velex, J. Mech. Des. 129 (2007).

    C = rho w^2 R^3 S C_m/2 with the wetted surface S; Fr = w^2 R/g, Re = w R B/nu, D = 2 R, immersion h, oil volume V:
    C_m = 1.366 (h/D)^0.45 (V/D^3)^0.1 Fr^-0.6 Re^-0.21 below Re = 6000, 3.644 (h/D)^0.1 (V/D^3)^-0.35 Fr^-0.88
    (B/D)^0.85 above 9000; in between the two are blended in proportion to Re, which is our choice.

    Parameters
    ----------
    gear : R is its tip radius.
    viscosity : dynamic, Pa s; density : of the oil, kg/m3; oil_volume : m3.
    """
    radius, speed = gear.tip_radius, gear.speed
    depth = min(gear.immersion, 2 * radius)
    if depth <= 0 or speed == 0:
        return 0.0
    angle = math.acos(1 - depth / radius)  # half the arc below the oil
    wetted = 2 * radius**2 * (angle - math.sin(angle) * math.cos(angle)) + 2 * angle * radius * gear.face_width
    diameter = 2 * radius
    froude, reynolds = speed**2 * radius / GRAVITY, speed * radius * gear.face_width * density / viscosity
    dip, fill = depth / diameter, oil_volume / diameter**3
    slow = 1.366 * dip**0.45 * fill**0.1 * froude**-0.6 * reynolds**-0.21
    fast = 3.644 * dip**0.1 * fill**-0.35 * froude**-0.88 * (gear.face_width / diameter) ** 0.85
    blend = min(max((reynolds - _LAMINAR) / (_TURBULENT - _LAMINAR), 0.0), 1.0)
    return density / 2 * speed**2 * radius**3 * wetted * ((1 - blend) * slow + blend * fast)


def surface(gears: list[Gear]) -> float:
    """Return the surface of both gears (m2): their faces without the bore and their tip cylinders."""
    return sum(
        2 * math.pi * (one.tip_radius**2 - one.bore_radius**2 + one.tip_radius * one.face_width) for one in gears
    )


def balanced(flows: Callable[[float], HeatFlows], surroundings: float) -> float:
    """Return the temperature (degC) at which losses and convection are equal, by bisection to the last bit.

    Parameters
    ----------
    flows : of a temperature, degC.
    surroundings : temperature without losses, degC.

    Raises
    ------
    Infeasible : no balance within 10 000 K of the surroundings.
    """

    def surplus(temperature: float) -> float:
        found = flows(temperature)
        return found.mesh_loss + found.churning_loss - found.convection

    low, high = surroundings, surroundings + 1.0
    if surplus(low) <= 0:
        return low
    while surplus(high) > 0:
        low, high = high, surroundings + 2 * (high - surroundings)
        if high - surroundings > _HOTTER:
            raise Infeasible(f"no balance of heat below {low:.0f} degC")
    while True:
        middle = (low + high) / 2
        if not low < middle < high:
            return middle
        low, high = (middle, high) if surplus(middle) > 0 else (low, middle)
