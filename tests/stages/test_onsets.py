"""The stages of the onsets, from the sweeps of a coarse pristine pair to the table and the figure."""

from pathlib import Path

import numpy as np
import pytest

from gearwear.codes.onset_codes import EVENTS, MET, PASSED_BY, VARIANTS
from gearwear.config import ensemble
from gearwear.config.slices import slice_of
from gearwear.figures import onset_shifts as figure_of_shifts
from gearwear.io import store
from gearwear.stages.motion import branches, sweep
from gearwear.stages.onsets import case_onsets, member_onsets, onset_shifts, onset_variants

STYLE = str(Path(__file__).resolve().parents[2] / "workflow" / "report" / "gearwear.mplstyle")
SWEEP = "mesh_frequency"
CHANGES = {
    "sweeps.mesh_frequency.first": 1.0,
    "sweeps.mesh_frequency.last": 1.32,
    "sweeps.mesh_frequency.points": 41,
    "portraits.mesh_frequency.without": [1.0423],
    "portraits.mesh_frequency.with": [1.0470],
    "basins.points.mesh_frequency": {},
    "settling.transient_periods": 200,
    "settling.longest_transient": 1600,
    "settling.sampled_periods": 96,
    "settling.largest_period": 16,
    "onsets.refinement": 4,
    "onsets.members": 1,
}


@pytest.fixture(scope="module")
def cfg(study):
    """Return a function that gives the slice of a stage of the coarse study."""
    config = study(CHANGES)
    return lambda stage: slice_of(config, stage, "without", SWEEP)


@pytest.fixture(scope="module")
def onsets(study, cfg, states, with_reference, run_stage):
    """Onsets of the pristine pair, and their variants."""
    source = run_stage("excitation", study(CHANGES), "without", with_reference(states("without")))
    sweeps = list(sweep(cfg("sweep"), source, [], SWEEP).values())
    found = branches(cfg("branches"), source, sweeps, SWEEP)
    settings = cfg("case_onsets")
    return case_onsets(settings, source, sweeps[0], found), onset_variants(settings, source, sweeps, found)


def figure(shifts, folder):
    """Return the bytes of the figure as SVG and PNG."""
    folder.mkdir()
    store.save(shifts, folder / "shifts.nc", store.Origin("onset_shifts", {}, ""))
    svg, png = folder / "onsets.svg", folder / "onsets.png"
    figure_of_shifts.draw.write({"shifts": store.load(folder / "shifts.nc"), "cfg": {}}, STYLE, svg, png)
    return [path.read_bytes() for path in (svg, png)]


def test_events_of_the_pristine_pair_are_located(onsets):
    table = onsets[0]
    assert list(table["event"].values) == list(EVENTS)
    assert table["onset"].values[:3] == pytest.approx([1.0438, 1.1889, 1.2719], abs=2e-3)
    assert 1.272 < table["onset"].values[3] < 1.31
    meanings = store.attributes_of("onset_how", ("event",), table["onset_how"].dtype)["flag_meanings"]
    assert meanings.split() == ["absent", "met", "passed_by", "below_range"]
    assert table["onset_how"].values.tolist() == [MET, MET, PASSED_BY, MET]  # the step is too long to show period 8


def test_variants_hold_the_events_in_every_way(onsets):
    located, varied = onsets
    assert list(varied["variant"].values) == list(VARIANTS)
    usual = varied.sel(variant="restart")
    np.testing.assert_array_equal(usual["onset_seen"].values, located["onset_seen"].values)
    assert varied["onset_seen"].sel(variant="up").values[1] > 1.2
    moved = np.abs(varied["onset_seen"].values[-2:, :3] - located["onset"].values[:3])
    assert 0 < moved[np.isfinite(moved)].max() < 1e-7


@pytest.fixture(scope="module")
def member(cfg):
    """Onsets of a member with the settings of the study."""
    return member_onsets(cfg("member_onsets"))


def test_a_member_in_one_process_has_the_onsets_of_the_stages(onsets, member):
    own = member.sel(case="without")
    for name in onsets[0].data_vars:
        np.testing.assert_array_equal(own[name].values, onsets[0][name].values, err_msg=name)


def test_comparison_gives_a_row_an_event_and_a_figure(cfg, study, onsets, member, tmp_path):
    names = list(ensemble.factors(study(CHANGES)["onsets"]))
    assert len(names) == 9
    found = onset_shifts(cfg("onset_shifts"), [onsets[0]] * 2, [onsets[1]] * 2, [member] * len(names))
    rows = [dict(zip(found["table"].columns, row, strict=True)) for row in found["table"].rows]
    assert [row["event"] for row in rows] == list(EVENTS)
    assert {row["shift"] for row in rows} == {"0.000000"}
    assert {row["members"] for row in rows} == {"1"} and {row["members_with_event"] for row in rows} == {"1"}
    places = member["onset"]
    moved = (places.sel(case="with") - places.sel(case="without")).values
    assert np.isfinite(moved).any()
    for row, shift in zip(rows, moved, strict=True):
        assert row["damping_ratio_low"] == ("none" if np.isnan(shift) else f"{shift:.6f}")
    table = found["shifts"]
    assert figure(table, tmp_path / "one") == figure(table, tmp_path / "two")
    assert list(table["member"].values) == names
    assert table["factor"].sel(member="bore_radius_high").values.tolist() == [1.0, 1.25, 1.0, 1.0]
