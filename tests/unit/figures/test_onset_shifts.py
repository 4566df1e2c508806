"""The figure of the onset shifts: numbers where they belong, words where an event lacks."""

import numpy as np
import pytest
import xarray as xr
from matplotlib.figure import Figure

from gearwear.codes.onset_codes import ERRORS, EVENTS, RESOLUTION
from gearwear.figures import onset_shifts

NAN = np.nan
MEMBERS = ("damping_ratio_low", "damping_ratio_high", "box_001", "box_002", "box_003")


@pytest.fixture
def table():
    """Two parameters, of which one is varied; chaos lacks in the study, with a high damping and in one drawn member."""
    shift = np.array([-0.04, -0.03, -0.04, NAN])
    members = np.array([shift - 0.01, shift + 0.01, shift - 0.02, shift, shift + 0.02])
    members[:, 3] = [-0.05, NAN, -0.06, NAN, -0.04]
    errors = np.zeros((len(ERRORS), 4))
    errors[ERRORS.index(RESOLUTION)] = 0.001
    return xr.Dataset(
        {
            "onset_shift": ("event", shift),
            "shift_error": (("error", "event"), errors),
            "variant_shift": (("variant", "event"), [shift, shift - 0.01, shift + 0.02]),
            "member_shift": (("member", "event"), members),
            "factor": (("member", "parameter"), [[0.9, 1.0], [1.1, 1.0], [1.0, 1.0], [0.95, 1.0], [1.05, 1.0]]),
        },
        {
            "event": list(EVENTS),
            "error": list(ERRORS),
            "member": list(MEMBERS),
            "parameter": ["damping_ratio", "pinion_torque"],
        },
    )


@pytest.fixture
def panels(table):
    figure = Figure(layout="constrained")
    onset_shifts.draw(figure, table, {})
    return figure.axes


def dots(axes, marker):
    return [
        tuple(np.round(np.array(line.get_xdata(), dtype=float), 6))
        for line in axes.lines
        if line.get_marker() == marker
    ]


def words(axes):
    return [text.get_text() for text in axes.texts]


def test_rows_are_named_with_what_they_vary(panels):
    labels = [label.get_text() for label in panels[0].get_yticklabels()]
    assert labels == ["this study", "ensemble of 3", "damping ratio\n× 0.9 and 1.1", "pinion torque\n× 1"]
    assert [axes.get_title(loc="left")[4:] for axes in panels] == list(EVENTS)


def test_shift_members_and_ends_stand_where_they_belong(panels):
    assert dots(panels[0], "D") == [(-0.04,)]
    assert dots(panels[0], "o") == [(-0.06, -0.04, -0.02)]
    assert dots(panels[0], "v") == [(-0.05,)]
    assert dots(panels[0], "^") == [(-0.03,)]
    assert words(panels[0]) == []


def test_the_bar_holds_every_way_of_computing_and_no_more_than_the_resolution(panels):
    segments = panels[0].collections[0].get_segments()[0]
    assert segments[:, 0] == pytest.approx([-0.051, -0.019])


def test_what_lacks_is_said(panels):
    assert words(panels[3]) == ["no such event", "2 of 3", "none at high"]
    assert dots(panels[3], "^") == [] and len(dots(panels[3], "o")) == 1


def test_all_panels_share_one_scale_that_holds_everything(panels):
    low, high = panels[0].get_xlim()
    assert low < -0.06 and high > 0.0
    assert {axes.get_xlim() for axes in panels} == {(low, high)}


def test_an_ensemble_without_drawn_members_says_so(table):
    figure = Figure(layout="constrained")
    onset_shifts.draw(figure, table.isel(member=[0, 1]), {})
    assert words(figure.axes[0]) == ["no members"]
