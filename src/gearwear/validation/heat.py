"""Elastic modulus of hot steel, growth of the base circle and of the flanks."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.contact.modulus import modulus_ratio
from gearwear.geometry.involute import involute
from gearwear.heat.growth import Growth, base_circle_growth, flank_growth
from gearwear.validation.pairs import geometry_of


def modulus(temperature: float, law: str, cold: float, calibration: float = 5.3) -> float:
    """Return the modulus at a temperature (degC) over that at another, `cold`, l = 1.18e-5 1/K."""
    hot, reference = (modulus_ratio(t, law, 1.18e-5, calibration) for t in (temperature, cold))
    return float(hot / reference)


def rim_growth(shaft_rise: float, rim_rise: float, bore_radius: float, base_radius: float, hub: str) -> float:
    """Return the growth of the base circle (m), l = 1.1e-5 1/K."""
    return base_circle_growth(shaft_rise, rim_rise, bore_radius, base_radius, 1.1e-5, hub)


def _tooth(pair: dict[str, Any], radius: float, mode: str, rim: float | None) -> Any:
    """Return the growth of the pinion flank at a radius, bore 40 K, tooth 80 K warmer, and what it comes from."""
    geometry = geometry_of(**pair)
    base, half = float(geometry["base_radius"][0]), float(geometry["base_half_angle"][0])
    rolled = np.array([np.sqrt(radius**2 - base**2)])
    if rim is None:
        rim = rim_growth(40.0, 80.0, float(geometry["bore_radius"][0]), base, "free_bore")
    return flank_growth(rolled, base, half, 80.0, rim, 1.1e-5, mode), base, half, rolled[0]


def radial_growth(pair: dict[str, Any], radius: float) -> float:
    """Return the radial growth of the flank at a radius (m)."""
    growth, base, _, _ = _tooth(pair, radius, "consistent", None)
    return growth.base_circle_growth + 1.1e-5 * 80.0 * (radius - base)


def thickness_growth(pair: dict[str, Any], radius: float) -> float:
    """Return the growth of the half thickness along the line of action of a tooth free of its body (m)."""
    _, base, half, rolled = _tooth(pair, radius, "consistent", None)
    return 1.1e-5 * 80.0 * base * (half - involute(np.arctan(rolled / base)))


def involute_error(pair: dict[str, Any], radius: float, mode: str, rim: float | None = None) -> float:
    """Return the distance of the hot flank from the hot involute (m); `rim` is the growth of the base circle."""
    growth: Growth = _tooth(pair, radius, mode, rim)[0]
    return growth.involute_error[0]


def shift(pair: dict[str, Any], radius: float) -> float:
    """Return the shift of the flank seen at a fixed radius (m)."""
    return _tooth(pair, radius, "eulerian", None)[0].growth[0]


def along_path(pair: dict[str, Any], mode: str, bulk: float, gear: int, contact: float) -> float:
    """Return the growth of a flank (m) at a contact from 0, start, to 1, end; shaft 20 K below the bulk."""
    return _growth(geometry_of(**pair), mode, bulk - 20.0, bulk - 40.0, gear, contact)


def uniform_loss(pair: dict[str, Any], contact: float) -> float:
    """Return the sum of both shifts (m) of gears heated alike by 80 K, at a contact from 0 to 1."""
    geometry = geometry_of(**pair)
    return sum(_growth(geometry, "eulerian", 80.0, 80.0, gear, contact) for gear in (0, 1))


def _growth(geometry: xr.Dataset, mode: str, rise: float, shaft: float, gear: int, contact: float) -> float:
    start, end = float(geometry["start_of_contact"]), float(geometry["end_of_contact"])
    place = start + contact * (end - start)
    rolled = np.array([place if gear == 0 else float(geometry["line_of_action"]) - place])
    base, half = float(geometry["base_radius"][gear]), float(geometry["base_half_angle"][gear])
    rim = rim_growth(shaft, rise, float(geometry["bore_radius"][gear]), base, "free_bore")
    return flank_growth(rolled, base, half, rise, rim, 1.1e-5, mode).growth[0]


QUANTITIES = {
    "modulus": modulus,
    "rim_growth": rim_growth,
    "radial_growth": radial_growth,
    "thickness_growth": thickness_growth,
    "involute_error": involute_error,
    "shift": shift,
    "along_path": along_path,
    "uniform_loss": uniform_loss,
}
