"""Involute geometry of the two gears."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from gearwear.errors import Infeasible

GEARS = ("pinion", "gear")


class GearPair(NamedTuple):
    """Dimensions of a spur gear pair; arrays of shape (2,) hold pinion and gear. Lengths in m, angles in rad."""

    teeth: np.ndarray
    module: float
    face_width: float
    pressure_angle: float
    working_pressure_angle: float
    centre_distance: float
    base_pitch: float
    reference_radius: np.ndarray
    base_radius: np.ndarray
    tip_radius: np.ndarray
    root_radius: np.ndarray
    bore_radius: np.ndarray
    tooth_thickness: np.ndarray
    base_half_angle: np.ndarray
    rack_root_angle: np.ndarray
    straight_root_angle: np.ndarray
    generated_root_angle: np.ndarray


def involute(angle: float | np.ndarray) -> np.ndarray:
    """Return tan(angle) - angle (rad)."""
    return np.tan(angle) - angle


def each(values: dict[str, Any]) -> np.ndarray:
    """Return the values of pinion and gear as an array of shape (2,)."""
    return np.array([values[name] for name in GEARS], dtype=float)


def gear_pair(
    teeth: dict[str, Any],
    module: float,
    face_width: float,
    pressure_angle: float,
    addendum_coefficient: dict[str, Any],
    clearance_coefficient: float,
    profile_shift: dict[str, Any],
    centre_distance: float | None,
    bore_radius: dict[str, Any],
) -> GearPair:
    """Return the dimensions of a gear pair cut by a basic rack (ISO 21771).

    Parameters
    ----------
    teeth, addendum_coefficient, profile_shift, bore_radius : {"pinion": .., "gear": ..}; radius in m.
    module, face_width : m.
    pressure_angle : of the rack, degrees.
    centre_distance : m; None means the distance at which the shifted gears mesh without backlash.

    Raises
    ------
    Infeasible : the gears cannot be made or cannot mesh; the message names quantity, value and limit.
    """
    z, shift = each(teeth), each(profile_shift)
    addendum, bore = each(addendum_coefficient), each(bore_radius)
    alpha = math.radians(pressure_angle)
    reference = module * z / 2
    base = reference * math.cos(alpha)
    working, centre = _working_angle(alpha, base, z, shift, centre_distance)
    tip = reference + (addendum + shift) * module
    root = reference - (addendum + clearance_coefficient - shift) * module
    thickness = module * (math.pi / 2 + 2 * shift * math.tan(alpha))
    half = thickness / (2 * reference) + involute(alpha)
    widest = (math.pi / 4 - (addendum + clearance_coefficient) * math.tan(alpha)) * math.cos(alpha)
    if widest.min() <= 0:
        raise Infeasible(
            f"gear_pair: a rack with addendum_coefficient + clearance_coefficient = "
            f"{(addendum + clearance_coefficient).max():g} is pointed at its tip; the sum must stay below "
            f"{math.pi / 4 / math.tan(alpha):.4f}"
        )
    # a full clearance is rounded; where that leaves no land at the tip of the rack, the tip is one arc
    rounding = np.minimum(clearance_coefficient, widest) / (1 - math.sin(alpha))
    flank = math.pi / 2 + 2 * rounding / math.cos(alpha)  # the shift moves the rack tooth, not its width at the tip
    pair = GearPair(
        teeth=z,
        module=module,
        face_width=face_width,
        pressure_angle=alpha,
        working_pressure_angle=working,
        centre_distance=centre,
        base_pitch=math.pi * module * math.cos(alpha),
        reference_radius=reference,
        base_radius=base,
        tip_radius=tip,
        root_radius=root,
        bore_radius=bore,
        tooth_thickness=thickness,
        base_half_angle=half,
        rack_root_angle=(flank + 2 * math.tan(alpha) * (addendum - rounding)) / z,
        straight_root_angle=np.arcsin(np.minimum(base * np.sin(half) / root, 1.0)),
        generated_root_angle=(flank + 2 * math.tan(alpha) * (addendum + clearance_coefficient - rounding)) / z,
    )
    _refuse_impossible(pair)
    return pair


def half_angle(pair: GearPair, radius: np.ndarray) -> np.ndarray:
    """Return half the angle of the tooth at `radius` (m), rad; radius has shape (2, ...)."""
    base, alone = pair.base_radius, pair.base_half_angle
    shape = (2,) + (1,) * (np.ndim(radius) - 1)
    pressure = np.arccos(np.minimum(base.reshape(shape) / radius, 1.0))
    return alone.reshape(shape) - involute(pressure)


def equivalent_mass(pair: GearPair, density: dict[str, Any], inertia: dict[str, Any]) -> tuple[np.ndarray, float]:
    """Return the moments of inertia (kg m2, shape (2,)) and the equivalent mass on the line of action (kg).

    A moment not given is that of a solid disc of the reference radius less the bore. Equivalent mass
    J_p J_g / (J_p r_bg^2 + J_g r_bp^2): Kahraman and Singh, J. Sound Vib. 142 (1990), Eq. 3.
    """
    disc = np.pi / 2 * each(density) * pair.face_width * (pair.reference_radius**4 - pair.bore_radius**4)
    given = [inertia[name] for name in GEARS]
    moments = np.array([own if one is None else one for one, own in zip(given, disc, strict=True)])
    r = pair.base_radius
    return moments, float(moments.prod() / (moments[0] * r[1] ** 2 + moments[1] * r[0] ** 2))


def disc_mass(pair: GearPair, density: dict[str, Any]) -> np.ndarray:
    """Return the masses of solid discs of the reference radii less the bores (kg, shape (2,))."""
    return np.pi * each(density) * pair.face_width * (pair.reference_radius**2 - pair.bore_radius**2)


def _working_angle(
    alpha: float | np.ndarray, base: np.ndarray, z: np.ndarray, shift: Any, centre_distance: Any
) -> tuple[float, float]:
    if centre_distance is None:
        target = involute(alpha) + 2 * math.tan(alpha) * shift.sum() / z.sum()
        if target <= 0:
            raise Infeasible(
                f"gear_pair.profile_shift: the sum {shift.sum():g} leaves no centre distance at which the gears "
                "mesh; use less negative shifts"
            )
        working = _inverse_involute(target)
        return working, float(base.sum() / math.cos(working))
    if centre_distance <= base.sum():
        raise Infeasible(
            f"gear_pair.centre_distance: {centre_distance:g} m is not above the sum of the base radii, "
            f"{base.sum():g} m; the gears cannot mesh"
        )
    return math.acos(base.sum() / centre_distance), float(centre_distance)


def _inverse_involute(target: float) -> float:
    angle = (3 * target) ** (1 / 3)
    for _ in range(60):
        step = (math.tan(angle) - angle - target) / math.tan(angle) ** 2
        angle -= step
        if abs(step) < 1e-15:
            break
    return angle


def _refuse_impossible(pair: GearPair) -> None:
    tip_thickness = 2 * pair.tip_radius * half_angle(pair, pair.tip_radius)
    working_radius = pair.base_radius / math.cos(pair.working_pressure_angle)
    thickness = 2 * working_radius * half_angle(pair, working_radius)
    pitch = 2 * math.pi * working_radius[0] / pair.teeth[0]
    if thickness.sum() > pitch * (1 + 1e-4):  # tabulated shifts are rounded to four digits
        raise Infeasible(
            f"gear_pair: the teeth jam, their thickness at the pitch circle {1e3 * thickness.sum():.4f} mm exceeds the "
            f"pitch {1e3 * pitch:.4f} mm; increase centre_distance or reduce profile_shift"
        )
    for i, name in enumerate(GEARS):
        if tip_thickness[i] <= 0:
            raise Infeasible(
                f"gear_pair: the tooth thickness at the tip of the {name} is {1e3 * tip_thickness[i]:.4f} mm, it must "
                "be positive; reduce addendum_coefficient or profile_shift"
            )
        if pair.bore_radius[i] >= pair.root_radius[i]:
            raise Infeasible(
                f"gear_pair.bore_radius.{name}: {1e3 * pair.bore_radius[i]:g} mm is not below the root radius "
                f"{1e3 * pair.root_radius[i]:g} mm"
            )
        gap = pair.centre_distance - pair.tip_radius[i] - pair.root_radius[1 - i]
        if gap <= 0:
            raise Infeasible(
                f"gear_pair: the tip of the {name} runs into the root of its mate by {-1e3 * gap:.4f} mm; "
                "reduce addendum_coefficient or increase clearance_coefficient or centre_distance"
            )
