"""Sections of the configuration that describe the gear pair, its load, its heat and its wear."""

from typing import Annotated, Literal

from pydantic import Field

from gearwear.config.types import (
    Both,
    Flag,
    Nullable,
    Number,
    OrOff,
    ReadNumber,
    ReadWhole,
    Section,
    Whole,
    choice,
    plain,
    quantity,
)

MOST_CYCLES = 10**12

Torque = Annotated[float, Field(gt=0.0, le=1e7), ReadNumber]
Speed = Annotated[float, Field(gt=0.0, le=2e5), ReadNumber]
BoreRadius = Annotated[float, Field(ge=1e-4, le=5.0), ReadNumber]
HalfBacklash = Annotated[float, Field(ge=1e-7, le=1e-2), ReadNumber]
PressureViscosity = Annotated[float, Field(ge=1e-9, le=1e-7), ReadNumber]
Roughness = Annotated[float, Field(ge=1e-9, le=1e-4), ReadNumber]
TemperatureDrop = Annotated[float, Field(ge=0.0, le=200.0), ReadNumber]
_Distance = Annotated[float, Field(ge=1e-3, le=20.0), ReadNumber]
_Inertia = Annotated[float, Field(gt=0.0, le=1e6), ReadNumber]
_Area = Annotated[float, Field(gt=0.0, le=1e4), ReadNumber]
_Teeth = Annotated[int, quantity("1", "Number of teeth; the pinion drives.", ge=6, le=500), ReadWhole]
_Addendum = Annotated[float, quantity("1", "Addendum over the module.", ge=0.3, le=1.6), ReadNumber]
_ProfileShift = Annotated[float, quantity("1", "Profile shift over the module.", ge=-1.5, le=2.0), ReadNumber]
_Immersion = Annotated[
    float, quantity("m", "Lowest point of the gear below the oil level; 0 = dry.", ge=0.0, le=10.0), ReadNumber
]
_Bore = Annotated[
    Nullable[BoreRadius], quantity("m", "Bore radius, at which the gear body is held; null = 0.45 of its root radius.")
]
_PolarInertia = Annotated[
    Nullable[_Inertia], quantity("kg m2", "Polar inertia; null = solid disc of the pitch radius less the bore.")
]


class GearPair(Section):
    """Macro geometry and inertia of the external spur gear pair."""

    teeth: Both[_Teeth]
    module: Number = quantity("m", "Normal module.", ge=1e-4, le=0.1)
    face_width: Number = quantity("m", "Common face width of both gears.", ge=1e-4, le=2.0)
    pressure_angle: Number = quantity("deg", "Pressure angle of the basic rack.", ge=10.0, le=35.0)
    addendum_coefficient: Both[_Addendum]
    clearance_coefficient: Number = quantity("1", "Tip clearance over the module.", ge=0.05, le=0.6)
    profile_shift: Both[_ProfileShift]
    centre_distance: Nullable[_Distance] = quantity(
        "m", "Working centre distance; null = the distance at which the flanks touch without backlash."
    )
    bore_radius: Both[_Bore]
    inertia: Both[_PolarInertia]


class Relief(Section):
    """Tip relief of one gear."""

    amount: Number = quantity("m", "Depth taken off at the tip, normal to the flank; 0 = none.", ge=0.0, le=1e-3)
    length: Number = quantity(
        "1",
        "Length along the path of contact over that of a double contact: 1 = long relief, 0.5 = short relief.",
        ge=0.01,
        le=2.0,
    )
    exponent: Number = quantity(
        "1", "Exponent of the depth over the distance from the start: 1 = linear, 2 = parabolic.", ge=1.0, le=4.0
    )


class MicroGeometry(Section):
    """Deviations of the new flanks from two perfect involutes."""

    tip_relief: Both[Relief]
    spacing_error: Number = quantity(
        "m",
        "Material that a pair lacks while it leaves and the next has entered, not before; below 0 = excess.",
        ge=-1e-3,
        le=1e-3,
    )
    base_pitch_difference: Number = quantity(
        "m",
        "Material that a pair lacks more with every base pitch along its path; below 0 = excess.",
        ge=-1e-3,
        le=1e-3,
    )


class Grid(Section):
    """Resolution along the path of contact and over the mesh period."""

    mesh_cells: Whole = quantity("1", "Cells of one mesh period.", ge=16, le=20000)


class Steel(Section):
    """Material of one gear at 20 degC."""

    youngs_modulus: Number = quantity("Pa", "Young's modulus at 20 degC.", ge=1e8, le=1e12)
    poisson_ratio: Number = quantity("1", "Poisson's ratio.", ge=0.0, lt=0.5)
    density: Number = quantity("kg/m3", "Density.", ge=500.0, le=25000.0)
    specific_heat: Number = quantity("J/(kg K)", "Specific heat capacity.", ge=50.0, le=5000.0)
    thermal_conductivity: Number = quantity("W/(m K)", "Thermal conductivity.", ge=0.05, le=1000.0)
    thermal_expansion: Number = quantity("1/K", "Linear thermal expansion; 0 = none.", ge=0.0, le=3e-4)


class Material(Both[Steel]):
    """Materials of both gears."""


class Elasticity(Section):
    """Young's modulus of the hot steel."""

    law: Literal["li", "linear", "table", "constant"] = choice(
        "Young's modulus over temperature",
        li="expansion and heat capacity of iron, scaled by calibration (form of Li et al. 2019)",
        linear="straight fall of 3.25e-4 per kelvin above 20 degC",
        table="interpolated values of carbon steel",
        constant="the value at 20 degC",
    )
    calibration: Number = quantity("1", "Factor K on the heat term of law li.", ge=0.0, le=20.0)


class Operation(Section):
    """Steady load and speed under which the flanks heat up and wear."""

    pinion_torque: Torque = quantity("N m", "Mean torque on the pinion.")
    pinion_speed: Speed = quantity("rpm", "Speed of the pinion.")


class Lubricant(Section):
    """Oil and surface roughness."""

    viscosity_law: Literal["fixed", "vogel"] = choice(
        "Viscosity over temperature",
        fixed="dynamic_viscosity at every temperature",
        vogel="through the values at 40 and 100 degC",
    )
    dynamic_viscosity: Number = quantity("Pa s", "Dynamic viscosity at 100 degC.", ge=1.1e-3, le=10.0)
    dynamic_viscosity_40: Number = quantity(
        "Pa s", "Dynamic viscosity at 40 degC, used by viscosity_law vogel.", ge=1.1e-3, le=100.0
    )
    pressure_viscosity: PressureViscosity = quantity("1/Pa", "Pressure-viscosity coefficient.")
    composite_roughness: Roughness = quantity("m", "Composite rms roughness of both flanks.")


class Friction(Section):
    """Friction of the flanks by lubrication regime."""

    law: Literal["load_sharing", "thresholds"] = choice(
        "Friction over the film ratio",
        load_sharing="continuous sharing of the load between film and asperities",
        thresholds="regimes dry, boundary, mixed and film parted at film ratios 0.4, 1 and 3",
    )
    dry: Number = quantity("1", "Friction coefficient of dry flanks.", gt=0.0, le=2.0)
    boundary: Number = quantity("1", "Friction coefficient of boundary lubrication.", gt=0.0, le=1.0)


class Heat(Section):
    """Contact temperature and thermal growth of the flanks."""

    initial_temperature: Number = quantity("degC", "Temperature without growth.", ge=-60.0, le=200.0)
    flash_coefficient: Number = quantity(
        "1", "Factor of the flash temperature, for parabolic heat flux and Hertz half width.", ge=0.0, le=2.0
    )
    temperature_rise: Literal["bulk", "contact"] = choice(
        "Rise above initial_temperature that makes the flanks grow",
        bulk="that of the bulk temperature",
        contact="that of the contact temperature, flash included",
    )
    shaft_temperature_drop: TemperatureDrop = quantity(
        "K", "Shaft below base circle; the shaft never falls below initial_temperature."
    )
    hub: Literal["free_bore", "solid_shaft"] = choice(
        "Restraint of the gear body", free_bore="bore and rim free of traction", solid_shaft="no bore"
    )
    growth: Literal["paper", "consistent", "eulerian"] = choice(
        "Thermal growth of the flank",
        paper="thickness from the angle as it stands in the paper, counts the radius twice",
        consistent="expanded tooth thickness on the expanded radius",
        eulerian="shift seen by the mating gear at a fixed place, shafts fixed",
    )


class HeatBalance(Section):
    """Mesh and churning losses against convection; decides the temperature of cases with bulk_temperature balance."""

    surroundings: Number = quantity(
        "degC", "Temperature of what carries the heat away: cooled oil, or air around the housing.", ge=-40.0, le=200.0
    )
    heat_transfer: Number = quantity("W/(m2 K)", "Coefficient of heat transfer to it.", gt=0.0, le=1e5)
    area: Nullable[_Area] = quantity(
        "m2", "Surface that gives off the heat; null = faces and tip cylinders of both gears."
    )
    immersion: Both[_Immersion]
    oil_volume: Number = quantity("m3", "Volume of the oil that the gears dip into.", gt=0.0, le=100.0)
    oil_density: Number = quantity("kg/m3", "Density of the oil.", ge=500.0, le=2000.0)


class MeshStiffness(Section):
    """Time-varying mesh stiffness by the energy method."""

    cantilever: Literal["base", "root"] = choice(
        "Circle on which the tooth is clamped", base="base circle", root="root circle"
    )
    fillet_angle: Literal["rack", "straight", "generated"] = choice(
        "Half angle of the tooth at the root circle",
        rack="the formula of the peers, which leaves out the clearance",
        straight="of a block of constant width below the base circle",
        generated="of the fillet that a rack with rounded tips generates",
    )
    hertz: Literal["linear", "weber"] = choice(
        "Contact stiffness of a tooth pair",
        linear="one constant value (Yang and Sun 1985)",
        weber="line contact of Weber, softer and dependent on the torque",
    )
    profile_changes: Annotated[Literal["paper", "exact", "off"], OrOff] = choice(
        "Effect of wear and growth on the tooth section",
        paper="terms D and H of the paper",
        exact="shift of the neutral axis and thickness of the section",
        off="none",
    )
    pairs: Literal["plain", "coupled"] = choice(
        "Two pairs in contact", plain="springs in parallel", coupled="joined by the common foundation"
    )
    foundation_coupling: Number = quantity(
        "1", "Part of the foundation compliance the other pair feels, used by pairs coupled.", ge=0.0, le=1.0
    )


class TransmissionError(Section):
    """Static transmission error and load sharing."""

    mode: Literal["loaded", "no_load"] = choice(
        "Static transmission error",
        loaded="elastic deflection included",
        no_load="profile errors only, deflection left to the mesh stiffness",
    )
    heat: Literal["relative", "none", "full_removed", "full_added"] = choice(
        "Thermal growth as a profile error",
        relative="growth missing to the most grown position of the path",
        none="left out",
        full_removed="whole growth, as material added to the flanks",
        full_added="whole growth with the opposite sign",
    )
    heat_in_load_sharing: Flag = plain("Whether thermal growth shifts load between the pairs; wear always does.")


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


class Backlash(Section):
    """Time-varying backlash."""

    half_backlash: Nullable[HalfBacklash] = quantity(
        "m", "Half the initial backlash on the line of action; null = half the least one of ISO/TR 10064-2."
    )
    projection: Literal["shi", "exact"] = choice(
        "Projection of wear, growth and deflection on the back side",
        shi="cosine of twice the pressure angle (after Shi et al. 2019)",
        exact="factor 1 of fixed shafts",
    )
    centre_distance_change: Number = quantity(
        "m", "Shafts farther apart than gear_pair.centre_distance says; seen by the backlash alone.", ge=-1e-3, le=1e-3
    )
    housing: Housing


class Wear(Section):
    """Wear of the flanks."""

    cycles_per_update: Whole = quantity(
        "1", "Pinion revolutions between two updates of the worn profile.", ge=1, le=MOST_CYCLES
    )
    law: Literal["janakiraman", "constant"] = choice(
        "Wear coefficient",
        janakiraman="regression in load, lubricant and roughness (Janakiraman et al. 2014)",
        constant="the key coefficient",
    )
    coefficient: Number = quantity("m2/N", "Wear coefficient of law constant; 0 = no wear.", ge=0.0, le=1e-9)
    force: Literal["dynamic", "quasi_static"] = choice(
        "Force in the wear law", dynamic="mesh force of the steady state", quasi_static="mean mesh force"
    )
    pressure: Literal["mean", "peak"] = choice(
        "Hertz pressure in the wear law", mean="mean, exact for a whole passage", peak="peak, 4/pi times it"
    )
    gear_cycles: Literal["tooth_ratio", "pinion"] = choice(
        "Cycles of a gear tooth",
        tooth_ratio="those of a pinion tooth times z_p/z_g",
        pinion="as many as a pinion tooth",
    )
