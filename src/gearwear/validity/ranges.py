"""Where a run leaves the ranges in which its laws were fitted or tested: warnings, never the end of a run."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from gearwear.chain.wear import COARSE, share_of_deflection
from gearwear.geometry.involute import GEARS
from gearwear.geometry.kinematics import curvature
from gearwear.mesh.foundation import RADIUS_RATIO_RANGE, ROOT_ANGLE_RANGE

COLUMNS = ("place", "quantity", "value", "range", "meaning")


class Range(NamedTuple):
    """Bounds of a quantity, and what a value outside means."""

    quantity: str
    low: float
    high: float
    unit: str
    meaning: str


_FOUNDATION = "the stiffness of the gear body (Sainsot et al. 2004) is extrapolated beyond its fit"
_REGRESSION = (
    "the wear coefficient (Janakiraman et al. 2014) is far from mineral oil on ground flanks: choice, as the range of "
    "its tests is not open"
)
RANGES = {
    "root_over_bore": Range("root over bore radius", *RADIUS_RATIO_RANGE, "", _FOUNDATION),
    "root_angle": Range("half tooth angle at the root", *ROOT_ANGLE_RANGE, "rad", _FOUNDATION),
    "hertz_pressure": Range(
        "largest Hertz pressure under the static load",
        0.0,
        1.5,
        "GPa",
        "flanks pit before they wear: above the endurance of case-hardened steel (ISO 6336-5, quality MQ)",
    ),
    "film_ratio": Range(
        "film over roughness",
        0.05,
        4.0,
        "",
        "below, the flanks run dry; above, a full film leaves no wear (Ding and Kahraman 2007)",
    ),
    "load_group": Range("wear regression, load F'/(E' R)", 1e-5, 5e-4, "", _REGRESSION),  # 0.3 to 2 GPa
    "oil_group": Range("wear regression, oil alpha E'", 2000.0, 5500.0, "", _REGRESSION),
    "roughness_group": Range("wear regression, roughness over R", 1e-5, 3e-4, "", _REGRESSION),
    "wear_step": Range(
        "depth of one wear step over the elastic deflection",
        0.0,
        COARSE,
        "",
        "steps of the wear chain are coarse; lower wear.cycles_per_update",
    ),
    "unsettled": Range(
        "wear cycles whose motion at the running speed did not settle",
        0.0,
        0.0,
        "",
        "wear and mesh force are those of the sampled periods; raise settling.longest_transient",
    ),
}

Measured = tuple[str, str, Any]  # place, name in RANGES, values


def of_pair(geometry: xr.Dataset) -> Iterator[Measured]:
    """Yield what is measured on the bodies of both gears."""
    for place, name in enumerate(GEARS):
        root, bore, angle = (float(geometry[key][place]) for key in ("root_radius", "bore_radius", "rack_root_angle"))
        yield name, "root_over_bore", root / bore
        yield name, "root_angle", angle


def of_contact(case: str, geometry: xr.Dataset, temperature: xr.Dataset, cfg: dict[str, Any]) -> Iterator[Measured]:
    """Yield what is measured along the path of contact under the static load.

    Parameters
    ----------
    cfg : the slice `warnings`; `cfg["cases"]` holds the number of wear cycles of every case.
    """
    load, half_width = temperature["load_per_width"].values, temperature["hertz_half_width"].values
    loaded = half_width > 0
    load, half_width, radius = load[loaded], half_width[loaded], curvature(geometry)[1][loaded]
    modulus = 8 * load * radius / (np.pi * half_width**2)
    yield case, "hertz_pressure", 1e-9 * 2 * load / (np.pi * half_width)
    yield case, "film_ratio", temperature["film_ratio"].values[loaded]
    if cfg["wear"]["law"] == "janakiraman" and cfg["cases"][case]:
        yield case, "load_group", load / (modulus * radius)
        yield case, "oil_group", cfg["lubricant"]["pressure_viscosity"] * modulus
        yield case, "roughness_group", cfg["lubricant"]["composite_roughness"] / radius


def of_chain(case: str, steps: Iterable[tuple[xr.Dataset, xr.Dataset]], classes: Iterable[int]) -> Iterator[Measured]:
    """Yield what is measured over the wear cycles of a case.

    Parameters
    ----------
    steps : transmission error before and flanks after every block of running cycles.
    classes : of the motion at every wear cycle, 0 where it did not settle.
    """
    before, shares = 0.0, [0.0]
    for transmission_error, wear in steps:
        cycles = float(wear["running_cycles"]) - before
        shares.append(share_of_deflection(wear["wear_per_revolution"].values, cycles, transmission_error))
        before += cycles
    yield case, "wear_step", max(shares)
    yield case, "unsettled", sum(not motion_class for motion_class in classes)


def rows(measured: Iterable[Measured]) -> list[tuple[str, ...]]:
    """Return place, quantity, value, range and meaning of all that lies outside; equal ones of several places once."""
    places: dict[tuple[str, str], list[str]] = {}
    for place, name, values in measured:
        known = RANGES[name]
        least, most = float(np.min(values)), float(np.max(values))
        outside = [value for value, out in ((least, least < known.low), (most, most > known.high)) if out]
        if outside:
            shown = " and ".join(f"{value:.3g}" for value in dict.fromkeys(outside))
            places.setdefault((name, f"{shown} {known.unit}".strip()), []).append(place)
    return [
        (", ".join(found), RANGES[name].quantity, value, _bounds(RANGES[name]), RANGES[name].meaning)
        for (name, value), found in places.items()
    ]


def sentence(row: tuple[str, ...]) -> str:
    """Return a row of the table as a sentence."""
    place, quantity, value, bounds, meaning = row
    return f"warning: {place}: {quantity} {value} is outside {bounds}: {meaning}"


def _bounds(known: Range) -> str:
    return f"{known.low:.3g} to {known.high:.3g} {known.unit}".strip()
