"""Gear pairs and their meshes, with the variables of the geometry stage but without its file."""

import numpy as np
import pytest
import xarray as xr

from gearwear.geometry.contact_path import contact_path
from gearwear.geometry.involute import GEARS, gear_pair

ALONG_PATH = ("path", "path_phase", "partner")


@pytest.fixture(scope="session")
def make_pair():
    """Return a function that makes a gear pair from (pinion, gear) tuples; lengths in m."""

    def make(
        teeth,
        module=3e-3,
        face_width=20e-3,
        bore=(10e-3, 10e-3),
        shift=(0.0, 0.0),
        centre_distance=None,
        addendum=(1.0, 1.0),
        clearance=0.25,
    ):
        def both(values):
            return dict(zip(GEARS, values, strict=True))

        return gear_pair(
            both(teeth),
            module,
            face_width,
            20.0,
            both(addendum),
            clearance,
            both(shift),
            centre_distance,
            both(bore),
        )

    return make


@pytest.fixture(scope="session")
def make_geometry(make_pair):
    """Return a function that makes the dataset of a gear pair and its path of contact."""

    def make(*args, mesh_cells=240, **kwargs):
        pair = make_pair(*args, **kwargs)
        values = {"equivalent_mass": 0.5}
        for name, value in pair._asdict().items():
            values[name] = ("gear", value) if np.ndim(value) else value
        for name, value in contact_path(pair, mesh_cells)._asdict().items():
            dim = "path" if name in ALONG_PATH else "mesh_phase"
            values[name] = (dim, value) if np.ndim(value) else value
        return xr.Dataset(values).set_coords(["path", "mesh_phase"])

    return make


@pytest.fixture(scope="session")
def benchmark_pair(make_geometry):
    """Geometry of the pair of the default study."""
    return make_geometry((19, 48), 3.175e-3, 16e-3, bore=(10e-3, 25e-3))
