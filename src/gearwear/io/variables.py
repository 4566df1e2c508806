"""The table of every variable in the result files: unit, name and dimensions."""

from __future__ import annotations

from typing import NamedTuple

from gearwear.codes import motion_class
from gearwear.codes.branch_codes import BRANCH_ENDS, SPECIAL_POINTS, STABILITY
from gearwear.codes.onset_codes import HOW
from gearwear.config.calibration_parameters import OSCILLATOR, PARAMETERS
from gearwear.errors import BadFile

MOTION_CLASSES = dict(zip(motion_class.FLAG_MEANINGS, motion_class.FLAG_VALUES, strict=True))
CONFLICTS = dict(zip(motion_class.CONFLICT_MEANINGS, motion_class.CONFLICT_VALUES, strict=True))
REASONS = dict(zip(motion_class.REASON_MEANINGS, motion_class.REASON_VALUES, strict=True))


WEAR_CYCLE = "wear_cycle"
_AXES = (WEAR_CYCLE, "member")


class Field(NamedTuple):
    """Entry of one variable: unit (empty for flags), name, allowed dimensions, CF flags, may hold nan."""

    units: str
    long_name: str
    dims: tuple[tuple[str, ...], ...]
    flags: dict[str, int] | None = None
    may_be_missing: bool = False


_SCALAR, _GEAR = ((),), (("gear",),)
_PATH, _BOTH = (("path",),), (("gear", "path"),)
_ROW, _COLUMN, _PLANE = (("row",),), (("column",),), (("row", "column"),)
_HARMONIC, _CELL = (("harmonic",),), (("cell",),)
_PHASE, _POINT = (("mesh_phase",),), (("point",), ())
_MEMBER, _EVENT, _MEMBERS = (("member",),), (("event",),), (("member", "event"),)
_EVENTS = _EVENT + (("variant", "event"), ("case", "event"))
_STATE = (("case",), ())
_NODE, _BRANCH = (("node",),), (("branch",),)
_ATTRACTOR = (("point", "attractor"),)
_MOTION, _SECTION = (*_POINT, *_ATTRACTOR, ("order", "point")), (("point", "sample"), ("point", "attractor", "sample"))


def field_of(name: str, dims: tuple[str, ...]) -> Field:
    """Return the entry of a variable; a swept coordinate may share its name with a quantity of the mesh.

    The axes along which whole states or outcomes are lined up may come before the dimensions of the entry: wear cycles,
    members of a study, and the keys of its grid, which are axes by their dotted names.

    Raises
    ------
    BadFile : no such variable, or other dimensions than the table allows.
    """
    if "." in name:
        return _of_key(name, dims)
    own = dims
    while True:
        for field in (FIELDS.get(f"swept {name}"), FIELDS.get(name)):
            if field is not None and own in field.dims:
                return field
        if not own or not (own[0] in _AXES or "." in own[0]):
            break
        own = own[1:]
    if name not in FIELDS:
        raise BadFile(f"{name}: no entry in the table of fields")
    raise BadFile(f"{name}: dimensions {dims}, expected one of {FIELDS[name].dims}")


def _of_key(key: str, dims: tuple[str, ...]) -> Field:
    """Return the entry of a key of the configuration as an axis of a study."""
    from gearwear.config.declared import declared_at  # slow to import, and few files have such axes

    declared = declared_at(key)
    if declared is None or dims != (key,):
        raise BadFile(f"{key}: dimensions {dims}, expected a key of the configuration along itself")
    return Field(declared.unit, declared.meaning, ((key,),))


FIELDS: dict[str, Field] = {
    # coordinates
    "gear": Field("", "member of the gear pair", _GEAR),
    "path": Field("m", "distance of the contact from the base tangent point of the pinion", _PATH),
    "mesh_phase": Field("1", "part of the mesh period since a pair entered", _PHASE),
    "pair": Field("", "pair in contact", (("pair",),)),
    "influence": Field("", "quantity raised by ten per cent", (("influence",),)),
    WEAR_CYCLE: Field("1", "updates of the worn profile so far", ((WEAR_CYCLE,),)),
    "harmonic": Field("1", "order of the mesh frequency", (("harmonic",),)),
    "reference_mesh_stiffness": Field("N m-1", "mesh stiffness of the reference case", _PHASE),
    "reference_effective_stiffness": Field("N m-1", "effective stiffness of the reference case", _PHASE),
    "reference_transmission_error": Field("m", "transmission error of the reference case", _PHASE),
    "mesh_time": Field("s", "time since a pair entered, at the running speed", _PHASE),
    "bearing_direction": Field("", "direction against the line of centres", (("bearing_direction",),)),
    "bearing_mass": Field("1", "mass that moves on the bearing over equivalent mass of the pair", _GEAR),
    "bearing_stiffness": Field("1", "bearing stiffness over mean mesh stiffness", (("gear", "bearing_direction"),)),
    "bearing_damping_ratio": Field("1", "damping ratio of the mass on the bearing alone", _GEAR),
    # geometry
    "teeth": Field("1", "number of teeth", _GEAR),
    "module": Field("m", "module", _SCALAR),
    "face_width": Field("m", "face width", _SCALAR),
    "pressure_angle": Field("rad", "pressure angle of the basic rack", _SCALAR),
    "working_pressure_angle": Field("rad", "working pressure angle", _SCALAR),
    "centre_distance": Field("m", "centre distance", _SCALAR),
    "base_pitch": Field("m", "base pitch", _SCALAR),
    "reference_radius": Field("m", "reference radius", _GEAR),
    "base_radius": Field("m", "base radius", _GEAR),
    "tip_radius": Field("m", "tip radius", _GEAR),
    "root_radius": Field("m", "root radius", _GEAR),
    "bore_radius": Field("m", "bore radius", _GEAR),
    "tooth_thickness": Field("m", "tooth thickness on the reference circle", _GEAR),
    "base_half_angle": Field("rad", "half tooth angle on the base circle", _GEAR),
    "rack_root_angle": Field("rad", "half tooth angle on the root circle, rack formula of the peers", _GEAR),
    "straight_root_angle": Field("rad", "half tooth angle on the root circle, straight root", _GEAR),
    "generated_root_angle": Field("rad", "half tooth angle on the root circle, generated fillet", _GEAR),
    "mass": Field("kg", "mass of a disc of the reference radius less the bore", _GEAR),
    "moment_of_inertia": Field("kg m2", "polar moment of inertia", _GEAR),
    "equivalent_mass": Field("kg", "equivalent mass on the line of action", _SCALAR),
    "line_of_action": Field("m", "distance between the base tangent points", _SCALAR),
    "start_of_contact": Field("m", "path position at the start of contact", _SCALAR),
    "lowest_single_contact": Field("m", "path position where single contact begins", _SCALAR),
    "pitch_point": Field("m", "path position of the pitch point", _SCALAR),
    "highest_single_contact": Field("m", "path position where single contact ends", _SCALAR),
    "end_of_contact": Field("m", "path position at the end of contact", _SCALAR),
    "contact_ratio": Field("1", "contact ratio", _SCALAR),
    "path_phase": Field("1", "mesh phase when the pair is at this position", _PATH),
    "partner": Field("", "index of the path node of the other pair, -1 for none", _PATH),
    "mesh_phase_width": Field("1", "width of the cell of the mesh phase", _PHASE),
    "entering": Field("", "index of the path node of the entering pair", _PHASE),
    "leaving": Field("", "index of the path node of the leaving pair, -1 for none", _PHASE),
    "tip_relief": Field("m", "depth relieved from the flank", _BOTH),
    "spacing": Field("m", "material that the pair lacks by the spacing of successive pairs", _PATH),
    # temperature
    "contact_temperature": Field("degC", "tooth contact temperature", _PATH),
    "flash_temperature": Field("K", "flash temperature rise", _PATH),
    "friction_coefficient": Field("1", "coefficient of friction", _PATH),
    "film_ratio": Field("1", "smallest film thickness over composite roughness", _PATH),
    "hertz_half_width": Field("m", "half width of the Hertz contact", _PATH),
    "load_per_width": Field("N m-1", "load of the pair per face width", _PATH),
    "surface_speed": Field("m s-1", "speed of the flank through the contact", _BOTH),
    "flash_sensitivity": Field("1", "largest flash temperature over its base value", (("influence",),)),
    "mesh_loss": Field("W", "heat set free by the friction of the teeth", _SCALAR),
    "churning_loss": Field("W", "heat set free by the gears in the oil", _SCALAR),
    "convection": Field("W", "heat given off at the bulk temperature", _SCALAR),
    # deformation
    "thermal_growth": Field("m", "thermal growth of one flank along the line of action", _BOTH),
    "thermal_growth_flash": Field("m", "growth added if the whole tooth had the flash temperature rise", _BOTH),
    "involute_error": Field("m", "distance of the hot flank from the hot involute, negative outside", _BOTH),
    "base_circle_growth": Field("m", "radial thermal growth of the base circle", _GEAR),
    # wear
    "wear_depth": Field("m", "wear depth normal to the flank", _BOTH),
    "wear_per_revolution": Field("m", "wear depth added per revolution of the pinion in the last block", _BOTH),
    "running_cycles": Field("1", "revolutions of the pinion so far", _SCALAR + _ROW),
    # mesh stiffness
    "mesh_stiffness": Field("N m-1", "mesh stiffness", _PHASE),
    "pair_stiffness": Field("N m-1", "stiffness of one tooth pair", _PATH),
    "pair_coupling": Field("m N-1", "deflection of a pair under unit load on the other pair", _PATH),
    "hertz_compliance": Field("m N-1", "compliance of the Hertz contact", _PATH),
    "bending_compliance": Field("m N-1", "compliance of the tooth in bending", _BOTH),
    "shear_compliance": Field("m N-1", "compliance of the tooth in shear", _BOTH),
    "axial_compliance": Field("m N-1", "compliance of the tooth in axial compression", _BOTH),
    "foundation_compliance": Field("m N-1", "compliance of the gear body", _BOTH),
    "youngs_modulus": Field("Pa", "modulus of elasticity at the bulk temperature", _GEAR),
    # transmission error and load sharing
    "transmission_error": Field("m", "loaded static transmission error", _PHASE),
    "load_sharing_factor": Field("1", "part of the mesh force on the pair", (("mesh_phase", "pair"),)),
    "load_share_path": Field("1", "part of the mesh force on the pair at this position", _PATH),
    "elastic_deflection": Field("m", "elastic deflection of the pair", _PATH),
    "effective_stiffness": Field("N m-1", "mesh force over the deflection of the better pair", _PHASE),
    "profile_error": Field("m", "material that the pair lacks, by manufacture, wear and heat", _PATH),
    "sharing_error": Field("m", "material that the pair lacks as load sharing sees it", _PATH),
    # backlash
    "backlash": Field("m", "half clearance of the entering pair", _PHASE),
    "backlash_path": Field("m", "half clearance along the path of one pair", _PATH),
    "initial_half_backlash": Field("m", "half clearance of the cold, unworn, unloaded pair", _SCALAR),
    "centre_distance_change": Field("m", "change of the centre distance by mounting and housing", _SCALAR),
    # response
    "mesh_force": Field("N", "dynamic mesh force, mean over the sampled periods", _PHASE),
    "mesh_force_path": Field(
        "N", "dynamic mesh force when the pair is at this position", (("response_period", "path"),)
    ),
    "displacement": Field(
        "m", "displacement along the line of action less the transmission error", (("response_period", "path"),)
    ),
    "velocity": Field("m s-1", "rate of change of the displacement", (("response_period", "path"),)),
    "mesh_frequency_ratio": Field("1", "mesh frequency over natural frequency", _SCALAR),
    "natural_frequency": Field("rad s-1", "natural frequency of the linear mesh", _SCALAR),
    "mean_force": Field("N", "mean mesh force", _SCALAR),
    "force_parameter": Field("1", "mean mesh force over mean stiffness times initial half backlash", _SCALAR),
    "error_amplitude": Field("1", "first harmonic of the error excitation over initial half backlash", _SCALAR),
    "error_phase": Field("rad", "phase of the error excitation, zero at pair entry", (("harmonic",),)),
    "stiffness_amplitude": Field("1", "amplitude of the stiffness over its mean", (("harmonic",),)),
    "stiffness_phase": Field("rad", "phase of the stiffness, zero at pair entry", (("harmonic",),)),
    "mean_clearance": Field("1", "mean half clearance over initial half backlash", _SCALAR),
    "relative_mean_error": Field(
        "1", "mean transmission error over that of the reference case, if this has one", _SCALAR + _STATE, None, True
    ),
    # excitation
    "reference_error_amplitude": Field("1", "error amplitude that belongs to a relative mean error of 1", _SCALAR),
    "stiffest_phase": Field("1", "mesh phase at which the first harmonic of the stiffness is largest", _SCALAR),
    "error_shape_amplitude": Field("1", "amplitude of the error excitation over error_amplitude", _HARMONIC),
    "error_shape_phase": Field("rad", "phase of the error excitation, zero at pair entry", _HARMONIC),
    "clearance_amplitude": Field("1", "amplitude of the half clearance over initial half backlash", _HARMONIC),
    "clearance_phase": Field("rad", "phase of the half clearance, zero at pair entry", _HARMONIC),
    "cell_edge": Field("1", "mesh phase where a cell of the tables begins or ends", (("cell_edge",),)),
    "stiffness_at_cell_start": Field("1", "stiffness over its mean at the start of the cell", _CELL),
    "stiffness_at_cell_end": Field("1", "stiffness over its mean at the end of the cell", _CELL),
    "error_shape_at_cell_start": Field("1", "error excitation over error_amplitude at the start of the cell", _CELL),
    "error_shape_at_cell_end": Field("1", "error excitation over error_amplitude at the end of the cell", _CELL),
    # sweeps, portraits and basins
    "mesh_frequency": Field("1", "mesh frequency over natural frequency", _POINT + _NODE + _COLUMN),
    "ste": Field("1", "mean static transmission error over that of the reference case", _POINT + _NODE + _ROW),
    "swept backlash": Field("1", "mean half clearance over its initial value", _POINT + _NODE + _ROW),
    "section_displacement": Field("1", "displacement at mesh phase 0 over initial half backlash", _SECTION, None, True),
    "section_velocity": Field("1", "velocity at mesh phase 0 in units of initial half backlash", _SECTION, None, True),
    "motion_class": Field("", "class of the motion", _MOTION + _PLANE, MOTION_CLASSES),
    "period": Field("1", "mesh periods after which the motion repeats, 0 if it does not", _MOTION + _PLANE),
    "conflict": Field("", "what speaks against the class", _MOTION + _PLANE, CONFLICTS),
    "recurrence_period": Field("1", "mesh periods after which the section recurs, 0 if it does not", _MOTION),
    "stable_orbit_period": Field("1", "mesh periods of the stable orbit next to the section, 0 for none", _MOTION),
    "stable_orbit_distance": Field("1", "distance of the section from that orbit", _MOTION, None, True),
    "recurrence_distance": Field("1", "distance of the section from its repetition", _MOTION, None, True),
    "lyapunov_exponent": Field(
        "1", "largest Lyapunov exponent per unit of dimensionless time", _MOTION + _PLANE, None, True
    ),
    "lyapunov_exponent_error": Field(
        "1", "standard error of the largest Lyapunov exponent", _MOTION + _PLANE, None, True
    ),
    "determinant_error": Field(
        "1", "relative departure of the area contraction of the map from its exact value", _MOTION, None, True
    ),
    "multiplier_real": Field("1", "real part of the largest Floquet multiplier", _MOTION, None, True),
    "multiplier_imag": Field("1", "imaginary part of the largest Floquet multiplier", _MOTION, None, True),
    "contact_loss_share": Field("1", "part of the time out of contact", _MOTION + _PLANE, None, True),
    "impacts_per_period": Field("1", "contacts made anew per mesh period", _MOTION, None, True),
    "displacement_min": Field("1", "smallest displacement over initial half backlash", _MOTION, None, True),
    "displacement_max": Field("1", "largest displacement over initial half backlash", _MOTION, None, True),
    "force_max": Field("1", "largest mesh force over mean mesh force", _MOTION + _PLANE, None, True),
    "transient_periods": Field("1", "mesh periods left out before the section", _MOTION + _PLANE),
    "reason": Field("", "why the class is not decided", _MOTION + _PLANE, REASONS),
    # basins of attraction
    "initial_displacement": Field("1", "initial displacement over initial half backlash", (("displacement_cell",),)),
    "initial_velocity": Field("1", "initial velocity in units of initial half backlash", (("velocity_cell",),)),
    "basin": Field(
        "",
        "index of the attractor that the motion from this cell settles to, -1 if undecided",
        (("point", "displacement_cell", "velocity_cell"),),
    ),
    "attractors": Field("1", "number of attractors found", _POINT),
    "share": Field("1", "part of the cells that lead to the attractor", _ATTRACTOR, None, True),
    "share_error": Field("1", "standard error of the share, cells taken as independent draws", _ATTRACTOR, None, True),
    "escaped_share": Field(
        "1", "part of the chaotic motions watched that became periodic in the end", _ATTRACTOR, None, True
    ),
    "undecided_share": Field("1", "part of the cells whose motion is not decided", _POINT),
    # portraits
    "orbit_displacement": Field(
        "1", "displacement along the orbit over initial half backlash", (("point", "time"),), None, True
    ),
    "orbit_velocity": Field(
        "1", "velocity along the orbit in units of initial half backlash", (("point", "time"),), None, True
    ),
    "orbit_force": Field("1", "mesh force along the orbit over mean mesh force", (("point", "time"),), None, True),
    "orbit_period": Field("1", "mesh periods since the orbit began", (("time",),)),
    # maps
    "bulk_temperature": Field("degC", "bulk temperature of both gears", _ROW),
    # branches of periodic orbits
    "branch_index": Field("", "index of the branch that the orbit is on", _NODE),
    "branch_displacement": Field(
        "1", "displacement at mesh phase 0 over initial half backlash", (("node", "iterate"),), None, True
    ),
    "branch_velocity": Field(
        "1", "velocity at mesh phase 0 in units of initial half backlash", (("node", "iterate"),), None, True
    ),
    "floquet_real": Field("1", "real part of the Floquet multipliers over the period", (("node", "multiplier"),)),
    "floquet_imag": Field("1", "imaginary part of the Floquet multipliers", (("node", "multiplier"),)),
    "stable": Field("", "whether all Floquet multipliers are inside the unit circle", _NODE, STABILITY),
    "special_point": Field("", "kind of the bifurcation at this orbit", _NODE, SPECIAL_POINTS),
    "branch_period": Field("1", "mesh periods after which the orbits of the branch repeat", _BRANCH),
    "branch_parent": Field("", "index of the branch that it was found on, -1 if in a sweep", _BRANCH),
    "branch_start": Field("", "why the branch goes no further before its first orbit", _BRANCH, BRANCH_ENDS),
    "branch_end": Field("", "why the branch goes no further after its last orbit", _BRANCH, BRANCH_ENDS),
    "branch_start_remark": Field("", "the same in words, with the last good point", _BRANCH),
    "branch_end_remark": Field("", "the same in words, with the last good point", _BRANCH),
    # onsets of doublings and of chaos
    "event": Field("", "event on the route to chaos", _EVENT),
    "variant": Field("", "way of computing the events", (("variant",),)),
    "error": Field("", "contribution to the numerical error", (("error",),)),
    "member": Field("", "member of the study", _MEMBER),
    "parameter": Field("", "parameter varied over the ensemble", (("parameter",),)),
    "onset": Field("1", "mesh frequency over natural frequency at the event", _EVENTS, None, True),
    "onset_seen": Field("1", "mesh frequency where the sweep shows the event", _EVENTS, None, True),
    "onset_how": Field("", "how the sweep meets the event", _EVENTS, HOW),
    "onset_resolution": Field("1", "how far below the onset the event may lie", _EVENTS, None, True),
    "onset_remark": Field("", "the same in words", _EVENTS),
    "onset_without": Field("1", "onset in case without", _EVENT, None, True),
    "onset_with": Field("1", "onset in case with", _EVENT, None, True),
    "onset_shift": Field("1", "onset in case with less that in case without", _EVENT, None, True),
    "variant_shift": Field("1", "shift of the event where the sweeps show it", (("variant", "event"),), None, True),
    "shift_error": Field(
        "1",
        "numerical error: distance of other ways from the shift, parts from the usual sweep",
        (("error", "event"),),
        None,
        True,
    ),
    "factor": Field("1", "factor on the value of the study", (("member", "parameter"),)),
    "member_shift": Field("1", "shift of the onset", _MEMBERS, None, True),
    "member_onset_without": Field("1", "onset in case without", _MEMBERS, None, True),
    "member_onset_with": Field("1", "onset in case with", _MEMBERS, None, True),
    "member_how_without": Field("", "how the sweep of case without meets the event", _MEMBERS, HOW),
    "member_how_with": Field("", "how the sweep of case with meets the event", _MEMBERS, HOW),
    "member_remark_without": Field("", "the same in words", _MEMBERS),
    "member_remark_with": Field("", "the same in words", _MEMBERS),
    # sensitivity of the model
    "case": Field("", "state of temperature and wear", (("case",),)),
    "mean_stiffness": Field("N m-1", "mean mesh stiffness in the equation of motion", _SCALAR + _STATE, None, True),
    "stiffness_ripple": Field("1", "first harmonic of the mesh stiffness over its mean", _STATE, None, True),
    "mean_half_backlash": Field("m", "half clearance, mean over the mesh", _STATE, None, True),
    "deepest_wear": Field("m", "largest wear depth of the flank", (("case", "gear"), ("gear",)), None, True),
    "first_doubling": Field(
        "1", "mesh frequency over natural frequency at the first period doubling", _STATE, None, True
    ),
    "first_doubling_remark": Field("", "the same in words", _STATE),
    "chaos_onset": Field("1", "mesh frequency over natural frequency where chaos begins", _STATE, None, True),
    "chaos_onset_remark": Field("", "the same in words", _STATE),
    "hindrance": Field("", "why the state, or the next one, cannot be computed; empty if it can", _STATE),
    # outcomes of studies
    "order": Field("", "order of the points of a sweep", (("order",),)),
    "member_name": Field("", "folder of the member", _SCALAR),
    "pinion_speed": Field("rpm", "speed of the pinion", (("point",),), None, True),
    "natural_speed": Field(
        "rpm", "speed of the pinion at which the mesh frequency is the natural frequency", _SCALAR, None, True
    ),
    "running_speed": Field("rpm", "speed under which the flanks heat up and wear", _SCALAR, None, True),
    "running_ratio": Field("1", "mesh frequency over natural frequency at that speed", _SCALAR, None, True),
    "running_class": Field("", "class of the motion at that speed", _SCALAR, MOTION_CLASSES),
    "running_force": Field("1", "largest mesh force over mean mesh force at that speed", _SCALAR, None, True),
    "running_contact_loss": Field("1", "part of the time out of contact at that speed", _SCALAR, None, True),
    "group": Field("", "kind of what is varied: option or parameter", _MEMBER),
    "key": Field("", "key of the configuration that is varied", _MEMBER),
    "value": Field("", "its value", _MEMBER),
    "usual_value": Field("", "its value in the study", _MEMBER),
    "companions": Field("", "keys changed along with it, empty for none", _MEMBER),
    # calibration
    "claim": Field("", "statement of the paper about states or the motion", (("claim",),)),
    "sweep": Field("", "swept quantity", (("sweep",),)),
    "claim_agrees": Field("1", "1 where a candidate agrees with a claim in the quick look", (("candidate", "claim"),)),
    "candidate_merit": Field("1", "claims that agree, plus how far each is from agreeing", (("candidate",),)),
    "candidate_remark": Field("", "why a candidate cannot be computed, empty if it can", (("candidate",),)),
    "candidate_agreements": Field("1", "claims about a sweep that agree", (("candidate", "sweep"),)),
    "claim_subject": Field("", "swept quantity that a claim is about, or states", (("claim",),)),
    "claims_of_sweep": Field("1", "claims about a sweep", (("sweep",),)),
    "member_agrees": Field("1", "1 where a member agrees with a claim, computed in full", (("member", "claim"),)),
    **{
        f"{whose}_{name}": Field(unit, f"{meaning}, of a {whose} of the calibration", ((whose,),))
        for whose in ("candidate", "member")
        for name, (unit, meaning) in PARAMETERS.items()
    },
    **{f"member_{name}": Field(unit, meaning, _MEMBER) for name, (unit, meaning) in OSCILLATOR.items()},
}
