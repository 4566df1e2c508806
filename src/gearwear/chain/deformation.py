"""Thermal growth of the flanks and of the base circles."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.errors import GearwearError
from gearwear.geometry.involute import GEARS
from gearwear.geometry.kinematics import curvature
from gearwear.heat.growth import Growth, base_circle_growth, flank_growth


def deformation(cfg: dict[str, Any], geometry: xr.Dataset, temperature: xr.Dataset | None = None) -> xr.Dataset:
    """Return the growth of the flanks and of the base circles.

    Parameters
    ----------
    cfg : the slice `deformation`.
    temperature : needed where `heat.temperature_rise` is `contact`, and not read otherwise.
    """
    rise = np.full(geometry.sizes["path"], _bulk_rise(cfg))
    if cfg["heat"]["temperature_rise"] == "contact":
        if temperature is None:
            raise GearwearError("heat.temperature_rise: contact needs the contact temperature; give it, or bulk")
        rise = rise + temperature["flash_temperature"].values
    grown = _growth(cfg, geometry, rise)
    along = ("gear", "path")
    values = {
        "thermal_growth": (along, np.stack([one.growth for one in grown])),
        "involute_error": (along, np.stack([one.involute_error for one in grown])),
        "base_circle_growth": ("gear", np.array(_base_circles(cfg, geometry))),
    }
    return xr.Dataset(values, {"path": geometry["path"], "gear": geometry["gear"]})


def flash_growth(cfg: dict[str, Any], geometry: xr.Dataset, temperature: xr.Dataset) -> xr.Dataset:
    """Return the growth that the flash temperature would add if the whole tooth had it.

    Parameters
    ----------
    cfg : the slice `deformation`.
    """
    flash, rise = temperature["flash_temperature"].values, _bulk_rise(cfg)
    hot, cool = (_growth(cfg, geometry, rises) for rises in (rise + flash, np.full_like(flash, rise)))
    extra = np.stack([one.growth - other.growth for one, other in zip(hot, cool, strict=True)])
    coords = {"path": geometry["path"], "gear": geometry["gear"]}
    return xr.Dataset({"thermal_growth_flash": (("gear", "path"), extra)}, coords)


def _bulk_rise(cfg: dict[str, Any]) -> float:
    return cfg["case"]["bulk_temperature"] - cfg["heat"]["initial_temperature"]


def _base_circles(cfg: dict[str, Any], geometry: xr.Dataset) -> list[float]:
    """Return the growth of both base circles (m)."""
    heat, rim = cfg["heat"], _bulk_rise(cfg)
    shaft = max(rim - heat["shaft_temperature_drop"], 0.0)
    return [
        base_circle_growth(
            shaft,
            rim,
            float(geometry["bore_radius"][i]),
            float(geometry["base_radius"][i]),
            cfg["material"][name]["thermal_expansion"],
            heat["hub"],
        )
        for i, name in enumerate(GEARS)
    ]


def _growth(cfg: dict[str, Any], geometry: xr.Dataset, rise: np.ndarray) -> list[Growth]:
    """Return the growth of both flanks for a temperature rise (K) along the path."""
    radii, _ = curvature(geometry)
    base, half = geometry["base_radius"].values, geometry["base_half_angle"].values
    circles = _base_circles(cfg, geometry)
    return [
        flank_growth(
            radii[i],
            float(base[i]),
            float(half[i]),
            rise,
            circles[i],
            cfg["material"][name]["thermal_expansion"],
            cfg["heat"]["growth"],
        )
        for i, name in enumerate(GEARS)
    ]
