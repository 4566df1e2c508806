"""The table of the shifts: a row for every event, numbers or what lacks."""

import numpy as np
import pytest
import xarray as xr

from gearwear.codes.onset_codes import VARIANTS
from gearwear.onsets import table
from gearwear.onsets.shifts import shifts

NAN = np.nan


@pytest.fixture
def rows(make_onsets):
    """Rows of a study with two faces and two drawn members, of which one lacks chaos in case `with`."""
    places = {"without": [1.04, 1.19, NAN, 1.30], "with": [1.00, 1.16, 1.23, 1.25]}
    names = ["damping_ratio_low", "bore_radius_high", "box_001", "box_002"]
    members = {case: dict.fromkeys(names, make_onsets(own)) for case, own in places.items()}
    members["with"]["box_002"] = make_onsets([1.01, 1.16, 1.23, NAN])
    members["with"]["bore_radius_high"] = make_onsets([1.02, 1.16, 1.23, 1.25])
    variants = {}
    for case, own in places.items():
        ways = [make_onsets([own[0] + (0.01 if case == "with" and i == 1 else 0), *own[1:]]) for i in range(8)]
        variants[case] = xr.concat(ways, "variant").assign_coords(variant=np.array(VARIANTS, dtype=object))
    onsets = {case: make_onsets(own) for case, own in places.items()}
    return table.rows(shifts(onsets, variants, members, "restart", {name: {"damping_ratio": 1.1} for name in names}))


def test_a_row_holds_shift_errors_ensemble_and_faces(rows):
    assert rows[0] == {
        "event": "period 1 to 2",
        "without": "1.040000",
        "with": "1.000000",
        "shift": "-0.040000",
        "lowest": "-0.040000",
        "highest": "-0.030000",
        "numerical_error": "1.0e-02",
        "error_resolution": "0.0e+00",
        "error_start": "1.0e-02",
        "error_settling": "0.0e+00",
        "error_step": "0.0e+00",
        "error_integrator": "0.0e+00",
        "ways_without_the_event": "none",
        "members": "2",
        "members_with_event": "2",
        "median": "-0.035000",
        "percentile_5": "-0.039500",
        "percentile_95": "-0.030500",
        "share_earlier": "1.00",
        "damping_ratio_low": "-0.040000",
        "bore_radius_high": "-0.020000",
        "lacking": "none",
    }


def test_what_lacks_is_named_with_member_case_and_reason(rows):
    chaos, third = rows[3], rows[2]
    assert (chaos["members_with_event"], chaos["median"], chaos["share_earlier"]) == ("1", "none", "1.00")
    assert chaos["lacking"] == "box_002 with: remark 0"
    assert (third["without"], third["shift"], third["numerical_error"], third["median"]) == ("none",) * 4
    assert third["lacking"].split("; ")[0] == "damping_ratio_low without: remark 0"
    assert len(third["lacking"].split("; ")) == 4
    assert third["ways_without_the_event"] == "; ".join(VARIANTS)
