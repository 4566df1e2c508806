"""Studies, from the wear history of a member to the table, the sentences and the figure."""

from pathlib import Path

import pytest

from gearwear.chain.history import wear_history
from gearwear.config.histories import histories
from gearwear.config.slices import slice_of
from gearwear.figures import study_panels
from gearwear.io import store
from gearwear.stages import studies
from gearwear.stages.studies import outcome
from gearwear.stages.studies import study as study_stage

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


@pytest.fixture(scope="module")
def config(study):
    return study(CHANGES)


@pytest.fixture(scope="module")
def history(config):
    """Wear history of case `with`."""
    ((_, cfg),) = histories([(config, "with")]).items()
    return wear_history(cfg)


def test_from_the_history_to_the_table_and_the_figure(config, history, tmp_path):
    cfg = slice_of(config, "outcome")
    fresh, worn = (
        outcome({"settings": cfg, "update": update, "member": "studies/heat/t120/"}, history) for update in (0, 2)
    )
    assert worn["deepest_wear"].values.min() > 0 and fresh["deepest_wear"].values.max() == 0
    assert worn["motion_class"].dims == ("order", "point") and worn["running_class"] == 1
    assert worn["pinion_speed"].values == pytest.approx(worn["natural_speed"].item() * worn["mesh_frequency"].values)
    members = [{"name": f"m{i}", "reason": "too cold" if i == 1 else ""} for i in range(4)]
    units, meanings = {HEAT: "degC", AGE: "1"}, {HEAT: "bulk temperature", AGE: "life"}
    settings = slice_of(config, "study") | {"study": STUDY, "members": members, "units": units, "meanings": meanings}
    made = study_stage(settings, [fresh, fresh, worn])
    store.save(made["data"], tmp_path / "study.nc", store.Origin("study", {}, ""))
    found = store.load(tmp_path / "study.nc")
    assert found[HEAT].attrs == {"units": "degC", "long_name": "bulk temperature"}
    assert found["deepest_wear"].sel({HEAT: 100, AGE: 2e8}).values.tolist() == worn["deepest_wear"].values.tolist()
    place = made["table"].columns.index("hindrance")
    assert [row[place] for row in made["table"].rows] == ["none", "too cold", "none", "none"]
    lives = [row[made["lives"].columns.index("sentence")] for row in made["lives"].rows]
    assert len(lives) == 2 and "too cold" in lives[0] and "period 1 from 0 to 2e+08 revolutions" in lives[1]
    drawn = {"axes": [HEAT, AGE], "units": units, "order": "restart"}
    svg, png = (tmp_path / f"figure.{suffix}" for suffix in ("svg", "png"))
    study_panels.draw.write({"study": found, "cfg": drawn}, STYLE, svg, png)
    assert "60 °C" in svg.read_text()


def test_a_member_that_is_not_feasible_is_reported(config, history, monkeypatch):
    said = []
    monkeypatch.setattr(studies, "report", said.append)
    cfg = {"settings": slice_of(config, "outcome"), "update": 3, "member": "studies/heat/t120/"}
    found = outcome(cfg, history.assign(hindrance="the teeth jam"))
    assert found["hindrance"].item() == "the teeth jam"
    assert said == ["studies/heat/t120/: not feasible: the teeth jam"]
