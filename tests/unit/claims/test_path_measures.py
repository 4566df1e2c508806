import numpy as np
import pytest
import xarray as xr

from gearwear.claims.path_measures import double_contact, jump_ratios, jumps_everywhere
from gearwear.claims.study import Undecided
from gearwear.geometry.path_mean import path_mean


def test_mean_weighs_by_length_and_ignores_doubled_nodes():
    field = xr.DataArray([0.0, 0.0, 3.0, 3.0], {"path": [0.0, 1.0, 1.0, 4.0]}, ["path"])
    assert path_mean(field) == pytest.approx(9 / 4)


def test_double_contact_is_the_phase_before_the_exit_of_the_leading_pair(study):
    stiffness = study.field("mesh_stiffness", "mesh_stiffness", "without", 0)
    double = double_contact(study, stiffness)
    np.testing.assert_array_equal(double, stiffness["mesh_phase"].values < 14 / 8.5 - 1)


def test_one_zone_only_is_undecided(study):
    stiffness = study.field("mesh_stiffness", "mesh_stiffness", "without", 0).isel(mesh_phase=slice(0, 5))
    with pytest.raises(Undecided, match="single and a double"):
        double_contact(study, stiffness)


def stepped(study, jump: float) -> xr.DataArray:
    """Return a field of unit steps between the nodes that rises by `jump` between the one-sided values."""
    field = study.field("backlash_path", "backlash", "without", 0)
    steps = np.where(np.diff(field["path"].values) == 0, jump, 1.0)
    return field.copy(data=np.concatenate([[0.0], np.cumsum(steps)]))


def test_jump_is_measured_in_neighbouring_steps(study):
    assert jump_ratios(study, stepped(study, 6.0)) == pytest.approx([6.0, 6.0])


def test_limit_of_a_jump(study):
    assert jumps_everywhere(jump_ratios(study, stepped(study, 5.1)))
    assert not jumps_everywhere(jump_ratios(study, stepped(study, -4.9)))
    assert not jumps_everywhere([4.0, 9.0])


def test_flat_field_with_rounding_has_no_jump(study):
    field = study.field("backlash_path", "backlash", "without", 0)
    flat = field.copy(data=np.ones(field.size))
    flat.values[field["path"].values > 8e-3] += 1e-15
    assert jump_ratios(study, flat) == [0.0, 0.0]


def test_step_function_jumps_without_bound(study):
    field = study.field("elastic_deflection", "transmission_error", "with", 2)
    assert jump_ratios(study, field) == [np.inf, np.inf]


def test_path_without_one_sided_nodes_is_undecided(study):
    field = study.field("backlash_path", "backlash", "without", 0)
    single = field.isel(path=np.unique(field["path"].values, return_index=True)[1])
    with pytest.raises(Undecided, match="one-sided"):
        jump_ratios(study, single)
