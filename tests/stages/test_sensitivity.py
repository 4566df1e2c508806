"""The sensitivity, from the measures of a coarse study to the table and the figure."""

from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from gearwear.config.slices import slice_of
from gearwear.config.variations import variations
from gearwear.figures import tornado
from gearwear.io import store
from gearwear.sensitivity import measures as module
from gearwear.stages.studies import measures, sensitivity_comparison

STYLE = str(Path(__file__).resolve().parents[2] / "workflow" / "report" / "gearwear.mplstyle")
CHANGES = {
    "cases.with.running_cycles": 2e8,
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
}
FEW = {"sweeps.mesh_frequency.points": 2}


@pytest.fixture(scope="module")
def measured(study):
    """Measures of the coarse study."""
    return measures(slice_of(study(CHANGES), "measures"))


def test_measures_of_the_coarse_study(measured):
    found = measured
    assert found["case"].values.tolist() == ["without", "with"] and set(found["hindrance"].values) == {""}
    cold, hot = found["first_doubling"].values
    assert cold == pytest.approx(1.0438, abs=2e-3) and hot < cold - 0.005  # as in test_onsets
    assert 1.272 < found["chaos_onset"].values[0] < 1.31
    assert found["mean_stiffness"].values[1] < found["mean_stiffness"].values[0]
    assert found["deepest_wear"].values[0].tolist() == [0.0, 0.0] and (found["deepest_wear"].values[1] > 0).all()
    assert found["relative_mean_error"].values[0] == 1.0


def test_a_sweep_up_starts_every_point_where_the_one_before_ended(study, measured):
    """With continuation, motions stay on other branches than from rest: no event can come from another order."""
    changes = CHANGES | {"sweeps.order": "up", "cases.with.running_cycles": 0}
    found = measures(slice_of(study(changes), "measures"))
    assert found["first_doubling"].values[0] == pytest.approx(measured["first_doubling"].values[0], abs=1e-7)
    assert (found["chaos_onset"].values != measured["chaos_onset"].values).any()


def test_a_state_that_cannot_be_has_its_reason_and_no_numbers(study):
    cfg = slice_of(study(CHANGES | FEW | {"backlash.half_backlash": 1e-6}), "measures")
    found = measures(cfg)
    assert found["hindrance"].values[0] == "" and found["hindrance"].values[1].startswith("the teeth jam")
    assert np.isfinite(found["mean_stiffness"].values).tolist() == [True, False]
    assert np.isnan(found["deepest_wear"].sel(case="with")).all()


def test_a_pair_that_cannot_be_has_its_reason_in_both_cases(study):
    found = measures(slice_of(study(CHANGES | FEW | {"gear_pair.bore_radius.pinion": 0.1}), "measures"))
    assert found["hindrance"].values.tolist() == [found["hindrance"].values[0]] * 2
    assert "bore" in found["hindrance"].values[0]


def test_an_unexpected_error_is_no_result(study, monkeypatch):
    monkeypatch.setattr(module, "last_state", lambda *_: np.zeros(-1))
    with pytest.raises(ValueError, match="negative dimensions"):
        measures(slice_of(study(CHANGES | FEW), "measures"))


def test_comparison_gives_a_row_a_variation_and_a_figure_of_equal_bytes(study, measured, tmp_path):
    varied = [one._asdict() | {"hindrance": ""} for one in variations(study(CHANGES))]
    varied[3]["hindrance"] = "too cold"
    for one in varied:
        del one["overrides"]
    moved = measured.assign(
        mean_stiffness=measured["mean_stiffness"] * 1.1, chaos_onset=xr.full_like(measured["chaos_onset"], np.nan)
    )
    others = [moved, *[measured] * (len(varied) - 2)]
    found = sensitivity_comparison({"varied": varied}, measured, others)
    rows = [dict(zip(found["table"].columns, row, strict=True)) for row in found["table"].rows]
    assert [row["member"] for row in rows] == ["study", *(one["name"] for one in varied)]
    assert [row["change_mean_stiffness_with"] for row in rows[:6]] == ["0", "0.1", "0", "0", "none", "0"]
    assert rows[1]["chaos_onset_with"] == "none" and rows[4]["hindrance"] == "too cold"
    store.save(found["measures"], tmp_path / "sensitivity.nc", store.Origin("sensitivity_comparison", {}, ""))
    svg, png = (tmp_path / f"figure.{suffix}" for suffix in ("svg", "png"))
    tornado.draw.write({"measures": store.load(tmp_path / "sensitivity.nc"), "cfg": {}}, STYLE, svg, png)
    assert "Not possible: viscosity" in svg.read_text()
