"""Sections of the configuration that describe the gear pair and its physics."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from gearwear.config.key_types import Flag, Number, OrNull, OrOff, ReadNumber, Section, Whole, choice, plain, quantity
from gearwear.config.surroundings_sections import Housing

_Distance = Annotated[float, Field(ge=1e-3, le=20.0), ReadNumber]
_Bore = Annotated[float, Field(ge=1e-4, le=5.0), ReadNumber]
_Clearance = Annotated[float, Field(ge=1e-7, le=1e-2), ReadNumber]
_Inertia = Annotated[float, Field(gt=0.0, le=1e6), ReadNumber]


class Teeth(Section):
    """Numbers of teeth."""

    pinion: Whole = quantity("1", "Number of teeth of the pinion, the driving gear.", ge=6, le=500)
    gear: Whole = quantity("1", "Number of teeth of the gear, the driven one.", ge=6, le=500)


class AddendumCoefficient(Section):
    """Addenda over the module."""

    pinion: Number = quantity("1", "Addendum of the pinion over the module.", ge=0.3, le=1.6)
    gear: Number = quantity("1", "Addendum of the gear over the module.", ge=0.3, le=1.6)


class ProfileShift(Section):
    """Profile shift coefficients."""

    pinion: Number = quantity("1", "Profile shift of the pinion over the module.", ge=-1.5, le=2.0)
    gear: Number = quantity("1", "Profile shift of the gear over the module.", ge=-1.5, le=2.0)


class BoreRadius(Section):
    """Radii of the bores."""

    pinion: Annotated[_Bore | None, OrNull] = quantity(
        "m", "Bore radius of the pinion, at which its body is held; null = 0.45 of its root radius."
    )
    gear: Annotated[_Bore | None, OrNull] = quantity(
        "m", "Bore radius of the gear, at which its body is held; null = 0.45 of its root radius."
    )


class Inertia(Section):
    """Polar moments of inertia."""

    pinion: Annotated[_Inertia | None, OrNull] = quantity(
        "kg m2", "Polar inertia of the pinion; null = solid disc of the pitch radius less the bore."
    )
    gear: Annotated[_Inertia | None, OrNull] = quantity(
        "kg m2", "Polar inertia of the gear; null = solid disc of the pitch radius less the bore."
    )


class GearPair(Section):
    """Macro geometry and inertia of the external spur gear pair."""

    teeth: Teeth
    module: Number = quantity("m", "Normal module.", ge=1e-4, le=0.1)
    face_width: Number = quantity("m", "Common face width of both gears.", ge=1e-4, le=2.0)
    pressure_angle: Number = quantity("deg", "Pressure angle of the basic rack.", ge=10.0, le=35.0)
    addendum_coefficient: AddendumCoefficient
    clearance_coefficient: Number = quantity("1", "Tip clearance over the module.", ge=0.05, le=0.6)
    profile_shift: ProfileShift
    centre_distance: Annotated[_Distance | None, OrNull] = quantity(
        "m", "Working centre distance; null = the distance at which the flanks touch without backlash."
    )
    bore_radius: BoreRadius
    inertia: Inertia


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


class Material(Section):
    """Materials of both gears."""

    pinion: Steel
    gear: Steel


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

    pinion_torque: Number = quantity("N m", "Mean torque on the pinion.", gt=0.0, le=1e7)
    pinion_speed: Number = quantity("rpm", "Speed of the pinion.", gt=0.0, le=2e5)


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
    pressure_viscosity: Number = quantity("1/Pa", "Pressure-viscosity coefficient.", ge=1e-9, le=1e-7)
    composite_roughness: Number = quantity("m", "Composite rms roughness of both flanks.", ge=1e-9, le=1e-4)


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
        "1",
        "Factor of the flash temperature, for parabolic heat flux and Hertz half width.",
        ge=0.0,
        le=2.0,
    )
    temperature_rise: Literal["bulk", "contact"] = choice(
        "Rise above initial_temperature that makes the flanks grow",
        bulk="that of the bulk temperature",
        contact="that of the contact temperature, flash included",
    )
    shaft_temperature_drop: Number = quantity(
        "K",
        "Shaft below base circle; the shaft never falls below initial_temperature.",
        ge=0.0,
        le=200.0,
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
        "Two pairs in contact",
        plain="springs in parallel",
        coupled="joined by the common foundation",
    )
    foundation_coupling: Number = quantity(
        "1",
        "Part of the foundation compliance the other pair feels, used by pairs coupled.",
        ge=0.0,
        le=1.0,
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


class Backlash(Section):
    """Time-varying backlash."""

    half_backlash: Annotated[_Clearance | None, OrNull] = quantity(
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
