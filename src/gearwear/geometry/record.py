"""The dimensions of a gear pair and its path of contact as one dataset."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr

from gearwear.geometry.contact_path import ContactPath
from gearwear.geometry.involute import GEARS, GearPair

_ON_PATH = ("path", "path_phase", "partner")


def dataset(pair: GearPair, mesh: ContactPath) -> xr.Dataset:
    """Return every dimension under its name; coordinates are `gear`, `path` (m) and `mesh_phase`."""
    values: dict[str, Any] = {"gear": list(GEARS)}
    for name, value in pair._asdict().items():
        values[name] = ("gear", value) if np.ndim(value) else value
    for name, value in mesh._asdict().items():
        values[name] = ("path" if name in _ON_PATH else "mesh_phase", value) if np.ndim(value) else value
    return xr.Dataset(values).set_coords(["gear", "path", "mesh_phase"])
