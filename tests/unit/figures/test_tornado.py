"""The tornado charts: rows by size, both ends in one row, words where a quantity lacks or a member cannot be."""

import numpy as np
import pytest
import xarray as xr
from matplotlib.figure import Figure

from gearwear.figures import tornado
from gearwear.sensitivity.quantities import Quantity

NAN = np.nan
STIFFNESS = Quantity("mean_stiffness", "with")
CHAOS = Quantity("chaos_onset", "with", relative=False)
MEMBERS = {
    "study": ("", "", "", 300e6, 1.25),
    "a": ("option", "heat.growth", "consistent", 303e6, NAN),
    "b": ("option", "heat.hub", "solid_shaft", 270e6, 1.25),
    "c": ("option", "wear.law", "constant", NAN, NAN),
    "damping_ratio_low": ("parameter", "dynamics.damping_ratio", "0.06", 300e6, 1.15),
    "damping_ratio_high": ("parameter", "dynamics.damping_ratio", "0.11", 300e6, 1.30),
    "pinion_torque_high": ("parameter", "operation.pinion_torque", "156.0", 300e6, 1.27),
}


@pytest.fixture
def table():
    """Three options, of which one cannot be, and two parameters, of which one has one end only."""
    groups, keys, values, stiffness, chaos = zip(*MEMBERS.values(), strict=True)
    both = ("member", "case")
    hindrance = np.full((len(MEMBERS), 2), "", dtype=object)
    hindrance[list(MEMBERS).index("c"), 1] = "too much"

    def cases(column):
        return both, np.transpose([column, column])

    return xr.Dataset(
        {
            "group": ("member", list(groups)),
            "key": ("member", list(keys)),
            "value": ("member", list(values)),
            "mean_stiffness": cases(stiffness),
            "chaos_onset": cases(chaos),
            **{name: cases(np.ones(len(MEMBERS))) for name in ("stiffness_ripple", "relative_mean_error")},
            **{name: cases(np.ones(len(MEMBERS))) for name in ("mean_half_backlash", "first_doubling")},
            "deepest_wear": ((*both, "gear"), np.ones((len(MEMBERS), 2, 2))),
            "hindrance": (both, hindrance),
        },
        {"member": list(MEMBERS), "case": ["without", "with"], "gear": ["pinion", "gear"]},
    )


def test_options_come_by_size_and_without_those_that_cannot_be(table):
    rows = tornado.options(table, STIFFNESS)
    assert [row.label for row in rows] == ["heat hub solid shaft", "heat growth consistent"]
    assert [row.bars[0][0] for row in rows] == pytest.approx([-0.1, 0.01])


def test_a_quantity_that_lacks_comes_first(table):
    rows = tornado.options(table, CHAOS)
    assert [row.label for row in rows] == ["heat growth consistent", "heat hub solid shaft"]
    assert np.isinf(rows[0].size) and rows[1].size == 0


def test_parameters_have_both_ends_in_one_row(table):
    rows = tornado.parameters(table, CHAOS)
    assert [row.label for row in rows] == ["damping ratio", "pinion torque"]
    assert [change for change, _ in rows[0].bars] == pytest.approx([-0.1, 0.05])
    assert len(rows[1].bars) == 1


def test_an_end_that_cannot_be_has_no_bar(table):
    table["hindrance"][list(MEMBERS).index("damping_ratio_low"), 1] = "too little"
    rows = tornado.parameters(table, CHAOS)
    assert [len(row.bars) for row in rows if row.label == "damping ratio"] == [1]


def test_panels_say_what_lacks_and_what_cannot_be(table):
    figure = Figure(layout="constrained")
    tornado.draw(figure, table, {})
    panels = {axes.get_title(loc="left")[4:]: axes for axes in figure.axes}
    assert len(panels) == 9
    words = [text.get_text() for text in panels["onset of chaos"].texts]
    assert words == ["none"]
    assert figure.get_supxlabel().startswith("Not possible: wear law constant")
    stiffness = panels["mean stiffness"]
    assert stiffness.get_xlabel() == "Change, % of 300 N/µm"
    assert sorted(round(bar.get_width(), 6) for bar in stiffness.patches) == [-10, 0, 0, 0, 1]


def test_small_changes_of_options_are_told_in_words(table, monkeypatch):
    monkeypatch.setattr(tornado, "_MOST_OPTIONS", 1)
    figure = Figure(layout="constrained")
    tornado.draw(figure, table, {})
    assert [text.get_text() for text in figure.axes[0].texts] == ["1 more, at most 1 %"]


def test_a_study_without_the_quantity_has_no_bars(table):
    table["chaos_onset"][0] = NAN
    figure = Figure(layout="constrained")
    tornado.draw(figure, table, {})
    panels = {axes.get_title(loc="left")[4:]: axes for axes in figure.axes}
    assert [text.get_text() for text in panels["onset of chaos"].texts] == ["the study has none"]
    assert not panels["onset of chaos"].patches
