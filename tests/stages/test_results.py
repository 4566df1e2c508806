"""What the results of the stages hold, and that the same settings give the same bytes."""

import numpy as np
import pytest
import xarray as xr

from gearwear.io import store
from gearwear.io.variables import variable_of

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
        "involute_error": BOTH,
        "base_circle_growth": ("gear",),
    },
    "flash_growth": {"thermal_growth_flash": BOTH},
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
def test_file_holds_its_variables(states, tmp_path, case, stage):
    made = states(case)[stage]
    store.save(made, tmp_path / "made.nc", store.Origin(stage, {}, ""))
    dataset = store.load(tmp_path / "made.nc")
    xr.testing.assert_equal(dataset, made)
    for name, dims in CONTENTS[stage].items():
        assert dataset[name].dims == dims
        assert np.isfinite(dataset[name].values).all() if dataset[name].dtype.kind == "f" else True
        units = variable_of(name, dims).units
        assert dataset[name].attrs.get("units", "") == units
        assert dataset[name].attrs["long_name"]


def test_grids_are_the_same_in_every_dataset(states):
    state = states("with")
    for stage in CONTENTS:
        for name in ("path", "mesh_phase"):
            if name in state[stage].coords:
                assert np.array_equal(state[stage][name].values, state["geometry"][name].values)


def test_same_settings_give_the_same_bytes(study, run_chain, tmp_path):
    files = [tmp_path / name for name in ("one", "two")]
    for folder in files:
        folder.mkdir()
        for name, dataset in run_chain(study(), "with").items():
            store.save(dataset, folder / f"{name}.nc", store.Origin(name, {}, ""))
    assert len(list(files[0].iterdir())) == len(CONTENTS)
    for path in files[0].iterdir():
        assert path.read_bytes() == (files[1] / path.name).read_bytes()
