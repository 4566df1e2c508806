"""Sections of the configuration that describe wear, vibration and the study, and the whole of it."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, Strict

from gearwear.config.basin_sections import Basins
from gearwear.config.bearing_sections import GearBearings
from gearwear.config.calibration_sections import Calibration
from gearwear.config.gear_sections import (
    Backlash,
    Elasticity,
    Friction,
    GearPair,
    Grid,
    Heat,
    Lubricant,
    Material,
    MeshStiffness,
    Operation,
    TransmissionError,
)
from gearwear.config.job_sections import Jobs
from gearwear.config.key_types import (
    CaseName,
    Flag,
    Name,
    Names,
    Number,
    Numbers,
    ReadNumber,
    ReadWhole,
    Section,
    Whole,
    choice,
    plain,
    quantity,
    table,
    target,
)
from gearwear.config.member_sections import Onsets, Study
from gearwear.config.micro_geometry_sections import MicroGeometry
from gearwear.config.oscillator_sections import GivenOscillator
from gearwear.config.sensitivity_sections import Sensitivity
from gearwear.config.surroundings_sections import HeatBalance
from gearwear.heat.bulk import COLDEST, HOTTEST

MOST_CYCLES = 10**12
_Order = Annotated[int, Field(ge=1, le=64), ReadWhole]
_Amplitude = Annotated[float, Field(ge=0.0, le=5.0), ReadNumber]
_Temperature = Annotated[float, Field(ge=COLDEST, le=HOTTEST), ReadNumber]
_Phase = Annotated[float, Field(ge=-6.2832, le=6.2832), ReadNumber]


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
        "Force in the wear law",
        dynamic="mesh force of the steady state",
        quasi_static="mean mesh force",
    )
    pressure: Literal["mean", "peak"] = choice(
        "Hertz pressure in the wear law",
        mean="mean, exact for a whole passage",
        peak="peak, 4/pi times it",
    )
    gear_cycles: Literal["tooth_ratio", "pinion"] = choice(
        "Cycles of a gear tooth",
        tooth_ratio="those of a pinion tooth times z_p/z_g",
        pinion="as many as a pinion tooth",
    )


class TorqueFluctuation(Section):
    """External periodic torque, a sum of harmonics."""

    frequency_ratio: Number = quantity("1", "Its frequency over the mesh frequency.", gt=0.0, le=100.0)
    amplitudes: Annotated[list[_Amplitude], Strict()] = quantity(
        "1", "Amplitudes of its harmonics 1, 2, ... over the mean mesh force; an empty list = none.", max_length=64
    )
    phases: Annotated[list[_Phase], Strict()] = quantity(
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
    damping_ratio: Number = quantity("1", "Damping ratio of the mesh.", ge=1e-4, lt=1.0)
    stiffness: Literal["nominal", "effective"] = choice(
        "Mesh stiffness in the equation of motion",
        nominal="sum of the pairs",
        effective="force over deflection, errors of the flanks included (Chen and Shao 2013)",
    )
    harmonics: _Order | Literal["full"] = quantity(
        "1",
        "Harmonics kept of mesh stiffness and transmission error; full = the tables themselves.",
    )
    ste_amplitude: Literal["nominal", "mean", "harmonic"] = choice(
        "Amplitude of the transmission error excitation",
        nominal="static deflection of the reference case times the relative mean transmission error",
        mean="mean transmission error",
        harmonic="first harmonic of the transmission error",
    )
    clearance: Literal["mean", "varying"] = choice(
        "Backlash in the equation of motion",
        mean="mean over the mesh period",
        varying="function of the mesh phase",
    )
    torque_fluctuation: TorqueFluctuation
    bearings: GearBearings
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


class Case(Section):
    """One state of temperature and wear."""

    bulk_temperature: _Temperature | Literal["balance"] = quantity(
        "degC", "Bulk temperature of both gears; balance = that at which heat_balance closes."
    )
    running_cycles: Whole = target(
        "Pinion revolutions of the wear chain; 0 = unworn. A whole multiple of wear.cycles_per_update.",
        "1",
        ge=0,
        le=MOST_CYCLES,
    )
    flash: Flag = plain("Whether flash temperature is added to the bulk temperature.")


_SWEPT_CASES = "Cases for which the sweep is made."


class MeshFrequencySweep(Section):
    """Sweep of the mesh frequency over the natural frequency."""

    cases: Names = target(_SWEPT_CASES, min_length=1)
    first: Number = quantity("1", "First mesh frequency over the natural frequency.", ge=0.01, le=10.0)
    last: Number = quantity("1", "Last mesh frequency over the natural frequency.", ge=0.01, le=10.0)
    points: Whole = quantity("1", "Number of points, ends included.", ge=2, le=20001)


class SteSweep(Section):
    """Sweep of the mean static transmission error over that of the reference case."""

    cases: Names = target(_SWEPT_CASES, min_length=1)
    first: Number = quantity("1", "First relative mean transmission error.", ge=0.0, le=20.0)
    last: Number = quantity("1", "Last relative mean transmission error.", ge=0.0, le=20.0)
    points: Whole = quantity("1", "Number of points, ends included.", ge=2, le=20001)
    mesh_frequency: Number = quantity("1", "Mesh frequency over the natural frequency.", ge=0.01, le=10.0)


class BacklashSweep(Section):
    """Sweep of the mean backlash over its initial value."""

    cases: Names = target(_SWEPT_CASES, min_length=1)
    first: Number = quantity("1", "First relative mean backlash.", ge=0.01, le=20.0)
    last: Number = quantity("1", "Last relative mean backlash.", ge=0.01, le=20.0)
    points: Whole = quantity("1", "Number of points, ends included.", ge=2, le=20001)
    mesh_frequency: Number = quantity("1", "Mesh frequency over the natural frequency.", ge=0.01, le=10.0)
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
    mesh_frequency: MeshFrequencySweep
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


class MapAxis(Section):
    """One axis of a map."""

    first: Number = quantity("1", "First value.", ge=0.01, le=20.0)
    last: Number = quantity("1", "Last value.", ge=0.01, le=20.0)
    points: Whole = quantity("1", "Number of values, ends included.", ge=2, le=20001)


class Maps(Section):
    """Maps of the motion over the mesh frequency and a second parameter, made by `snakemake -j2 maps`.

    The map over wear has the wear cycles of the case as rows.
    """

    case: Name = target("Case whose last state is mapped, and whose wear cycles are.")
    mesh_frequency: MapAxis
    ste: MapAxis
    backlash: MapAxis
    temperature: Numbers = quantity(
        "degC", "Bulk temperatures, ascending; each takes a wear chain of its own.", min_length=2, max_length=100
    )


class Portraits(Section):
    """Swept values whose phase portraits are drawn, by case."""

    mesh_frequency: dict[CaseName, Numbers] = quantity("1", "Mesh frequencies of the phase portraits.")
    ste: dict[CaseName, Numbers] = quantity("1", "Relative mean transmission errors of the phase portraits.")
    backlash: dict[CaseName, Numbers] = quantity("1", "Relative mean backlashes of the phase portraits.")


class Figures(Section):
    """What is drawn side by side, and what it is held against."""

    diagonal: Names = target("Cases of Figs 6 to 11, from new to worn.", min_length=2, max_length=6)
    claims: Flag = target(
        "Whether the statements of the paper are drawn in the diagrams and judged; they are about its own pair."
    )


class Configuration(Section):
    """Everything a run of the workflow can be told."""

    gear_pair: GearPair
    micro_geometry: MicroGeometry
    grid: Grid
    material: Material
    elasticity: Elasticity
    operation: Operation
    lubricant: Lubricant
    friction: Friction
    heat: Heat
    heat_balance: HeatBalance
    mesh_stiffness: MeshStiffness
    transmission_error: TransmissionError
    backlash: Backlash
    wear: Wear
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
