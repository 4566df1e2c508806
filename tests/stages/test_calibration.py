"""The stages of the calibration: searches, the best in full, tables and figure."""

from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from gearwear.config.calibration_parameters import NAMES, OSCILLATOR, values_of
from gearwear.config.slices import slice_of
from gearwear.figures import trade_off
from gearwear.io import store
from gearwear.stages.calibration import calibration, search

ROOT = Path(__file__).resolve().parents[2]
CLAIMS = ROOT / "config" / "paper_claims.yaml"
STYLE = str(ROOT / "workflow" / "report" / "gearwear.mplstyle")
CHANGES = {
    "grid.mesh_cells": 32,
    "sweeps.mesh_frequency.points": 81,
    "sweeps.ste.points": 59,
    "sweeps.backlash.points": 57,
    "settling.transient_periods": 100,
    "settling.longest_transient": 400,
    "settling.sampled_periods": 96,
    "settling.largest_period": 16,
    "calibration.population": 5,
    "calibration.generations": 1,
    "calibration.mesh_cells": 32,
    "calibration.verified": 2,
}


@pytest.fixture(scope="module")
def config(study):
    return study(CHANGES)


@pytest.fixture(scope="module")
def cfg(config):
    return slice_of(config, "calibration")


@pytest.fixture(scope="module")
def searches(cfg):
    return [search(cfg, CLAIMS, str(island)) for island in (1, 2)]


@pytest.fixture(scope="module")
def compared(cfg, searches):
    return calibration(cfg, CLAIMS, searches)


def test_a_search_begins_with_the_study_and_stays_within_its_ranges(searches, config):
    found = searches
    settings = config["calibration"]
    for one in found:
        assert one.sizes == {"candidate": 10, "claim": 43}
        for name in NAMES:
            values = one[f"candidate_{name}"].values
            assert (values >= settings[name]["low"]).all() and (values <= settings[name]["high"]).all()
    first = [found[0][f"candidate_{name}"].values[0] for name in NAMES]
    np.testing.assert_allclose(first, values_of(config), rtol=1e-12)
    assert not np.array_equal(found[0]["candidate_line_load"], found[1]["candidate_line_load"])


def test_a_search_is_the_same_every_time_and_tells_how_far_it_is(cfg, searches, caplog):
    with caplog.at_level("INFO", "gearwear"):
        again = search(cfg, CLAIMS, "1")
    xr.testing.assert_identical(again, searches[0])
    merit = again["candidate_merit"].values.max()
    assert f"generation 1 of 1: best merit {merit:.3f}" in caplog.text


def test_merit_counts_the_claims_that_agree_and_how_near_the_others_are(searches):
    found = searches[0]
    count = found["claim_agrees"].values.sum(axis=1)
    possible = found["candidate_remark"].values == ""
    assert possible[0]
    assert (found["candidate_merit"].values[possible] >= 2 * count[possible]).all()
    assert (found["candidate_merit"].values[~possible] == 0).all() and (count[~possible] == 0).all()


def test_the_study_and_the_best_are_computed_in_full(compared, config):
    found = compared["dataset"]
    assert found["member"].values.tolist() == ["study", "best_01", "best_02"]
    first = [found[f"member_{name}"].values[0] for name in NAMES]
    np.testing.assert_allclose(first, values_of(config), rtol=1e-12)
    agreed = found["member_agrees"].values.sum(axis=1)
    assert agreed[1] >= agreed[2] and agreed[0] > 10
    force, ripple, ratio, lag = (float(found[f"member_{name}"][0]) for name in OSCILLATOR)
    assert force == pytest.approx(0.222, abs=0.002)
    assert ripple == pytest.approx(0.303, abs=0.003)
    assert 1.05 < ratio < 1.2 and 0.0 < lag < 0.6
    counts = dict(zip(found["sweep"].values, found["claims_of_sweep"].values, strict=True))
    assert counts == {"mesh_frequency": 14, "ste": 12, "backlash": 10}


def rows(table):
    return [dict(zip(table.columns, row, strict=True)) for row in table.rows]


def test_the_tables_say_what_was_found(compared, config):
    parameters = {row["parameter"]: row for row in rows(compared["parameters"])}
    assert list(parameters) == list(NAMES)
    assert float(parameters["damping_ratio"]["study"]) == config["dynamics"]["damping_ratio"]
    assert parameters["line_load"]["unit"] == "N m-1"
    claims = rows(compared["claims"])
    assert len(claims) == 43
    assert {row["study"] for row in claims} == {"agrees", "differs"}


def test_the_figure_names_the_claims(compared, tmp_path):
    svg, png = (tmp_path / f"figure.{suffix}" for suffix in ("svg", "png"))
    store.save(compared["dataset"], tmp_path / "calibration.nc", store.Origin("calibration", {}, ""))
    trade_off.draw.write({"calibration": store.load(tmp_path / "calibration.nc"), "cfg": {}}, STYLE, svg, png)
    assert "backlash-P4a" in svg.read_text()
