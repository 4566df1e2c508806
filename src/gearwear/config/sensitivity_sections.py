"""Configuration of the model sensitivity."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import Field, create_model

from gearwear.config.key_types import Number, OrNull, ReadNumber, Section, quantity


def _ends(name: str, unit: str, what: str, **limits: Any) -> type[Section]:
    """Return the section of both ends of a parameter; unit and limits are those of its key."""
    low = (Number, quantity(unit, f"Low value of {what}.", **limits))
    high = (Number, quantity(unit, f"High value of {what}.", **limits))
    return create_model(name, __base__=Section, __doc__=f"Range of {what}.", low=low, high=high)


def _open_ends(name: str, unit: str, what: str, low: str, high: str, **limits: Any) -> type[Section]:
    """Return the section of both ends of a parameter that follow from its value when they are null."""
    kind = Annotated[Annotated[float, Field(**limits), ReadNumber] | None, OrNull]
    ends: dict[str, Any] = {
        end: (kind, quantity(unit, f"{end.capitalize()} value of {what}; null = {factor} of its value."))
        for end, factor in (("low", low), ("high", high))
    }
    return create_model(name, __base__=Section, __doc__=f"Range of {what}.", **ends)


_DampingRatio = _ends("DampingRatioEnds", "1", "dynamics.damping_ratio", ge=1e-4, lt=1.0)
_Torque = _open_ends("PinionTorqueEnds", "N m", "operation.pinion_torque", "0.8", "1.2", gt=0.0, le=1e7)
_Speed = _open_ends("PinionSpeedEnds", "rpm", "operation.pinion_speed", "2/3", "4/3", gt=0.0, le=2e5)
_PinionBore = _open_ends("PinionBoreRadiusEnds", "m", "gear_pair.bore_radius.pinion", "0.8", "1.25", ge=1e-4, le=5.0)
_GearBore = _open_ends("GearBoreRadiusEnds", "m", "gear_pair.bore_radius.gear", "0.8", "1.25", ge=1e-4, le=5.0)
_PressureViscosity = _ends("PressureViscosityEnds", "1/Pa", "lubricant.pressure_viscosity", ge=1e-9, le=1e-7)
_Roughness = _ends("CompositeRoughnessEnds", "m", "lubricant.composite_roughness", ge=1e-9, le=1e-4)
_ShaftDrop = _ends("ShaftTemperatureDropEnds", "K", "heat.shaft_temperature_drop", ge=0.0, le=200.0)
_HalfBacklash = _open_ends("HalfBacklashEnds", "m", "backlash.half_backlash", "0.5", "1.25", ge=1e-7, le=1e-2)


class Sensitivity(Section):
    """Ends of the parameters that the paper leaves open, each varied alone by `snakemake -j2 sensitivity`."""

    damping_ratio: _DampingRatio
    pinion_torque: _Torque
    pinion_speed: _Speed
    pinion_bore_radius: _PinionBore
    gear_bore_radius: _GearBore
    pressure_viscosity: _PressureViscosity
    composite_roughness: _Roughness
    shaft_temperature_drop: _ShaftDrop
    half_backlash: _HalfBacklash
