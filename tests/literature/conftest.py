"""Gear pairs given by a few numbers, through the stage that makes the geometry."""

from types import SimpleNamespace

import pytest

import build_geometry
from gearwear.geometry.involute import GEARS
from gearwear.plumbing import store


class Inputs(SimpleNamespace):
    """Named input files of a job."""

    def items(self):
        return vars(self).items()


@pytest.fixture(scope="session")
def make_geometry(tmp_path_factory):
    """Return a function that makes the dataset of an unshifted pair with 20 deg racks; lengths in m."""

    def make(teeth, module, face_width, bore, mesh_cells=240, **changes):
        def both(values):
            return dict(zip(GEARS, values, strict=True))

        settings = {
            "teeth": both(teeth),
            "module": module,
            "face_width": face_width,
            "pressure_angle": 20.0,
            "addendum_coefficient": both((1.0, 1.0)),
            "clearance_coefficient": 0.25,
            "profile_shift": both((0.0, 0.0)),
            "centre_distance": None,
            "bore_radius": both(bore),
            "inertia": both((None, None)),
        }
        steel = {name: {"density": 7850.0} for name in GEARS}
        cfg = {"gear_pair": settings | changes, "grid": {"mesh_cells": mesh_cells}, "material": steel}
        path = tmp_path_factory.mktemp("geometry") / "geometry.nc"
        params = SimpleNamespace(cfg=cfg, code="0")
        build_geometry.main(SimpleNamespace(rule="build_geometry", input=Inputs(), output=[path], params=params))
        return store.load(path)

    return make
