"""The scripts of the calibration: searches, the best in full, tables and figure."""

import csv
import importlib
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from gearwear.config.calibration_parameters import NAMES, OSCILLATOR, values_of
from gearwear.config.slices import slice_of
from gearwear.figures import trade_off
from gearwear.io import store

ROOT = Path(__file__).resolve().parents[2]
CLAIMS = str(ROOT / "config" / "paper_claims.yaml")
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


class Files(dict):
    """Named files, by attribute, place and as items, as a job has them."""

    __getattr__ = dict.__getitem__

    def __getitem__(self, key):
        return list(self.values())[key] if isinstance(key, int) else super().__getitem__(key)


@pytest.fixture(scope="module")
def config(study):
    return study(CHANGES)


@pytest.fixture(scope="module")
def run(config, tmp_path_factory):
    """Return a function that runs a script and returns its outputs."""

    def one(script, files, outputs, **wildcards):
        folder = tmp_path_factory.mktemp(script)
        output = Files({name: str(folder / file) for name, file in outputs.items()})
        job = SimpleNamespace(rule=script, input=Files(files), output=output, log=[str(folder / "log")])
        job.params = SimpleNamespace(cfg=slice_of(config, "calibration"), code="0123456789abcdef")
        job.wildcards = SimpleNamespace(**wildcards)
        importlib.import_module(script).main(job)
        return output

    return one


@pytest.fixture(scope="module")
def searches(run):
    return [run("search_parameters", {"claims": CLAIMS}, {"first": "s.nc"}, island=str(i))[0] for i in (1, 2)]


@pytest.fixture(scope="module")
def compared(run, searches):
    outputs = {"dataset": "c.nc", "parameters": "parameters.csv", "claims": "claims.csv"}
    return run("compare_candidates", {"claims": CLAIMS, "searches": searches}, outputs)


def test_a_search_begins_with_the_study_and_stays_within_its_ranges(searches, config):
    found = [store.load(path) for path in searches]
    settings = config["calibration"]
    for one in found:
        assert one.sizes == {"candidate": 10, "claim": 43}
        for name in NAMES:
            values = one[f"candidate_{name}"].values
            assert (values >= settings[name]["low"]).all() and (values <= settings[name]["high"]).all()
    first = [found[0][f"candidate_{name}"].values[0] for name in NAMES]
    np.testing.assert_allclose(first, values_of(config), rtol=1e-12)
    assert not np.array_equal(found[0]["candidate_line_load"], found[1]["candidate_line_load"])


def test_a_search_is_the_same_every_time_and_tells_how_far_it_is(run, searches, caplog):
    with caplog.at_level("INFO", "gearwear"):
        again = run("search_parameters", {"claims": CLAIMS}, {"first": "s.nc"}, island="1")[0]
    assert Path(again).read_bytes() == Path(searches[0]).read_bytes()
    merit = store.load(again)["candidate_merit"].values.max()
    assert f"generation 1 of 1: best merit {merit:.3f}" in caplog.text


def test_merit_counts_the_claims_that_agree_and_how_near_the_others_are(searches):
    found = store.load(searches[0])
    count = found["claim_agrees"].values.sum(axis=1)
    possible = found["candidate_remark"].values == ""
    assert possible[0]
    assert (found["candidate_merit"].values[possible] >= 2 * count[possible]).all()
    assert (found["candidate_merit"].values[~possible] == 0).all() and (count[~possible] == 0).all()


def test_the_study_and_the_best_are_computed_in_full(compared, config):
    found = store.load(compared.dataset)
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


def test_the_tables_say_what_was_found(compared, config):
    with open(compared.parameters, encoding="utf-8") as file:
        parameters = {row["parameter"]: row for row in csv.DictReader(file)}
    assert list(parameters) == list(NAMES)
    assert float(parameters["damping_ratio"]["study"]) == config["dynamics"]["damping_ratio"]
    assert parameters["line_load"]["unit"] == "N m-1"
    with open(compared.claims, encoding="utf-8") as file:
        claims = list(csv.DictReader(file))
    assert len(claims) == 43
    assert {row["study"] for row in claims} == {"agrees", "differs"}


def test_the_figure_names_the_claims(compared, tmp_path):
    svg, png = (tmp_path / f"figure.{suffix}" for suffix in ("svg", "png"))
    trade_off.draw.sheet.write(
        trade_off.draw, {"calibration": store.load(compared.dataset), "cfg": {}}, STYLE, svg, png
    )
    assert "backlash-P4a" in svg.read_text()
