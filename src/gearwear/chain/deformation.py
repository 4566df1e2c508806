"""Thermal growth of the four flanks at the bulk temperature, or at the contact temperature."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.geometry.involute import GEARS
from gearwear.geometry.kinematics import curvature
from gearwear.heat.growth import Growth, base_circle_growth, flank_growth


def deformation(cfg: dict[str, Any], geometry: xr.Dataset, temperature: xr.Dataset) -> xr.Dataset:
    """Return the growth of the flanks and of the base circles.

    Parameters
    ----------
    cfg : the slice `deformation`.
    """
    heat = cfg["heat"]
    flash = temperature["flash_temperature"].values
    rim = cfg["case"]["bulk_temperature"] - heat["initial_temperature"]
    shaft = max(rim - heat["shaft_temperature_drop"], 0.0)
    radii, _ = curvature(geometry)
    grown, with_flash, rims = list[Growth](), list[Growth](), []
    for i, name in enumerate(GEARS):
        base, expansion = float(geometry["base_radius"][i]), cfg["material"][name]["thermal_expansion"]
        rims.append(base_circle_growth(shaft, rim, float(geometry["bore_radius"][i]), base, expansion, heat["hub"]))
        for rise, results in ((np.full_like(flash, rim), grown), (rim + flash, with_flash)):
            half = float(geometry["base_half_angle"][i])
            results.append(flank_growth(radii[i], base, half, rise, rims[i], expansion, heat["growth"]))
    chosen = grown if heat["temperature_rise"] == "bulk" else with_flash
    extra = np.stack([hot.growth - cool.growth for hot, cool in zip(with_flash, grown, strict=True)])
    along = ("gear", "path")
    values = {
        "thermal_growth": (along, np.stack([one.growth for one in chosen])),
        "thermal_growth_flash": (along, extra),
        "involute_error": (along, np.stack([one.involute_error for one in chosen])),
        "base_circle_growth": ("gear", np.array(rims)),
    }
    return xr.Dataset(values, {"path": geometry["path"], "gear": geometry["gear"]})
