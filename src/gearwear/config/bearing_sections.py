"""Sections of the configuration that describe the bearings of the gears."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from gearwear.config.key_types import Number, OrNull, ReadNumber, Section, quantity

_Mass = Annotated[float, Field(ge=1e-6, le=1e6), ReadNumber]


class GearBearing(Section):
    """Bearing of one gear in model translational."""

    mass: Annotated[_Mass | None, OrNull] = quantity(
        "kg", "Mass that moves on it; null = disc of the pitch radius less the bore."
    )
    stiffness_along: Number = quantity("N/m", "Stiffness along the line of centres.", ge=1e3, le=1e13)
    stiffness_across: Number = quantity("N/m", "Stiffness across the line of centres.", ge=1e3, le=1e13)
    damping_ratio: Number = quantity("1", "Damping ratio of the mass on the bearing alone.", ge=0.0, lt=1.0)


class GearBearings(Section):
    """Bearings of both gears in model translational."""

    pinion: GearBearing
    gear: GearBearing
