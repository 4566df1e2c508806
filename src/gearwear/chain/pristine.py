"""Pristine flanks: the wear depth before the first cycle."""

from __future__ import annotations

import numpy as np
import xarray as xr


def unworn(geometry: xr.Dataset) -> xr.Dataset:
    """Return the flanks without wear."""
    none = np.zeros((geometry.sizes["gear"], geometry.sizes["path"]))
    values = {
        "wear_depth": (("gear", "path"), none),
        "wear_per_revolution": (("gear", "path"), none),
        "running_cycles": 0.0,
    }
    return xr.Dataset(values, {"path": geometry["path"], "gear": geometry["gear"]})
