"""Sections of the configuration that describe what surrounds the gears: housing, oil and cooling."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from gearwear.config.key_types import Number, OrNull, ReadNumber, Section, quantity

_Area = Annotated[float, Field(gt=0.0, le=1e4), ReadNumber]


class Housing(Section):
    """Growth of the housing, which moves the shafts apart."""

    thermal_expansion: Number = quantity("1/K", "Linear thermal expansion of the housing.", ge=0.0, le=3e-4)
    temperature_rise: Number = quantity(
        "1",
        "Rise of the housing over that of the gears, both above heat.initial_temperature; 0 = cold housing. Needs "
        "heat.growth eulerian.",
        ge=0.0,
        le=2.0,
    )


class Immersion(Section):
    """How deep the gears dip into the oil."""

    pinion: Number = quantity("m", "Lowest point of the pinion below the oil level; 0 = dry.", ge=0.0, le=10.0)
    gear: Number = quantity("m", "Lowest point of the gear below the oil level; 0 = dry.", ge=0.0, le=10.0)


class HeatBalance(Section):
    """Mesh and churning losses against convection; decides the temperature of cases with bulk_temperature balance."""

    surroundings: Number = quantity(
        "degC", "Temperature of what carries the heat away: cooled oil, or air around the housing.", ge=-40.0, le=200.0
    )
    heat_transfer: Number = quantity("W/(m2 K)", "Coefficient of heat transfer to it.", gt=0.0, le=1e5)
    area: Annotated[_Area | None, OrNull] = quantity(
        "m2", "Surface that gives off the heat; null = faces and tip cylinders of both gears."
    )
    immersion: Immersion
    oil_volume: Number = quantity("m3", "Volume of the oil that the gears dip into.", gt=0.0, le=100.0)
    oil_density: Number = quantity("kg/m3", "Density of the oil.", ge=500.0, le=2000.0)
