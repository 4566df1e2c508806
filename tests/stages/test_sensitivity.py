"""The sensitivity, from the measures of a coarse study to the table and the figure."""

import csv
import importlib
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import xarray as xr

from gearwear.chain.geometry import geometry
from gearwear.chain.history import last_state
from gearwear.config.slices import slice_of
from gearwear.config.variations import variations
from gearwear.figures import tornado
from gearwear.io import store
from gearwear.sensitivity import measures as module

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


def job(rule, folder, cfg, inputs, **outputs):
    files = {name: str(folder / file) for name, file in outputs.items()}

    class Output(dict):
        __getattr__ = dict.__getitem__

        def __getitem__(self, key):
            return list(self.values())[key] if isinstance(key, int) else super().__getitem__(key)

    class Input(dict):
        __getattr__ = dict.__getitem__

    return SimpleNamespace(
        rule=rule,
        input=Input(inputs),
        output=Output(files),
        params=SimpleNamespace(cfg=cfg, code="0123456789abcdef"),
        log=[str(folder / "log")],
    )


@pytest.fixture(scope="module")
def measured(study, tmp_path_factory):
    """File of the measures of the coarse study."""
    one = job("measure_member", tmp_path_factory.mktemp("study"), slice_of(study(CHANGES), "measures"), {}, nc="m.nc")
    importlib.import_module("measure_member").main(one)
    return one.output[0]


def test_the_chain_in_one_process_gives_the_values_of_the_stages(study, run_stage, run_chain, states, loaded):
    config = study({"cases.with.running_cycles": 1e8})
    reference = states("without")
    files = run_chain(config, "with") | {
        "reference_stiffness": reference["mesh_stiffness"],
        "reference_error": reference["transmission_error"],
    }
    for stage, name in (("response", "response"), ("advance_wear", "wear")):
        files[name] = run_stage(stage, config, "with", files)
    files["mesh_stiffness"] = run_stage("mesh_stiffness", config, "with", files)
    files = run_chain(config, "with", files)

    cfg = slice_of(config, "measures")
    pair = geometry(cfg)
    state = last_state(cfg, pair, "with", last_state(cfg, pair, "without"))
    for name in ("wear", "mesh_stiffness", "transmission_error", "backlash"):
        made = loaded(files, name)
        for variable in made.data_vars:
            np.testing.assert_array_equal(state[variable].values, made[variable].values, err_msg=variable)
    assert state["wear_depth"].values.max() > 0
    with pytest.raises(ValueError, match="the state of the reference case; give it"):
        last_state(cfg, pair, "with")


def test_measures_of_the_coarse_study(measured):
    found = store.load(measured)
    assert found["case"].values.tolist() == ["without", "with"] and set(found["hindrance"].values) == {""}
    cold, hot = found["first_doubling"].values
    assert cold == pytest.approx(1.0438, abs=2e-3) and hot < cold - 0.005  # as in test_onsets
    assert 1.272 < found["chaos_onset"].values[0] < 1.31
    assert found["mean_stiffness"].values[1] < found["mean_stiffness"].values[0]
    assert found["deepest_wear"].values[0].tolist() == [0.0, 0.0] and (found["deepest_wear"].values[1] > 0).all()
    assert found["relative_mean_error"].values[0] == 1.0


def test_a_sweep_up_starts_every_point_where_the_one_before_ended(study, measured, tmp_path):
    """Carried on, the motions stay on other branches than from rest: not one event can come from another order."""
    changes = CHANGES | {"sweeps.order": "up", "cases.with.running_cycles": 0}
    found = module.measures(slice_of(study(changes), "measures"))
    rest = store.load(measured)
    assert found["first_doubling"].values[0] == pytest.approx(rest["first_doubling"].values[0], abs=1e-7)
    assert (found["chaos_onset"].values != rest["chaos_onset"].values).any()


def test_a_state_that_cannot_be_has_its_reason_and_no_numbers(study):
    cfg = slice_of(study(CHANGES | FEW | {"backlash.half_backlash": 1e-6}), "measures")
    found = module.measures(cfg)
    assert found["hindrance"].values[0] == "" and found["hindrance"].values[1].startswith("the teeth jam")
    assert np.isfinite(found["mean_stiffness"].values).tolist() == [True, False]
    assert np.isnan(found["deepest_wear"].sel(case="with")).all()


def test_a_pair_that_cannot_be_has_its_reason_in_both_cases(study):
    found = module.measures(slice_of(study(CHANGES | FEW | {"gear_pair.bore_radius.pinion": 0.1}), "measures"))
    assert found["hindrance"].values.tolist() == [found["hindrance"].values[0]] * 2
    assert "bore" in found["hindrance"].values[0]


def test_an_error_that_nobody_worded_is_no_result(study, monkeypatch):
    monkeypatch.setattr(module, "last_state", lambda *_: np.zeros(-1))
    with pytest.raises(ValueError, match="negative dimensions"):
        module.measures(slice_of(study(CHANGES | FEW), "measures"))


def test_comparison_gives_a_row_a_variation_and_a_figure_of_equal_bytes(study, measured, tmp_path):
    varied = [one._asdict() | {"hindrance": ""} for one in variations(study(CHANGES))]
    varied[3]["hindrance"] = "too cold"
    for one in varied:
        del one["overrides"]
    moved = store.load(measured)
    moved["mean_stiffness"] = moved["mean_stiffness"] * 1.1
    moved["chaos_onset"] = xr.full_like(moved["chaos_onset"], np.nan)
    other = job("measure_member", tmp_path, {}, {}, nc="measures.nc")
    store.save(moved, other)
    files = [other.output[0], *[measured] * (len(varied) - 2)]
    compare = job(
        "compare_members",
        tmp_path,
        {"varied": varied},
        {"study": measured, "members": files},
        measures="sensitivity.nc",
        table="sensitivity.csv",
    )
    importlib.import_module("compare_members").main(compare)
    with open(compare.output["table"], newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["member"] for row in rows] == ["study", *(one["name"] for one in varied)]
    assert [row["change_mean_stiffness_with"] for row in rows[:6]] == ["0", "0.1", "0", "0", "none", "0"]
    assert rows[1]["chaos_onset_with"] == "none" and rows[4]["hindrance"] == "too cold"
    svg, png = (tmp_path / f"figure.{suffix}" for suffix in ("svg", "png"))
    tornado.draw.write({"measures": store.load(compare.output[0]), "cfg": {}}, STYLE, svg, png)
    assert "Not possible: viscosity" in svg.read_text()
