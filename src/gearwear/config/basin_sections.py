"""Configuration of the basins of attraction."""

from __future__ import annotations

from gearwear.config.key_types import CaseName, Number, Numbers, Section, Whole, quantity


class BasinPoints(Section):
    """Swept values at which basins are mapped, by case."""

    mesh_frequency: dict[CaseName, Numbers] = quantity("1", "Mesh frequencies of the basins.")
    ste: dict[CaseName, Numbers] = quantity("1", "Relative mean transmission errors of the basins.")
    backlash: dict[CaseName, Numbers] = quantity("1", "Relative mean backlashes of the basins.")


class DisplacementRange(Section):
    """Initial displacements of the slice."""

    first: Number = quantity("1", "Least initial displacement over the half backlash.", ge=-100.0, le=100.0)
    last: Number = quantity("1", "Greatest initial displacement over the half backlash.", ge=-100.0, le=100.0)


class VelocityRange(Section):
    """Initial velocities of the slice."""

    first: Number = quantity(
        "1", "Least initial velocity over half backlash times natural frequency.", ge=-100.0, le=100.0
    )
    last: Number = quantity(
        "1", "Greatest initial velocity over half backlash times natural frequency.", ge=-100.0, le=100.0
    )


class Basins(Section):
    """Basins of attraction on a slice of initial states at mesh phase 0."""

    points: BasinPoints
    displacement: DisplacementRange
    velocity: VelocityRange
    resolution: Whole = quantity("1", "Cells each way; one motion is followed from the centre of each.", ge=2, le=500)
