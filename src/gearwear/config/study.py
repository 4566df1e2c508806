"""Sections of the configuration that describe the oscillator and the study, and the whole configuration."""

from collections.abc import Iterator
from typing import Annotated, Any, Generic, Literal, NamedTuple

from pydantic import Field, Strict
from pydantic.fields import FieldInfo

from gearwear.config import pair
from gearwear.config.types import (
    Both,
    CaseName,
    Flag,
    Interval,
    Name,
    Names,
    Nullable,
    Number,
    Numbers,
    Range,
    ReadNumber,
    ReadWhole,
    Section,
    Value,
    Whole,
    choice,
    entry_type,
    is_section,
    jobs,
    keys,
    placeholder,
    plain,
    quantity,
    table,
    target,
    unit_of,
)
from gearwear.heat.bulk import COLDEST, HOTTEST

MOST_UPDATES = 999

_DampingRatio = Annotated[float, Field(ge=1e-4, lt=1.0), ReadNumber]
_Mass = Annotated[float, Field(ge=1e-6, le=1e6), ReadNumber]
_Temperature = Annotated[float, Field(ge=COLDEST, le=HOTTEST), ReadNumber]
_Harmonic = Annotated[int, Field(ge=1, le=64), ReadWhole]
_Amplitude = Annotated[float, Field(ge=0.0, le=5.0), ReadNumber]
_SignedAmplitude = Annotated[float, Field(ge=-5.0, le=5.0), ReadNumber]
_Phase = Annotated[float, Field(ge=-6.2832, le=6.2832), ReadNumber]
_Phases = Annotated[list[_Phase], Strict()]
_Frequency = Annotated[float, quantity("1", "Mesh frequency over the natural frequency.", ge=0.01, le=10.0), ReadNumber]
_Values = Annotated[list[Any], Strict(), Field(min_length=1, max_length=1000)]


class GearBearing(Section):
    """Bearing of one gear in model translational."""

    mass: Nullable[_Mass] = quantity("kg", "Mass that moves on it; null = disc of the pitch radius less the bore.")
    stiffness_along: Number = quantity("N/m", "Stiffness along the line of centres.", ge=1e3, le=1e13)
    stiffness_across: Number = quantity("N/m", "Stiffness across the line of centres.", ge=1e3, le=1e13)
    damping_ratio: Number = quantity("1", "Damping ratio of the mass on the bearing alone.", ge=0.0, lt=1.0)


class TorqueFluctuation(Section):
    """External periodic torque, a sum of harmonics."""

    frequency_ratio: Number = quantity("1", "Its frequency over the mesh frequency.", gt=0.0, le=100.0)
    amplitudes: Annotated[list[_Amplitude], Strict()] = quantity(
        "1", "Amplitudes of its harmonics 1, 2, ... over the mean mesh force; an empty list = none.", max_length=64
    )
    phases: _Phases = quantity(
        "rad", "Their phases at the entry of a tooth pair, one for every amplitude.", max_length=64
    )


class Start(Section):
    """Initial state of the oscillator."""

    at: Literal["stiffest_mesh", "pair_entry"] = choice(
        "Instant at which the initial state is given",
        stiffest_mesh="where the first harmonic of the stiffness is largest",
        pair_entry="where a pair enters, mesh phase 0",
    )
    displacement: Number = quantity("1", "Initial displacement over the half backlash.", ge=-100.0, le=100.0)
    velocity: Number = quantity(
        "1", "Initial velocity over half backlash times natural frequency.", ge=-100.0, le=100.0
    )


class Dynamics(Section):
    """Oscillator with backlash."""

    model: Literal["torsional", "translational"] = choice(
        "Motion of the gears",
        torsional="they turn about fixed centres",
        translational="they turn, and move sideways on bearings; without branches and what is made of them",
    )
    reference_case: Name = plain(
        "Case whose mean transmission error and stiffness scale the excitation; it has no wear."
    )
    damping_ratio: _DampingRatio = quantity("1", "Damping ratio of the mesh.")
    stiffness: Literal["nominal", "effective"] = choice(
        "Mesh stiffness in the equation of motion",
        nominal="sum of the pairs",
        effective="force over deflection, errors of the flanks included (Chen and Shao 2013)",
    )
    harmonics: _Harmonic | Literal["full"] = quantity(
        "1", "Harmonics kept of mesh stiffness and transmission error; full = the tables themselves."
    )
    ste_amplitude: Literal["nominal", "mean", "harmonic"] = choice(
        "Amplitude of the transmission error excitation",
        nominal="static deflection of the reference case times the relative mean transmission error",
        mean="mean transmission error",
        harmonic="first harmonic of the transmission error",
    )
    clearance: Literal["mean", "varying"] = choice(
        "Backlash in the equation of motion", mean="mean over the mesh period", varying="function of the mesh phase"
    )
    torque_fluctuation: TorqueFluctuation
    bearings: Both[GearBearing]
    tolerance: Number = quantity(
        "1",
        "Relative tolerance of Dormand-Prince, used where the affine map does not apply: a torque that does not repeat "
        "within 64 mesh periods.",
        ge=1e-13,
        le=1e-4,
    )
    start: Start


class Settling(Section):
    """When a motion counts as steady, and how it is classified."""

    transient_periods: Whole = quantity("1", "Mesh periods before the first look.", ge=1, le=1_000_000)
    longest_transient: Whole = quantity(
        "1", "Mesh periods after which a point is given up as not converged.", ge=1, le=10_000_000
    )
    sampled_periods: Whole = quantity("1", "Mesh periods of the Poincare section.", ge=24, le=1_000_000)
    largest_period: Whole = quantity("1", "Longest period looked for, in mesh periods.", ge=1, le=64)
    recurrence_tolerance: Number = quantity(
        "1", "Distance of points that count as the same, over the half backlash.", ge=1e-12, le=1e-2
    )
    chaos_threshold: Number = quantity(
        "1", "Least Lyapunov exponent per unit of dimensionless time that is called chaos.", gt=0.0, le=1.0
    )
    early_end: Flag = plain(
        "Whether a motion whose section recurs to the last bit is filled in instead of run on; the sections stay the "
        "same to the last bit, exponents to round-off."
    )


class Waves(Section, Generic[Value]):
    """Harmonics of a quantity of a given oscillator."""

    amplitudes: Value
    phases: _Phases = quantity("rad", "Their phases at mesh phase 0, one for every amplitude.", max_length=64)


_StiffnessAmplitudes = Annotated[
    list[_SignedAmplitude],
    quantity("1", "Amplitudes of the harmonics 1, 2, ... over the mean; an empty list = none.", max_length=64),
    Strict(),
]
_ErrorAmplitudes = Annotated[
    list[_SignedAmplitude],
    quantity("1", "Amplitudes of the harmonics 1, 2, ... over the half backlash; an empty list = none.", max_length=64),
    Strict(),
]


class GivenOscillator(Section):
    """Oscillators given by their dimensionless equation; where there is one, the study is of them alone."""

    mean_force: Number = quantity("1", "Mean force over mean stiffness times half backlash.", ge=-100.0, le=100.0)
    stiffness: Waves[_StiffnessAmplitudes]
    error: Waves[_ErrorAmplitudes]


class Case(Section):
    """One state of temperature and wear."""

    bulk_temperature: _Temperature | Literal["balance"] = quantity(
        "degC", "Bulk temperature of both gears; balance = that at which heat_balance closes."
    )
    running_cycles: Whole = target(
        "Pinion revolutions of the wear chain; 0 = unworn. A whole multiple of wear.cycles_per_update.",
        "1",
        ge=0,
        le=pair.MOST_CYCLES,
    )
    flash: Flag = plain("Whether flash temperature is added to the bulk temperature.")


class Sweep(Interval[Value], Generic[Value]):
    """Values at which the motion is computed."""

    points: Whole = quantity("1", "Number of points, ends included.", ge=2, le=20001)
    cases: Names = target("Cases for which the sweep is made.", min_length=1)


class SteSweep(
    Sweep[Annotated[float, quantity("1", "Relative mean transmission error.", ge=0.0, le=20.0), ReadNumber]]
):
    """Sweep of the mean static transmission error over that of the reference case."""

    mesh_frequency: _Frequency


class BacklashSweep(Sweep[Annotated[float, quantity("1", "Relative mean backlash.", ge=0.01, le=20.0), ReadNumber]]):
    """Sweep of the mean backlash over its initial value."""

    mesh_frequency: _Frequency
    reading: Literal["rescale", "clearance"] = choice(
        "What the swept backlash changes",
        rescale="the unit of length, hence the relative excitation",
        clearance="only the clearance of the restoring force",
    )


class Sweeps(Section):
    """Ranges over which the motion is followed."""

    order: Literal["restart", "up", "down"] = target(
        "Order of the points that diagrams show first and claims judge; all three are computed: restart = "
        "dynamics.start at every point; up = from the end of the next lower point; down = from that of the next higher."
    )
    mesh_frequency: Sweep[_Frequency]
    ste: SteSweep
    backlash: BacklashSweep


class Branches(Section):
    """Continuation of the periodic orbits along the sweeps, unstable ones included."""

    largest_period: Whole = quantity("1", "Longest period followed, in mesh periods.", ge=1, le=64)
    largest_step: Number = quantity(
        "1",
        "Largest step along a branch; state over the half backlash, swept quantity over its range.",
        ge=1e-5,
        le=1.0,
    )
    most_nodes: Whole = quantity("1", "Orbits after which a branch is given up.", ge=10, le=1_000_000)


class MapAxis(Interval[Annotated[float, quantity("1", "End of the axis.", ge=0.01, le=20.0), ReadNumber]]):
    """One axis of a map."""

    points: Whole = quantity("1", "Number of values, ends included.", ge=2, le=20001)


class Maps(Section):
    """Maps of the motion over the mesh frequency and a second parameter, made by `snakemake -j2 maps`.

    The map over wear has the wear cycles of the case as rows.
    """

    case: Name = target("Case whose last state is mapped, and whose wear cycles are.")
    mesh_frequency: MapAxis
    ste: MapAxis
    backlash: MapAxis
    temperature: Annotated[list[_Temperature], Strict()] = quantity(
        "degC", "Bulk temperatures, ascending; each takes a wear chain of its own.", min_length=2, max_length=100
    )


class SweptValues(Section):
    """Swept values, by case."""

    mesh_frequency: dict[CaseName, Numbers] = quantity("1", "Mesh frequencies over the natural frequency.")
    ste: dict[CaseName, Numbers] = quantity("1", "Relative mean transmission errors.")
    backlash: dict[CaseName, Numbers] = quantity("1", "Relative mean backlashes.")


class Portraits(SweptValues):
    """Swept values whose phase portraits are drawn, by case."""


class Basins(Section):
    """Basins of attraction on a slice of initial states at mesh phase 0."""

    points: SweptValues
    displacement: Interval[
        Annotated[float, quantity("1", "Initial displacement over the half backlash.", ge=-100.0, le=100.0), ReadNumber]
    ]
    velocity: Interval[
        Annotated[
            float,
            quantity("1", "Initial velocity over half backlash times natural frequency.", ge=-100.0, le=100.0),
            ReadNumber,
        ]
    ]
    resolution: Whole = quantity("1", "Cells each way; one motion is followed from the centre of each.", ge=2, le=500)


class Figures(Section):
    """What is drawn side by side, and what it is held against."""

    diagonal: Names = target("Cases of Figs 6 to 11, from new to worn.", min_length=2, max_length=6)
    claims: Flag = target(
        "Whether the statements of the paper are drawn in the diagrams and judged; they are about its own pair."
    )


class Factors(Section):
    """Range of a factor on the value of the study."""

    low: Number = quantity("1", "Least factor.", gt=0.0, le=1.0)
    high: Number = quantity("1", "Largest factor.", ge=1.0, le=10.0)


class Box(Section):
    """Ranges of the parameters that the paper leaves open, as factors on the values of the study."""

    damping_ratio: Factors
    bore_radius: Factors
    pinion_torque: Factors
    pressure_viscosity: Factors


class Onsets(Section):
    """Shift of the onsets of period doublings and chaos from case without to case with, and its spread."""

    refinement: Whole = quantity(
        "1", "Finer steps in the step of the mesh frequency sweep where chaos begins.", ge=1, le=1000
    )
    members: Whole = target("Members drawn from the box, beside those at its faces.", "1", ge=0, le=999)
    box: Box


class Sensitivity(Section):
    """Ends of the parameters that the paper leaves open, each varied alone by `snakemake -j2 sensitivity`."""

    damping_ratio: Range[Annotated[_DampingRatio, quantity("1", "Damping ratio of the mesh.")]]
    pinion_torque: Range[Annotated[Nullable[pair.Torque], quantity("N m", "Pinion torque; null = 0.8 and 1.2 of it.")]]
    pinion_speed: Range[Annotated[Nullable[pair.Speed], quantity("rpm", "Pinion speed; null = 2/3 and 4/3 of it.")]]
    pinion_bore_radius: Range[
        Annotated[Nullable[pair.BoreRadius], quantity("m", "Bore radius; null = 0.8 and 1.25 of it.")]
    ]
    gear_bore_radius: Range[
        Annotated[Nullable[pair.BoreRadius], quantity("m", "Bore radius; null = 0.8 and 1.25 of it.")]
    ]
    pressure_viscosity: Range[Annotated[pair.PressureViscosity, quantity("1/Pa", "Pressure-viscosity coefficient.")]]
    composite_roughness: Range[Annotated[pair.Roughness, quantity("m", "Composite rms roughness.")]]
    shaft_temperature_drop: Range[Annotated[pair.TemperatureDrop, quantity("K", "Shaft below base circle.")]]
    half_backlash: Range[
        Annotated[Nullable[pair.HalfBacklash], quantity("m", "Half backlash; null = 0.5 and 1.25 of it.")]
    ]


class Calibration(Section):
    """Search of the parameters that the paper leaves open, made by `snakemake -j2 calibrate`."""

    pinion_teeth: Range[Annotated[float, quantity("1", "Teeth of the pinion.", ge=6, le=500), ReadNumber]]
    tooth_ratio: Range[
        Annotated[float, quantity("1", "Teeth of the gear over those of the pinion.", ge=0.1, le=10.0), ReadNumber]
    ]
    pinion_bore: Range[
        Annotated[
            float, quantity("1", "Bore radius of the pinion over its reference radius.", ge=0.05, le=0.9), ReadNumber
        ]
    ]
    gear_bore: Range[
        Annotated[
            float, quantity("1", "Bore radius of the gear over its reference radius.", ge=0.05, le=0.9), ReadNumber
        ]
    ]
    line_load: Range[
        Annotated[float, quantity("N/m", "Mean mesh force over the face width.", ge=1e3, le=1e7), ReadNumber]
    ]
    pitch_speed: Range[
        Annotated[float, quantity("m/s", "Speed of the reference circles.", ge=0.1, le=200.0), ReadNumber]
    ]
    damping_ratio: Range[Annotated[float, quantity("1", "Damping ratio.", ge=1e-4, le=0.99), ReadNumber]]
    pressure_viscosity: Range[
        Annotated[float, quantity("1/Pa", "Pressure-viscosity coefficient.", ge=1e-10, le=1e-6), ReadNumber]
    ]
    composite_roughness: Range[
        Annotated[float, quantity("m", "Rms roughness of both flanks.", ge=1e-8, le=1e-5), ReadNumber]
    ]
    shaft_temperature_drop: Range[
        Annotated[float, quantity("K", "How much cooler the shaft is.", ge=0.0, le=500.0), ReadNumber]
    ]
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


class Jobs(Section):
    """How the work is cut into jobs. The results are the same to the last bit."""

    wear_cycles: Whole = jobs(
        "Wear cycles of a case that one job computes, one after another; 1 = a job for each stage of each cycle. "
        "A changed value makes the wear chains anew, and more running cycles their last block.",
        "1",
        ge=1,
        le=MOST_UPDATES,
    )


class Study(Section):
    """Members, the same study with a few keys changed, each computed in results/studies/STUDY/MEMBER.

    They are named one by one in `members`, or are all combinations of the values in `grid`.
    """

    case: Name = target("Case that the combinations of a grid are about.", default="with")
    settings: dict[Name, dict[Any, Any]] = table(
        "Keys in which all members differ from this configuration, nested as here.", "sections", default={}
    )
    grid: dict[Name, _Values] = table(
        "Values of keys, each written with dots: dynamics.damping_ratio. Every combination is a member.",
        "keys",
        default={},
    )
    members: dict[CaseName, dict[Any, Any]] = table(
        "Keys in which the member differs from this configuration, nested as here.", "members", default={}
    )


class Configuration(Section):
    """The whole configuration of a run."""

    gear_pair: pair.GearPair
    micro_geometry: pair.MicroGeometry
    grid: pair.Grid
    material: pair.Material
    elasticity: pair.Elasticity
    operation: pair.Operation
    lubricant: pair.Lubricant
    friction: pair.Friction
    heat: pair.Heat
    heat_balance: pair.HeatBalance
    mesh_stiffness: pair.MeshStiffness
    transmission_error: pair.TransmissionError
    backlash: pair.Backlash
    wear: pair.Wear
    dynamics: Dynamics
    settling: Settling
    oscillators: dict[CaseName, GivenOscillator] = plain("Oscillators given by their equation.")
    cases: dict[CaseName, Case]
    sweeps: Sweeps
    branches: Branches
    maps: Maps
    portraits: Portraits
    basins: Basins
    figures: Figures
    onsets: Onsets
    sensitivity: Sensitivity
    calibration: Calibration
    jobs: Jobs
    studies: dict[CaseName, Study] = table("Studies made of members.", "studies")


class Declaration(NamedTuple):
    """What a key is declared as: unit, empty if it is no number, and meaning."""

    unit: str
    meaning: str


def leaves() -> Iterator[tuple[tuple[str, ...], FieldInfo]]:
    """Yield path and declaration of every key that holds a value; free names appear as placeholders."""
    for path, field in keys(Configuration):
        entry = entry_type(field.annotation)
        if entry is not None and not is_section(entry):
            yield (*path, placeholder(field)), field
        elif entry is None and not is_section(field.annotation):
            yield path, field


def declared_at(key: str) -> Declaration | None:
    """Return the declaration of a dotted key, None if there is no such key; free names match any name."""
    names = key.split(".")
    for path, field in keys(Configuration):
        if len(path) == len(names) and all(
            part in (name, "<case>", "<name>") for part, name in zip(path, names, strict=True)
        ):
            return Declaration(unit_of(field) or "", field.description or "")
    return None
