"""The table of warnings, from the states of a chain."""

from pathlib import Path

import pytest

from gearwear.config.slices import slice_of
from gearwear.stages.evaluation import warnings

TEMPLATE = Path(__file__).resolve().parents[2] / "workflow" / "report" / "table.html.j2"


@pytest.fixture(scope="module")
def listed(study, run_chain, run_stage):
    """Return a function that makes the chain of case `with` up to its first wear cycle and lists its warnings."""

    def make(changes):
        config = study(changes)
        state = run_chain(config, "with")
        state |= {"reference_stiffness": state["mesh_stiffness"], "reference_error": state["transmission_error"]}
        state["response"] = run_stage("response", config, "with", state)
        made = warnings(
            {"cases": {"with": 1}, **slice_of(config, "warnings")},
            state["geometry"],
            [state["temperature"]],
            [state["transmission_error"]],
            [run_stage("wear", config, "with", state)],
            [state["response"]] * 2,
            TEMPLATE,
        )
        assert made["html"].count("<tr>") == len(made["csv"].rows) + 1
        return [dict(zip(made["csv"].columns, row, strict=True)) for row in made["csv"].rows]

    return make


def test_a_thick_bored_heavily_loaded_pair_is_named_and_the_run_goes_on(listed):
    rows = listed(
        {
            "gear_pair.bore_radius": {"pinion": 24e-3, "gear": 55e-3},
            "operation.pinion_torque": 900.0,
            "wear.cycles_per_update": 10**6,
            "cases.with.running_cycles": 10**6,
            "cases.n0700_t060.running_cycles": 10**6,
            "cases.n1400_t080.running_cycles": 10**6,
            "cases.wear_only.running_cycles": 10**6,
        }
    )
    found = {(row["place"], row["quantity"]): row for row in rows}
    assert found["pinion", "root over bore radius"]["range"] == "1.4 to 7"
    pressure = found["with", "largest Hertz pressure under the static load"]
    assert 1.5 < float(pressure["value"].split()[0]) < 4.0 and pressure["range"] == "0 to 1.5 GPa"


def test_equal_configurations_give_equal_tables(listed):
    assert listed({}) == listed({})
