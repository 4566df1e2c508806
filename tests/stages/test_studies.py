"""Studies, from the wear chain of a member to the table, the sentences and the figure."""

import csv
import importlib
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from gearwear.chain.geometry import geometry
from gearwear.chain.history import last_state, record, state_at
from gearwear.config.histories import chains
from gearwear.config.slices import slice_of
from gearwear.figures import study_panels
from gearwear.io import store
from gearwear.studies.outcome import outcome

STYLE = str(Path(__file__).resolve().parents[2] / "workflow" / "report" / "gearwear.mplstyle")
CHANGES = {
    "grid.mesh_cells": 60,
    "cases.with.running_cycles": 2e8,
    "sweeps.mesh_frequency.points": 17,
    "settling.transient_periods": 100,
    "settling.longest_transient": 400,
    "settling.sampled_periods": 80,
    "settling.largest_period": 16,
    "onsets.refinement": 4,
}
HEAT, AGE = "cases.with.bulk_temperature", "cases.with.running_cycles"
STUDY = {"case": "with", "settings": {}, "grid": {HEAT: [60, 100], AGE: [0, 2e8]}, "members": {}}


class Files(dict):
    """Named files, by attribute, by place and as items, as a job has them."""

    __getattr__ = dict.__getitem__

    def __getitem__(self, key):
        return list(self.values())[key] if isinstance(key, int) else super().__getitem__(key)


def run(script, folder, cfg, inputs, **outputs):
    """Run a script and return its outputs."""
    folder.mkdir(parents=True, exist_ok=True)
    output = Files({name: str(folder / file) for name, file in outputs.items()})
    params = SimpleNamespace(cfg=cfg, code="0123456789abcdef")
    job = SimpleNamespace(rule=script, input=Files(inputs), output=output, params=params, log=[str(folder / "log")])
    importlib.import_module(script).main(job)
    return output


@pytest.fixture(scope="module")
def config(study):
    return study(CHANGES)


@pytest.fixture(scope="module")
def chain(config, tmp_path_factory):
    """File of the chain of case `with`."""
    ((_, cfg),) = chains([(config, "with")]).items()
    return run("run_chain", tmp_path_factory.mktemp("chains"), cfg, {}, nc="chain.nc")[0]


def test_the_chain_holds_the_states_of_the_stages(config, chain):
    found = store.load(chain)
    assert found["hindrance"].item() == "" and found["wear_cycle"].values.tolist() == [0, 1, 2]
    pair = geometry(config)
    reference = last_state(config, pair, "without")
    last = last_state(config, pair, "with", reference)
    state, own = state_at(found, 2)
    for name in ("mesh_stiffness", "effective_stiffness", "transmission_error", "backlash", "wear_depth"):
        np.testing.assert_array_equal(state[name], last[name], err_msg=name)
    for name in ("mesh_stiffness", "effective_stiffness", "transmission_error"):
        np.testing.assert_array_equal(own[name], reference[name], err_msg=name)
    assert state["running_cycles"] == 2e8


def test_a_chain_that_breaks_off_keeps_what_it_has(study):
    broken = study(CHANGES | {"wear.law": "constant", "wear.coefficient": 1e-16})
    found = record(slice_of(broken, "chain", "with"), 2)
    assert found.sizes["wear_cycle"] == 1 and "take off" in found["hindrance"].item()
    cfg = slice_of(broken, "outcome")
    assert np.isfinite(outcome(cfg, found, 0)["mean_stiffness"])
    late = outcome(cfg, found, 1)
    assert late["hindrance"].item() == found["hindrance"].item() and np.isnan(late["mean_stiffness"])


def test_a_pair_that_cannot_be_has_its_reason_alone(study):
    found = record(slice_of(study(CHANGES | {"gear_pair.bore_radius.pinion": 0.1}), "chain", "with"), 2)
    assert "bore" in found["hindrance"].item() and list(found.variables) == ["hindrance"]


def test_from_the_chain_to_the_table_and_the_figure(config, chain, tmp_path):
    cfg = slice_of(config, "outcome")
    fresh, worn = (
        run("measure_outcome", tmp_path / str(q), {"outcome": cfg, "update": q}, {"chain": chain}, nc="outcome.nc")[0]
        for q in (0, 2)
    )
    one = store.load(worn)
    assert one["deepest_wear"].values.min() > 0 and store.load(fresh)["deepest_wear"].values.max() == 0
    assert one["motion_class"].dims == ("order", "point") and one["running_class"] == 1
    assert one["pinion_speed"].values == pytest.approx(one["natural_speed"].item() * one["mesh_frequency"].values)
    members = [{"name": f"m{i}", "hindrance": "too cold" if i == 1 else ""} for i in range(4)]
    gather = slice_of(config, "study") | {"study": STUDY, "members": members, "units": {HEAT: "degC", AGE: "1"}}
    output = run(
        "gather_study",
        tmp_path / "study",
        gather,
        {"outcomes": [fresh, fresh, worn]},
        data="study.nc",
        table="table.csv",
        lives="lives.csv",
    )
    study = store.load(output["data"])
    assert study[HEAT].attrs["units"] == "degC"
    assert study["deepest_wear"].sel({HEAT: 100, AGE: 2e8}).values.tolist() == one["deepest_wear"].values.tolist()
    with open(output["table"], newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["hindrance"] for row in rows] == ["none", "too cold", "none", "none"]
    with open(output["lives"], newline="") as file:
        lives = [row["sentence"] for row in csv.DictReader(file)]
    assert len(lives) == 2 and "too cold" in lives[0] and "period 1 from 0 to 2e+08 revolutions" in lives[1]
    drawn = {"axes": [HEAT, AGE], "units": {HEAT: "degC", AGE: "1"}, "order": "restart"}
    svg, png = (tmp_path / f"figure.{suffix}" for suffix in ("svg", "png"))
    study_panels.draw.write({"study": study, "cfg": drawn}, STYLE, svg, png)
    assert "60 °C" in svg.read_text()
