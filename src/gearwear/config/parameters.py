"""Names that the configuration and the stages share: swept quantities, and the parameters of the model sensitivity."""

SWEEPS = ("mesh_frequency", "ste", "backlash")
CASE_NAME = "[a-z][a-z0-9_]*"

OPTION, PARAMETER = "option", "parameter"  # groups of variations
ENDS = ("low", "high")

# Name in the section `sensitivity`: key of the configuration.
PLACES = {
    "damping_ratio": "dynamics.damping_ratio",
    "pinion_torque": "operation.pinion_torque",
    "pinion_speed": "operation.pinion_speed",
    "pinion_bore_radius": "gear_pair.bore_radius.pinion",
    "gear_bore_radius": "gear_pair.bore_radius.gear",
    "pressure_viscosity": "lubricant.pressure_viscosity",
    "composite_roughness": "lubricant.composite_roughness",
    "shaft_temperature_drop": "heat.shaft_temperature_drop",
    "half_backlash": "backlash.half_backlash",
}
