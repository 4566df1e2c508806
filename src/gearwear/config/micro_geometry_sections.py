"""Section of the configuration that describes how the new flanks deviate from two perfect involutes."""

from __future__ import annotations

from gearwear.config.key_types import Number, Section, quantity


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


class TipRelief(Section):
    """Tip relief of both gears."""

    pinion: Relief
    gear: Relief


class MicroGeometry(Section):
    """Deviations of the new flanks from two perfect involutes."""

    tip_relief: TipRelief
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
