"""Section of the configuration that describes the calibration."""

from typing import Any

from pydantic import create_model

from gearwear.config.key_types import Number, Section, Whole, quantity, target


def _span(name: str, unit: str, meaning: str, least: float, greatest: float) -> type[Section]:
    ends: dict[str, Any] = {
        end: (Number, quantity(unit, f"{which} value: {meaning}.", ge=least, le=greatest))
        for end, which in (("low", "Least"), ("high", "Greatest"))
    }
    return create_model(name, __base__=Section, __doc__="Range of a parameter.", **ends)


PinionTeeth = _span("PinionTeeth", "1", "teeth of the pinion", 6, 500)
ToothRatio = _span("ToothRatio", "1", "teeth of the gear over those of the pinion", 0.1, 10.0)
PinionBore = _span("PinionBore", "1", "bore radius of the pinion over its reference radius", 0.05, 0.9)
GearBore = _span("GearBore", "1", "bore radius of the gear over its reference radius", 0.05, 0.9)
LineLoad = _span("LineLoad", "N/m", "mean mesh force over the face width", 1e3, 1e7)
PitchSpeed = _span("PitchSpeed", "m/s", "speed of the reference circles", 0.1, 200.0)
DampingRatio = _span("DampingRatio", "1", "damping ratio", 1e-4, 0.99)
PressureViscosity = _span("PressureViscosity", "1/Pa", "pressure-viscosity coefficient", 1e-10, 1e-6)
CompositeRoughness = _span("CompositeRoughness", "m", "rms roughness of both flanks", 1e-8, 1e-5)
ShaftTemperatureDrop = _span("ShaftTemperatureDrop", "K", "how much cooler the shaft is", 0.0, 500.0)


class Calibration(Section):
    """Search of the parameters that the paper leaves open, made by `snakemake -j2 calibrate`."""

    pinion_teeth: PinionTeeth
    tooth_ratio: ToothRatio
    pinion_bore: PinionBore
    gear_bore: GearBore
    line_load: LineLoad
    pitch_speed: PitchSpeed
    damping_ratio: DampingRatio
    pressure_viscosity: PressureViscosity
    composite_roughness: CompositeRoughness
    shaft_temperature_drop: ShaftTemperatureDrop
    islands: Whole = target("Independent searches, one job each.", "1", ge=1, le=99)
    population: Whole = quantity("1", "Candidates of one generation.", ge=5, le=1000)
    generations: Whole = quantity("1", "Generations of one search.", ge=1, le=10_000)
    mesh_cells: Whole = quantity(
        "1", "grid.mesh_cells during a search; the best are computed with that of the study.", ge=16, le=20000
    )
    cycles_per_update: Number = quantity(
        "1", "wear.cycles_per_update during a search; the best are computed with that of the study.", gt=0.0, le=1e12
    )
    verified: Whole = quantity("1", "Best candidates that are computed in full.", ge=1, le=100)
