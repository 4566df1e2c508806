"""Sections of the configuration that describe studies made of members."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import Field, Strict

from gearwear.config.key_types import CaseName, Name, Number, Section, Whole, quantity, table, target

_Values = Annotated[list[Any], Strict(), Field(min_length=1, max_length=1000)]


class Study(Section):
    """Members, the same study with a few keys changed, each computed in results/studies/STUDY/MEMBER.

    They are named one by one in `members`, or are all combinations of the values in `grid`.
    """

    case: Name = target("Case that the combinations of a grid are about.", default="with")
    settings: dict[str, dict[Any, Any]] = table(
        "Keys in which all members differ from this configuration, nested as here.", "sections", default={}
    )
    grid: dict[str, _Values] = table(
        "Values of keys, each written with dots: dynamics.damping_ratio. Every combination is a member.",
        "keys",
        default={},
    )
    members: dict[CaseName, dict[Any, Any]] = table(
        "Keys in which the member differs from this configuration, nested as here.", "members", default={}
    )


class Range(Section):
    """Range of a factor on the value of the study."""

    low: Number = quantity("1", "Least factor.", gt=0.0, le=1.0)
    high: Number = quantity("1", "Largest factor.", ge=1.0, le=10.0)


class Box(Section):
    """Ranges of the parameters that the paper leaves open, as factors on the values of the study."""

    damping_ratio: Range
    bore_radius: Range
    pinion_torque: Range
    pressure_viscosity: Range


class Onsets(Section):
    """Shift of the onsets of period doublings and chaos from case without to case with, and its spread."""

    refinement: Whole = quantity(
        "1", "Finer steps in the step of the mesh frequency sweep where chaos begins.", ge=1, le=1000
    )
    members: Whole = target("Members drawn from the box, beside those at its faces.", "1", ge=0, le=999)
    box: Box
