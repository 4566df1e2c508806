"""Whole wear histories in one process, and the jobs of several wear cycles: those of the stages, one by one."""

from types import SimpleNamespace

import numpy as np
import pytest
import xarray as xr
from snakemake.iocontainers import InputFiles, OutputFiles, Params

from gearwear.chain.cycle import CYCLE
from gearwear.chain.history import last_state, state_at, states_of_case, wear_history
from gearwear.config.histories import histories
from gearwear.config.slices import slice_of
from gearwear.errors import Infeasible
from gearwear.io import store
from gearwear.run import stage
from gearwear.run.digest import digest
from gearwear.run.stages import arguments_of, target_of
from gearwear.studies.outcome import outcome

CYCLES = {"cases.with.running_cycles": 2e8}
STATE = ("wear", "mesh_stiffness", "transmission_error", "backlash")


@pytest.fixture(scope="module")
def config(study):
    return study(CYCLES)


@pytest.fixture(scope="module")
def one_by_one(config, states, with_reference, run_stage):
    """States of case `with` at every wear cycle, stage by stage, with the response that wears them."""
    state = with_reference(states("with"))
    state["response"] = run_stage("response", config, "with", state)
    found = [state]
    for _ in range(2):
        state = dict(state)
        for name, made in {"wear": "wear", "mesh_excitation": None, "response": "response"}.items():
            result = run_stage(name, config, "with", state)
            state |= result if made is None else {made: result}
        found.append(state)
    return found


def same(found, state, names=STATE):
    for name in names:
        for variable, values in state[name].data_vars.items():
            if variable in found:
                np.testing.assert_array_equal(found[variable].values, values.values, err_msg=variable)


def test_a_cycle_wears_before_it_computes_the_mesh_and_the_motion():
    assert list(CYCLE) == ["wear", "mesh_excitation", "response"]
    assert [name for made in CYCLE.values() for name in made] == [*STATE, "response"]


def test_the_history_in_one_process_gives_the_values_of_the_stages(config, states, one_by_one):
    reference = store.together([states("without")[name] for name in STATE])
    found = list(states_of_case(slice_of(config, "measures"), states("with")["geometry"], "with", reference))
    assert len(found) == 3
    for one, state in zip(found, one_by_one, strict=True):
        assert {name for part in STATE for name in state[part].data_vars} == set(one.data_vars)
        same(one, state)
    assert found[1]["wear_depth"].values.max() > 0
    assert (found[2]["wear_depth"] > found[1]["wear_depth"]).any()


def test_wear_without_the_reference_is_refused(config, states):
    cfg, pair = slice_of(config, "measures"), states("with")["geometry"]
    with pytest.raises(Infeasible, match="the state of the reference case; give it"):
        last_state(cfg, pair, "with")


def test_the_history_of_a_study_holds_the_states_of_the_stages(config, states, one_by_one):
    ((name, cfg),) = histories([(config, "with")]).items()
    found = wear_history(cfg)
    assert name.startswith("with_")
    assert found["hindrance"].item() == "" and found["wear_cycle"].values.tolist() == [0, 1, 2]
    for update, made in enumerate(one_by_one):
        state, reference = state_at(found, update)
        same(state, made)
        same(reference, states("without"), ("mesh_stiffness", "transmission_error"))
        assert state["running_cycles"] == update * 1e8
    with pytest.raises(Infeasible):
        state_at(found, 3)


def test_a_history_that_breaks_off_keeps_what_it_has(study):
    broken = study(CYCLES | {"wear.law": "constant", "wear.coefficient": 1e-16})
    found = wear_history({"settings": slice_of(broken, "wear_history", "with"), "updates": 2})
    assert found.sizes["wear_cycle"] == 1 and "take off" in found["hindrance"].item()
    cfg = slice_of(broken, "outcome")
    assert np.isfinite(outcome(cfg, found, 0)["mean_stiffness"])
    late = outcome(cfg, found, 1)
    assert late["hindrance"].item() == found["hindrance"].item() and np.isnan(late["mean_stiffness"])


def test_a_pair_that_cannot_be_has_its_reason_alone(study):
    settings = slice_of(study(CYCLES | {"gear_pair.bore_radius.pinion": 0.1}), "wear_history", "with")
    found = wear_history({"settings": settings, "updates": 2})
    assert "bore" in found["hindrance"].item() and list(found.variables) == ["hindrance"]


def test_a_job_of_two_cycles_writes_the_files_of_the_stages(config, one_by_one, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(stage, "end_with_workflow", lambda: None)
    codes = {link: digest(target_of(link)) for link in CYCLE}
    cfg = {link: slice_of(config, link, "with") for link in CYCLE}
    inputs = {name for link in CYCLE for name in arguments_of(link)} - {"cfg", "backlash"}
    places = {"geometry": "geometry", "deformation": "with/deformation"}
    places |= {
        "reference_stiffness": "without/mesh_stiffness/q000",
        "reference_error": "without/transmission_error/q000",
    }
    files = {name: f"results/{places.get(name, f'with/{name}/q000')}.nc" for name in inputs}
    for name, path in files.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        store.save(one_by_one[0][name], path, store.Origin("geometry", {}, ""))
    made = {name: [f"results/with/{name}/q00{q}.nc" for q in (1, 2)] for several in CYCLE.values() for name in several}
    (tmp_path / "results/with/backlash").mkdir()
    job = SimpleNamespace(
        rule="wear_block_001_002",
        input=InputFiles(fromdict=files),
        output=OutputFiles(fromdict=made),
        params=Params(fromdict={"cfg": cfg, "code": codes}),
        log=["job.log"],
        config=config,
    )
    stage.run_block(job)
    for place, state in enumerate(one_by_one[1:]):
        for name, paths in made.items():
            found = store.load(paths[place])
            xr.testing.assert_equal(found, state[name])
            assert found.attrs["stage"] == next(link for link, names in CYCLE.items() if name in names)
    last = {name: store.load(paths[1]) for name, paths in made.items()}
    before = {name: store.load(paths[0]).attrs["lineage"] for name, paths in made.items()}
    wear = store.origin_of(last["wear"]).inputs
    assert wear.items() >= {name: before[name] for name in ("wear", "mesh_stiffness", "response")}.items()
    motion = store.origin_of(last["response"]).inputs
    assert motion["backlash"] == last["backlash"].attrs["lineage"]
