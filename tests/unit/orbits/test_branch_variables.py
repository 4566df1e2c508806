"""Branches as a table."""

import numpy as np
import pytest
import xarray as xr

from gearwear.codes.branch_codes import HALVED, PERIOD_DOUBLING, RANGE_END
from gearwear.orbits.branch_variables import columns
from gearwear.orbits.branches import Seed, explore
from gearwear.orbits.continuation import Limits


@pytest.fixture(scope="module")
def branches(henon):
    return explore(henon, [Seed(0.2, (0.9, 0.27), 1)], Limits(-0.5, 0.8), 3)


def test_every_orbit_is_a_node_of_its_branch(branches):
    table = xr.Dataset(columns(branches, 3, "ste"))
    assert dict(table.sizes) == {
        "node": sum(len(branch.nodes) for branch in branches),
        "iterate": 3,
        "multiplier": 2,
        "branch": 2,
    }
    assert table["branch_period"].values.tolist() == [1, 2]
    assert table["branch_parent"].values.tolist() == [-1, 0]
    for i, branch in enumerate(branches):
        nodes = table.isel(node=table["branch_index"].values == i)
        assert nodes["ste"].values.tolist() == [node.orbit.value for node in branch.nodes]
        section = nodes["branch_displacement"].values
        assert np.isnan(section[:, branch.period :]).all()
        assert section[:, : branch.period] == pytest.approx(np.array([n.orbit.section[:, 0] for n in branch.nodes]))
        assert nodes["branch_velocity"].values[:, 0] == pytest.approx(
            np.array([n.orbit.section[0, 1] for n in branch.nodes])
        )
        assert nodes["stable"].values.tolist() == [node.orbit.stable for node in branch.nodes]
        assert nodes["special_point"].values.tolist() == [node.special for node in branch.nodes]


def test_multipliers_multiply_to_the_determinant(branches):
    table = xr.Dataset(columns(branches, 3, "ste"))
    multipliers = table["floquet_real"].values + 1j * table["floquet_imag"].values
    periods = table["branch_period"].values[table["branch_index"].values]
    assert multipliers.prod(axis=1) == pytest.approx((-0.3) ** periods, abs=1e-9)
    doubling = table["special_point"].values == PERIOD_DOUBLING
    assert multipliers[doubling, 0] == pytest.approx(-1, abs=1e-7)


def test_ends_and_their_words(branches):
    table = xr.Dataset(columns(branches, 3, "ste"))
    assert (table["branch_start"].values[1], table["branch_end"].values[1]) == (HALVED, RANGE_END)
    assert table["branch_start_remark"].values[1] == "the orbit has half the period at 0.3675"
    assert table["branch_end_remark"].values[1] == "the range of the parameter ends at 0.8"


def test_no_branches_are_an_empty_table():
    table = xr.Dataset(columns([], 4, "ste"))
    assert dict(table.sizes) == {"node": 0, "iterate": 4, "multiplier": 2, "branch": 0}
