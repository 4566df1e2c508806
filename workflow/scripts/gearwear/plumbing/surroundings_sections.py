"""Sections of the configuration that describe what surrounds the gears."""

from __future__ import annotations

from gearwear.plumbing.key_types import Number, Section, quantity


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
