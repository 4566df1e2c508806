"""Compliance of one tooth as a cantilever: bending, shear and axial compression (energy method).

Angles: the load makes `load_angle` a1 with the normal to the tooth axis; a section is named by the angle a that
runs from -a1 at the contact point to the half angle a2 at the base circle. All lengths are divided by the base
radius, so that a compliance times E B is a pure number.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from gearwear.errors import Infeasible

POINTS = 32  # of the Gauss rule


class ToothCompliance(NamedTuple):
    """Compliances times E B (dimensionless), shape (n,) each."""

    bending: np.ndarray
    shear: np.ndarray
    axial: np.ndarray


def load_angle(
    radius_of_curvature: np.ndarray, base_radius: float | np.ndarray, base_half_angle: float | np.ndarray
) -> np.ndarray:
    """Return a1 = rho/r_b - a2 (rad): the roll angle of the contact less the half tooth angle on the base circle."""
    return radius_of_curvature / base_radius - base_half_angle


def tooth_compliance(
    load_angles: np.ndarray,
    base_half_angle: float,
    poisson_ratio: float,
    arm_change: np.ndarray | None = None,
    section_change: Callable[[np.ndarray], np.ndarray] | None = None,
    root_ratio: float | None = None,
    section_breaks: tuple[float, ...] = (),
    points: int = POINTS,
) -> ToothCompliance:
    """Return the compliances of a tooth clamped at the base circle, or at the root circle.

    Parameters
    ----------
    load_angles : a1 (rad), shape (n,).
    base_half_angle : a2 (rad).
    poisson_ratio : dimensionless.
    arm_change : D, change of the moment arm over r_b, shape (n,); None means none.
    section_change : function of the section angles (rad, shape (n, m)) that returns H, the change of the half
        thickness over r_b; None means none.
    root_ratio : r_f/r_b clamps the tooth at the root circle; None clamps it at the base circle.
    section_breaks : section angles (rad) where H jumps; the integrals are split there.
    points : of the Gauss rule on each part.

    Notes
    -----
    Integrals of Yang and Lin, J. Mech. Trans. Autom. Des. 109 (1987), in the angular form of Tian (2004); the root
    circle version after Liang, Zuo and Pandey, Mech. Mach. Theory 76 (2014): below the base circle a block of constant
    thickness is added where r_f < r_b, above it the integral ends at a5 = a2 - sqrt((r_f/r_b)^2 - 1).
    """
    a1, a2 = load_angles[:, None], base_half_angle
    arm = 0.0 if arm_change is None else arm_change[:, None]
    upper = a2
    if root_ratio is not None and root_ratio > 1:
        upper = a2 - np.sqrt(root_ratio**2 - 1)
    marks = np.broadcast_to(np.sort([*section_breaks, upper]), (len(load_angles), len(section_breaks) + 1))
    edges = np.concatenate([-a1, np.clip(marks, -a1, upper)], axis=1)
    half_range = np.diff(edges)[:, :, None] / 2
    nodes, rule = np.polynomial.legendre.leggauss(points)
    a = (edges[:, :-1, None] + half_range * (nodes + 1)).reshape(len(load_angles), -1)
    weights = (half_range * rule).reshape(a.shape)
    thickness = np.sin(a) + (a2 - a) * np.cos(a)
    if section_change is not None:
        thickness = thickness + section_change(a)
    if thickness.min() <= 0:
        raise Infeasible(
            f"the tooth is worn through: its half thickness falls to {thickness.min():.3f} of the base radius, it must "
            "stay above 0; lower wear.cycles_per_update, running_cycles or the load"
        )
    lever = 1 - arm + np.cos(a1) * ((a2 - a) * np.sin(a) - np.cos(a))
    advance = (a2 - a) * np.cos(a) * weights
    slice_area = (advance / thickness).sum(axis=1)
    bending = (1.5 * lever**2 * advance / thickness**3).sum(axis=1)
    cos1, sin1 = np.cos(load_angles), np.sin(load_angles)
    if root_ratio is not None and root_ratio < 1:
        foot = np.arcsin(np.sin(a2) / root_ratio)
        top, bottom = np.cos(a2), root_ratio * np.cos(foot)
        cut = 1.0 if arm_change is None else 1 - arm_change
        bending = bending + ((cut - cos1 * bottom) ** 3 - (cut - cos1 * top) ** 3) / (2 * cos1 * np.sin(a2) ** 3)
        slice_area = slice_area + (top - bottom) / np.sin(a2)
    return ToothCompliance(
        bending=bending,
        shear=1.2 * (1 + poisson_ratio) * cos1**2 * slice_area,
        axial=sin1**2 / 2 * slice_area,
    )
