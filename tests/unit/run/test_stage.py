"""A job: its inputs and outputs, its log, its failures, and its end when the workflow ends."""

import csv
import io
import os
import shlex
import signal
import subprocess
import sys
import time
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import xarray as xr
from snakemake.iocontainers import InputFiles, OutputFiles, Params, Wildcards

from gearwear.io import store
from gearwear.io.tables import Table
from gearwear.mesh.backlash import half_backlash
from gearwear.run import orphans, stage, stages
from gearwear.run.digest import digest, source_key

TARGET = "chain.wear:unworn"
CODES = {TARGET: digest(TARGET)}
ORPHAN = """
import sys, time
from types import SimpleNamespace
from gearwear.run import stage
job = SimpleNamespace(rule="work", output=["made.nc"], log=[sys.argv[1]])
with stage.logged(job, {}):
    stage.log.info("at work")
    time.sleep(60)
"""
WORKFLOW = """
import subprocess, sys
job = subprocess.Popen([sys.executable, *sys.argv[1:]])
print(job.pid, flush=True)
job.wait()
"""


@pytest.fixture
def job(tmp_path, monkeypatch):
    """Return a job of the stage `unworn` in an empty folder, in a process that does not end with its parent."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(stage, "end_with_workflow", lambda: None)
    pair = xr.Dataset(coords={"gear": ["pinion", "gear"], "path": [1e-3, 2e-3, 3e-3], "mesh_phase": [0.0, 0.5]})
    (tmp_path / "results").mkdir()
    store.save(pair, "results/geometry.nc", store.Origin("geometry", {"grid": {"mesh_cells": 3}}, "code"))
    return SimpleNamespace(
        rule="unworn",
        input=InputFiles(fromdict={"geometry": "results/geometry.nc"}),
        output=OutputFiles(["results/wear.nc"]),
        wildcards=Wildcards(fromdict={"case": "with", "q": "000"}),
        params=Params(fromdict={"cfg": {}, "code": {"unworn": CODES[TARGET]}}),
        log=[tmp_path / "job.log"],
        config={"grid": {"mesh_cells": 3}},
    )


def test_a_job_calls_the_stage_of_its_rule_and_writes_what_made_it(job):
    stage.run(job)
    made, geometry = store.load("results/wear.nc"), store.load("results/geometry.nc")
    assert not made["wear_depth"].values.any() and made["path"].equals(geometry["path"])
    assert made.attrs["result"] == "wear.nc"
    inputs = {"geometry": geometry.attrs["lineage"]}
    assert store.origin_of(made) == store.Origin("unworn", {}, CODES[TARGET], inputs)
    lines = job.log[0].read_text().splitlines()
    assert lines[0] == "unworn: results/wear.nc"
    assert "wear_depth 0 to 0" in lines[1]


def test_a_stage_gets_settings_inputs_and_wildcards_by_name_and_returns_outputs_by_name(job, monkeypatch):
    asked = {}

    def several(cfg, geometry, case, texts):
        asked.update(cfg=cfg, geometry=geometry.sizes["path"], case=case, texts=texts)
        return {"data": geometry, "table": Table(("a", "b"), [(1, "x")]), "page": "<p>"}

    monkeypatch.setattr(stages, "target_of", lambda name: {"several": TARGET}[name])
    monkeypatch.setattr(stages, "function_of", lambda name: {"several": several}[name])
    job.params = Params(fromdict={"cfg": {"x": 1}, "code": {"several": CODES[TARGET]}})
    job.input = InputFiles(fromdict={"geometry": "results/geometry.nc", "texts": ["one.yaml", "two.yaml"]})
    job.output = OutputFiles(fromdict={"page": "page.html", "table": "table.csv", "data": "results/data.nc"})
    stage.run(job)
    assert asked.pop("texts") == [Path("one.yaml"), Path("two.yaml")]
    assert asked == {"cfg": {"x": 1}, "geometry": 3, "case": "with"}
    assert Path("page.html").read_text() == "<p>"
    with open("table.csv", newline="") as file:
        assert list(csv.reader(file)) == [["a", "b"], ["1", "x"]]
    assert store.load("results/data.nc").attrs["stage"] == "several"


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (lambda job: Path("results/geometry.nc").unlink(), "geometry.nc: no such file; run the workflow again"),
        (lambda job: job.config["grid"].update(mesh_cells=4), "geometry.nc: made with grid.mesh_cells 3, and it is 4"),
        (
            lambda job: (
                Path("results/geometry.nc").rename("results/other.nc"),
                setattr(job, "input", InputFiles(fromdict={"geometry": "results/other.nc"})),
            ),
            "other.nc: holds the result geometry.nc; delete it",
        ),
    ],
)
def test_input_files_are_checked_before_the_work(job, monkeypatch, spoil, words):
    monkeypatch.setattr(stages, "function_of", lambda _: pytest.fail("the stage ran"))
    spoil(job)
    with pytest.raises(SystemExit):
        stage.run(job)
    assert words in job.log[0].read_text()
    assert not Path("results/wear.nc").exists()


def test_a_job_does_without_the_library_of_units_and_the_workflow():
    program = "import sys; from gearwear.run import stage, stages; [stages.function_of(one) for one in stages.MODULES]"
    done = subprocess.run([sys.executable, "-c", f"{program}; print(*sys.modules)"], capture_output=True, text=True)
    found = {name.partition(".")[0] for name in done.stdout.split()}
    assert "gearwear" in found and not found & {"pint", "snakemake"}


def test_output_goes_to_the_log_of_the_job(job, capsys):
    with stage.logged(job, CODES):
        stage.log.info("mean %.1f um", 3.25)
        print("printed")
        print("complained", file=sys.stderr)
        assert job.log[0].read_text() == "unworn: results/wear.nc\nmean 3.2 um\nprinted\ncomplained\n"  # line by line
    assert capsys.readouterr() == ("", "")


def test_a_report_is_in_the_log_and_on_the_screen(job, monkeypatch):
    screen = io.StringIO()
    monkeypatch.setattr(sys, "__stdout__", screen)
    with stage.logged(job, CODES):
        stage.report("warning: thin film")
    assert screen.getvalue() == "warning: thin film\n"
    assert job.log[0].read_text().endswith("\nwarning: thin film\n")


def test_an_unexpected_failure_keeps_its_traceback(job):
    with pytest.raises(ValueError, match="could not convert"), stage.logged(job, CODES):
        float("many")
    text = job.log[0].read_text()
    assert text.startswith("unworn: results/wear.nc\nfailed: could not convert string")
    assert "Traceback" in text


def jam():
    """Fail with an error of this program."""
    half_backlash(1e-6, np.zeros(3), np.zeros((2, 3)), np.ones((2, 3)), 0.35, "exact")


def test_an_error_of_the_program_is_one_sentence(job):
    with pytest.raises(SystemExit), stage.logged(job, CODES):
        jam()
    text = job.log[0].read_text()
    assert text.startswith("unworn: results/wear.nc\nfailed: the teeth jam")
    assert text.count("\n") == 2


def test_streams_and_handlers_are_given_back(job):
    before = sys.stdout, sys.stderr, list(stage.log.handlers)
    with pytest.raises(KeyboardInterrupt), stage.logged(job, CODES):
        raise KeyboardInterrupt
    assert (sys.stdout, sys.stderr, list(stage.log.handlers)) == before


@pytest.mark.parametrize("sources", [None, "0" * 16])
def test_a_job_refuses_code_that_changed_since_the_workflow_read_it(job, monkeypatch, sources):
    monkeypatch.delenv(stage.SOURCES, raising=False)
    if sources:
        monkeypatch.setenv(stage.SOURCES, sources)
    ran = []
    with pytest.raises(SystemExit), stage.logged(job, {TARGET: "0" * 16}):
        ran.append(True)
    assert ran == []
    assert "the source code changed while the workflow was running: start it again" in job.log[0].read_text()
    with stage.logged(job, CODES):  # sources changed, but not those of this stage
        ran.append(True)
    assert ran == [True]


def test_a_job_reads_no_code_where_no_source_changed(job, monkeypatch):
    monkeypatch.setenv(stage.SOURCES, source_key())
    monkeypatch.setattr(stage, "digest", lambda _: pytest.fail("the code was read"))
    with stage.logged(job, CODES):
        pass


def test_log_on_a_full_disk_speaks_on_the_screen(job, monkeypatch):
    job.log[0] = "/dev/full"
    screen = io.StringIO()
    monkeypatch.setattr(sys, "__stderr__", screen)
    with pytest.raises(SystemExit), stage.logged(job, CODES):
        jam()
    assert screen.getvalue().startswith("unworn: results/wear.nc\nfailed: the teeth jam")


def test_log_that_cannot_be_opened_is_named(job, tmp_path):
    job.log[0] = tmp_path / "nowhere" / "job.log"
    with pytest.raises(SystemExit, match="job.log: the log cannot be written \\(No such file"), stage.logged(job, {}):
        pass


def alive(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return open(f"/proc/{pid}/stat").read().rpartition(")")[2].split()[0] != "Z"


def wait_until(condition, seconds=60.0) -> bool:
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.02)
    return condition()


def test_job_ends_with_a_killed_workflow(tmp_path):
    runner, log = tmp_path / "runner.py", tmp_path / "job.log"
    runner.write_text(ORPHAN)
    command = [sys.executable, "-c", WORKFLOW, str(runner), str(log)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as workflow:
        pid = int(workflow.stdout.readline())
        try:
            assert wait_until(lambda: log.exists() and "at work" in log.read_text())
            workflow.kill()
            workflow.wait()
            assert wait_until(lambda: not alive(pid))
        finally:
            if alive(pid):
                os.kill(pid, signal.SIGKILL)


@pytest.mark.parametrize("gone", [True, False])
def test_job_that_starts_after_the_death_of_the_workflow_does_no_work(tmp_path, gone):
    runner, log = tmp_path / "runner.py", tmp_path / "job.log"
    runner.write_text(ORPHAN.replace("sleep(60)", "sleep(0)"))
    with subprocess.Popen([sys.executable, "-c", "pass"]) as past:
        past.wait()
    workflow = past.pid if gone else os.getpid()
    environment = os.environ | {orphans.WORKFLOW: str(workflow)}
    run = subprocess.run([sys.executable, runner, log], env=environment, capture_output=True, text=True)
    assert (run.returncode, log.exists()) == ((1, False) if gone else (0, True))
    assert ("the workflow that started this job is gone" in run.stderr) == gone


def test_a_shell_may_stand_between_workflow_and_job(tmp_path):
    runner, log = tmp_path / "runner.py", tmp_path / "job.log"
    runner.write_text(ORPHAN.replace("sleep(60)", "sleep(0)"))
    environment = os.environ | {orphans.WORKFLOW: str(os.getpid())}
    command = f"{shlex.join([sys.executable, str(runner), str(log)])}; true"
    run = subprocess.run(command, shell=True, env=environment, capture_output=True, text=True)
    assert "at work" in log.read_text() and run.stderr == ""


@pytest.mark.parametrize("parts", [1, 2, 3, 7, 20])
def test_every_point_belongs_to_one_part(parts):
    points = np.arange(11)
    dealt = [
        points[stage.wildcards(SimpleNamespace(wildcards={"scatteritem": f"{part}-of-{parts}"}))["part"]]
        for part in range(1, parts + 1)
    ]
    assert sorted(np.concatenate(dealt)) == list(range(11))
    assert max(map(len, dealt)) - min(map(len, dealt)) <= 1


def test_neighbours_go_to_different_parts():
    job = SimpleNamespace(wildcards={"scatteritem": "2-of-4"})
    assert np.arange(11)[stage.wildcards(job)["part"]].tolist() == [1, 5, 9]
