"""The table of warnings, from the files of a chain."""

import csv
from pathlib import Path
from types import SimpleNamespace

import list_warnings
import pytest

from gearwear.config.slices import slice_of

ROOT = Path(__file__).resolve().parents[2]


class Inputs(dict):
    """Named input files, by attribute and as items, as a job has them."""

    __getattr__ = dict.__getitem__


@pytest.fixture(scope="module")
def listed(study, run_chain, run_stage, tmp_path_factory):
    """Return a function that makes the chain of case `with` up to its first wear cycle and lists its warnings."""

    def make(changes):
        config, folder = study(changes), tmp_path_factory.mktemp("warnings")
        files = run_chain(config, "with")
        files |= {"reference_stiffness": files["mesh_stiffness"], "reference_error": files["transmission_error"]}
        files["response"] = run_stage("response", config, "with", files)
        worn = run_stage("advance_wear", config, "with", files)
        job = SimpleNamespace(
            input=Inputs(
                geometry=files["geometry"],
                template=str(ROOT / "workflow" / "report" / "table.html.j2"),
                temperature=[files["temperature"]],
                transmission_error=[files["transmission_error"]],
                wear=[worn],
                response=[files["response"]] * 2,
            ),
            output=SimpleNamespace(csv=str(folder / "warnings.csv"), html=str(folder / "warnings.html")),
            params=SimpleNamespace(cfg={"cases": {"with": 1}, **slice_of(config, "warnings")}),
        )
        list_warnings.main(job)
        with open(job.output.csv, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    return make


def test_a_thick_bored_heavily_loaded_pair_is_named_and_the_run_goes_on(listed, capsys):
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
