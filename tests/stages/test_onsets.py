"""The scripts of the onsets, from the sweeps of a coarse pristine pair to the table and the figure."""

import csv
import importlib
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from gearwear.codes.onset_codes import EVENTS, MET, ORDERS, PASSED_BY, VARIANTS
from gearwear.config import ensemble
from gearwear.config.slices import slice_of
from gearwear.figures import onset_shifts
from gearwear.io import store

STYLE = str(Path(__file__).resolve().parents[2] / "workflow" / "report" / "gearwear.mplstyle")
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


class Files(dict):
    """Named files, by attribute and as items, as a job has them."""

    __getattr__ = dict.__getitem__


@pytest.fixture(scope="module")
def run(study, tmp_path_factory):
    """Return a function that runs a script and returns its first output."""
    config = study(CHANGES)

    def one(script, stage, files, output="result.nc", more=None, **wildcards):
        folder = tmp_path_factory.mktemp(script)
        outputs = {"first": str(folder / output)} | {name: str(folder / file) for name, file in (more or {}).items()}

        class Output(Files):
            def __getitem__(self, key):
                return list(self.values())[key] if isinstance(key, int) else super().__getitem__(key)

        job = SimpleNamespace(rule=script, input=Files(files), output=Output(outputs), log=[str(folder / "log")])
        job.params = SimpleNamespace(
            cfg=slice_of(config, stage, "without", "mesh_frequency") if stage else {}, code="0123456789abcdef"
        )
        job.wildcards = SimpleNamespace(case="without", sweep="mesh_frequency", **wildcards)
        importlib.import_module(script).main(job)
        return job.output[0] if more is None else job.output

    return one


@pytest.fixture(scope="module")
def onsets(run, states):
    """Files of the onsets and their variants of the pristine pair."""
    files = {
        name: str(states("without")[name]) for name in ("geometry", "mesh_stiffness", "transmission_error", "backlash")
    }
    files |= {"reference_stiffness": files["mesh_stiffness"], "reference_error": files["transmission_error"]}
    files = {"excitation": run("build_excitation", "excitation", files, "excitation.nc")}
    sweeps = [run("sweep_part", "sweep", files, scatteritem="1-of-1")]
    sweeps += [run("carry_sweep", "sweep", files, order=order) for order in ORDERS[1:]]
    branches = run("continue_orbits", "branches", files | {"sweeps": sweeps})
    located = run("locate_onsets", "onsets", files | {"sweep": sweeps[0], "branches": branches})
    varied = run("vary_onsets", "onsets", files | {"sweeps": sweeps, "branches": branches})
    return located, varied


def figure(shifts, folder):
    """Return the bytes of the figure as SVG and PNG."""
    folder.mkdir()
    svg, png = folder / "onsets.svg", folder / "onsets.png"
    onset_shifts.draw.sheet.write(
        onset_shifts.draw, {"shifts": store.load(shifts), "cfg": {}}, STYLE, str(svg), str(png)
    )
    return [path.read_bytes() for path in (svg, png)]


def test_events_of_the_pristine_pair_are_located(onsets):
    table = store.load(onsets[0])
    assert list(table["event"].values) == list(EVENTS)
    assert table["onset"].values[:3] == pytest.approx([1.0438, 1.1889, 1.2719], abs=2e-3)
    assert 1.272 < table["onset"].values[3] < 1.31
    assert table["onset_how"].attrs["flag_meanings"].split() == ["absent", "met", "passed_by", "below_range"]
    assert table["onset_how"].values.tolist() == [MET, MET, PASSED_BY, MET]  # the step is too long to show period 8


def test_variants_hold_the_events_in_every_way(onsets):
    located, varied = (store.load(path) for path in onsets)
    assert list(varied["variant"].values) == list(VARIANTS)
    usual = varied.sel(variant="restart")
    np.testing.assert_array_equal(usual["onset_seen"].values, located["onset_seen"].values)
    assert varied["onset_seen"].sel(variant="up").values[1] > 1.2
    moved = np.abs(varied["onset_seen"].values[-2:, :3] - located["onset"].values[:3])
    assert 0 < moved[np.isfinite(moved)].max() < 1e-7


@pytest.fixture(scope="module")
def member(run):
    """File of the onsets of a member with the settings of the study."""
    return run("measure_onsets", "member_onsets", {})


def test_a_member_in_one_process_has_the_onsets_of_the_stages(onsets, member):
    own, located = store.load(member).sel(case="without"), store.load(onsets[0])
    for name in located.data_vars:
        np.testing.assert_array_equal(own[name].values, located[name].values, err_msg=name)


def test_comparison_gives_a_row_an_event_and_a_figure(run, study, onsets, member, tmp_path):
    names = list(ensemble.factors(study(CHANGES)["onsets"]))
    assert len(names) == 9
    files = {"onsets": [onsets[0]] * 2, "variants": [onsets[1]] * 2, "members": [member] * len(names)}
    output = run("compare_onsets", "onset_shifts", files, "onset_shifts.nc", more={"table": "onsets.csv"})
    with open(output["table"], newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["event"] for row in rows] == list(EVENTS)
    assert {row["shift"] for row in rows} == {"0.000000"}
    assert {row["members"] for row in rows} == {"1"} and {row["members_with_event"] for row in rows} == {"1"}
    places = store.load(member)["onset"]
    shifts = (places.sel(case="with") - places.sel(case="without")).values
    assert np.isfinite(shifts).any()
    for row, shift in zip(rows, shifts, strict=True):
        assert row["damping_ratio_low"] == ("none" if np.isnan(shift) else f"{shift:.6f}")
    assert figure(output[0], tmp_path / "one") == figure(output[0], tmp_path / "two")
    table = store.load(output[0])
    assert list(table["member"].values) == names
    assert table["factor"].sel(member="bore_radius_high").values.tolist() == [1.0, 1.25, 1.0, 1.0]
