"""The table: changes against the study, shifts between the cases, members that cannot be."""

import numpy as np
import pytest
import xarray as xr

from gearwear.sensitivity import table
from gearwear.sensitivity.quantities import QUANTITIES, Quantity

NAN = np.nan


def measured(stiffness=(300e6, 290e6), wear=15e-6, doubling=(1.04, 1.00), hindrance=("", "")):
    """Measures of both cases."""
    return xr.Dataset(
        {
            "mean_stiffness": ("case", list(stiffness)),
            "stiffness_ripple": ("case", [0.3, 0.3]),
            "relative_mean_error": ("case", [1.0, 1.1]),
            "mean_half_backlash": ("case", [70e-6, 65e-6]),
            "deepest_wear": (("case", "gear"), [[0.0, 0.0], [wear, 1e-6]]),
            "first_doubling": ("case", list(doubling)),
            "first_doubling_remark": ("case", np.array(["met", "met"], dtype=object)),
            "chaos_onset": ("case", [1.3, 1.25]),
            "chaos_onset_remark": ("case", np.array(["met", "met"], dtype=object)),
            "hindrance": ("case", np.array(hindrance, dtype=object)),
        },
        {"case": np.array(["without", "with"], dtype=object), "gear": ["pinion", "gear"]},
    )


def variation(name, hindrance=""):
    return {
        "name": name,
        "group": "option",
        "key": "heat.growth",
        "value": name,
        "usual": "paper",
        "companions": "",
        "hindrance": hindrance,
    }


@pytest.fixture
def rows():
    members = [
        measured(stiffness=(300e6, 319e6), doubling=(1.05, 1.02)),
        measured(doubling=(1.04, NAN), wear=NAN, hindrance=("", "the teeth jam")),
    ]
    varied = [variation("one"), variation("refused", "too cold"), variation("two")]
    return {row["member"]: row for row in table.rows(table.compared(measured(), members, varied))}


def test_the_study_is_the_first_row_and_differs_from_itself_by_nothing(rows):
    assert list(rows) == ["study", "one", "refused", "two"]
    changes = {name: value for name, value in rows["study"].items() if name.startswith("change_")}
    assert len(changes) == len(QUANTITIES) and set(changes.values()) == {"0"}


def test_changes_are_relative_or_differences(rows):
    row = rows["one"]
    assert float(row["change_mean_stiffness_with"]) == pytest.approx(0.1)
    assert row["change_mean_stiffness_without"] == "0"
    assert float(row["change_first_doubling_with"]) == pytest.approx(0.02)
    assert float(rows["study"]["first_doubling_shift"]) == pytest.approx(-0.04)
    assert float(row["first_doubling_shift"]) == pytest.approx(-0.03)
    assert float(row["change_first_doubling_shift"]) == pytest.approx(0.01)


def test_what_lacks_is_none_and_what_cannot_be_says_why(rows):
    assert rows["two"]["first_doubling_with"] == rows["two"]["change_first_doubling_shift"] == table.NOTHING
    assert rows["two"]["hindrance"] == "the teeth jam" and rows["one"]["hindrance"] == table.NOTHING
    assert rows["refused"]["hindrance"] == "too cold"
    assert {rows["refused"][quantity.name] for quantity in QUANTITIES} == {table.NOTHING}


def test_every_member_keeps_its_own_measures(rows):
    assert [float(rows[name]["mean_stiffness_with"]) for name in ("study", "one", "two")] == [290e6, 319e6, 290e6]


def test_a_change_of_nothing_has_no_ratio():
    wear = Quantity("deepest_wear", "with", "pinion")
    assert np.isnan(wear.change(np.array([0.0, 1e-6]), 0.0)).all()
