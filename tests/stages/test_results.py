"""What the files of the stages hold, and that the same settings give the same bytes."""

import json

import numpy as np
import pytest

from gearwear.io.variables import variable_of, variables

PATH, PHASE, BOTH = ("path",), ("mesh_phase",), ("gear", "path")
CONTENTS = {
    "geometry": {
        "path": PATH,
        "partner": PATH,
        "mesh_phase": PHASE,
        "mesh_phase_width": PHASE,
        "base_radius": ("gear",),
        "tip_relief": BOTH,
        "spacing": PATH,
    },
    "temperature": {
        "contact_temperature": PATH,
        "flash_temperature": PATH,
        "friction_coefficient": PATH,
        "film_ratio": PATH,
        "hertz_half_width": PATH,
        "load_per_width": PATH,
        "surface_speed": BOTH,
        "flash_sensitivity": ("influence",),
        "mesh_loss": (),
        "churning_loss": (),
        "convection": (),
    },
    "deformation": {
        "thermal_growth": BOTH,
        "thermal_growth_flash": BOTH,
        "involute_error": BOTH,
        "base_circle_growth": ("gear",),
    },
    "wear": {"wear_depth": BOTH, "wear_per_revolution": BOTH, "running_cycles": ()},
    "mesh_stiffness": {
        "mesh_stiffness": PHASE,
        "pair_stiffness": PATH,
        "pair_coupling": PATH,
        "hertz_compliance": PATH,
        "bending_compliance": BOTH,
        "shear_compliance": BOTH,
        "axial_compliance": BOTH,
        "foundation_compliance": BOTH,
        "youngs_modulus": ("gear",),
    },
    "transmission_error": {
        "transmission_error": PHASE,
        "effective_stiffness": PHASE,
        "load_sharing_factor": ("mesh_phase", "pair"),
        "load_share_path": PATH,
        "elastic_deflection": PATH,
        "profile_error": PATH,
        "sharing_error": PATH,
    },
    "backlash": {
        "backlash": PHASE,
        "backlash_path": PATH,
        "initial_half_backlash": (),
        "centre_distance_change": (),
    },
}


@pytest.mark.parametrize("case", ["without", "with", "wear_only"])
@pytest.mark.parametrize("stage", CONTENTS)
def test_file_holds_its_variables(states, loaded, case, stage):
    dataset = loaded(states(case), stage)
    for name, dims in CONTENTS[stage].items():
        assert dataset[name].dims == dims
        assert np.isfinite(dataset[name].values).all() if dataset[name].dtype.kind == "f" else True
        units = variable_of(name, dims).units
        assert dataset[name].attrs.get("units", "") == units
        assert dataset[name].attrs["long_name"]
    assert set(dataset.variables) - set(CONTENTS[stage]) <= set(variables())


@pytest.mark.parametrize("stage", CONTENTS)
def test_file_names_its_settings_and_its_inputs(states, loaded, stage):
    dataset = loaded(states("with"), stage)
    assert dataset.attrs["lineage"]
    assert json.loads(dataset.attrs["config"]) is not None
    assert ("geometry" in json.loads(dataset.attrs["inputs"])) == (stage != "geometry")


def test_grids_are_the_same_in_every_file(states, loaded):
    files = states("with")
    geometry = loaded(files, "geometry")
    for stage in CONTENTS:
        dataset = loaded(files, stage)
        for name in ("path", "mesh_phase"):
            if name in dataset.coords:
                assert np.array_equal(dataset[name].values, geometry[name].values)


def test_same_settings_give_the_same_bytes(study, run_chain):
    twice = [run_chain(study(), "with") for _ in range(2)]
    for name in twice[0]:
        assert twice[0][name].read_bytes() == twice[1][name].read_bytes()
