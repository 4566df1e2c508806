"""Outcomes over the axes of a study."""

import numpy as np
import xarray as xr

from gearwear.studies.gathering import axes_of, gathered


def outcome(number):
    return xr.Dataset({"mean_stiffness": float(number), "force_max": ("point", [number, number + 0.5])})


def test_the_last_axis_changes_fastest_and_every_member_finds_its_place():
    axes = {"dynamics.damping_ratio": [0.05, 0.1], "wear.law": ["constant", "janakiraman", "third"]}
    names = [f"m{i}" for i in range(6)]
    study = gathered(axes, names, [outcome(i) for i in range(6)])
    assert study["force_max"].dims == ("dynamics.damping_ratio", "wear.law", "point")
    one = study.sel({"dynamics.damping_ratio": 0.1, "wear.law": "janakiraman"})
    assert one["mean_stiffness"] == 4.0 and one["force_max"].values.tolist() == [4.0, 4.5]
    assert one["member_name"].item() == "m4"
    assert study["dynamics.damping_ratio"].dtype == np.float64


def test_members_without_a_grid_are_an_axis_by_name():
    study = {"grid": {}, "members": {"thin": {}, "thick": {}}}
    found = gathered(axes_of(study), ["thin", "thick"], [outcome(1), outcome(2)])
    assert found.sel(member="thick")["mean_stiffness"] == 2.0
    assert "member_name" not in found


def test_flags_are_named_as_the_configuration_writes_them():
    found = gathered({"cases.with.flash": [False, True]}, ["a", "b"], [outcome(1), outcome(2)])
    assert found["cases.with.flash"].values.tolist() == ["false", "true"]
