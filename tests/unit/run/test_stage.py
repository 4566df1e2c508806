"""A stage job: its log, its failures, and its end when the workflow ends."""

import io
import os
import shlex
import signal
import subprocess
import sys
import time
from types import SimpleNamespace

import numpy as np
import pytest

from gearwear.mesh.backlash import half_backlash
from gearwear.run import orphans, stage
from gearwear.run.digest import SCRIPTS, digest

ORPHAN = """
import sys, time
from types import SimpleNamespace
sys.path.insert(0, {scripts!r})
from gearwear.run import stage
from gearwear.run.digest import digest
script = sys.argv[1]
params = SimpleNamespace(code=digest(script))
job = SimpleNamespace(rule="work", output=["made.nc"], log=[sys.argv[2]], params=params, input={{}}, config={{}})
with stage.logged(job, script):
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
def script(tmp_path):
    path = tmp_path / "some_stage.py"
    path.write_text("X = 1\n")
    return path


@pytest.fixture
def job(tmp_path, script):
    params = SimpleNamespace(code=digest(script))
    log = [tmp_path / "job.log"]
    return SimpleNamespace(rule="work", output=["made.nc"], log=log, params=params, input={}, config={})


@pytest.fixture
def in_this_process(monkeypatch):
    """The test process must not be bound to the life of its parent."""
    monkeypatch.setattr("gearwear.run.stage.end_with_workflow", lambda: None)


def test_output_goes_to_the_log_of_the_job(job, script, in_this_process, capsys):
    with stage.logged(job, str(script)):
        stage.log.info("mean %.1f um", 3.25)
        print("printed")
        print("complained", file=sys.stderr)
    assert job.log[0].read_text() == "work: made.nc\nmean 3.2 um\nprinted\ncomplained\n"
    assert capsys.readouterr() == ("", "")


def test_failure_that_nobody_worded_keeps_its_traceback(job, script, in_this_process):
    with pytest.raises(ValueError, match="could not convert"), stage.logged(job, str(script)):
        float("many")
    text = job.log[0].read_text()
    assert text.startswith("work: made.nc\nfailed: could not convert string")
    assert "Traceback" in text


def test_worded_failure_is_one_sentence(job, script, in_this_process):
    with pytest.raises(SystemExit), stage.logged(job, str(script)):
        half_backlash(1e-6, np.zeros(3), np.zeros((2, 3)), np.ones((2, 3)), 0.35, "exact")
    text = job.log[0].read_text()
    assert text.startswith("work: made.nc\nfailed: the teeth jam")
    assert text.count("\n") == 2


def test_streams_and_handlers_are_given_back(job, script, in_this_process):
    before = sys.stdout, sys.stderr, list(job.log.handlers)
    with pytest.raises(KeyboardInterrupt), stage.logged(job, str(script)):
        raise KeyboardInterrupt
    assert (sys.stdout, sys.stderr, list(job.log.handlers)) == before


def test_job_refuses_code_that_changed_since_the_workflow_read_it(job, script, in_this_process):
    job.params.code = "0" * 16
    ran = []
    with pytest.raises(SystemExit), stage.logged(job, str(script)):
        ran.append(True)
    assert ran == []
    assert "start it again" in job.log[0].read_text()


def test_log_is_written_line_by_line(job, script, in_this_process):
    with stage.logged(job, str(script)):
        stage.log.info("first")
        assert job.log[0].read_text() == "work: made.nc\nfirst\n"


def test_log_on_a_full_disk_speaks_on_the_screen(job, script, in_this_process, monkeypatch):
    job.log[0] = "/dev/full"
    screen = io.StringIO()
    monkeypatch.setattr(sys, "__stderr__", screen)
    with pytest.raises(SystemExit), stage.logged(job, str(script)):
        half_backlash(1e-6, np.zeros(3), np.zeros((2, 3)), np.ones((2, 3)), 0.35, "exact")
    assert screen.getvalue().startswith("work: made.nc\nfailed: the teeth jam")


def test_log_that_cannot_be_opened_is_named(job, script, in_this_process, tmp_path):
    job.log[0] = tmp_path / "nowhere" / "job.log"
    with pytest.raises(SystemExit, match="job.log: the log cannot be written \\(No such file"), stage.logged(job, "x"):
        pass


def test_input_files_are_checked_before_the_work(job, script, in_this_process, tmp_path):
    job.input = {"geometry": str(tmp_path / "geometry.nc")}
    ran = []
    with pytest.raises(SystemExit), stage.logged(job, str(script)):
        ran.append(True)
    assert ran == []
    assert "geometry.nc: no such file; run the workflow again" in job.log[0].read_text()


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


def test_job_ends_with_a_killed_workflow(tmp_path, script):
    runner, log = tmp_path / "runner.py", tmp_path / "job.log"
    runner.write_text(ORPHAN.format(scripts=str(SCRIPTS)))
    command = [sys.executable, "-c", WORKFLOW, str(runner), str(script), str(log)]
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
def test_job_that_starts_after_the_death_of_the_workflow_does_no_work(tmp_path, script, gone):
    runner, log = tmp_path / "runner.py", tmp_path / "job.log"
    runner.write_text(ORPHAN.format(scripts=str(SCRIPTS)).replace("sleep(60)", "sleep(0)"))
    with subprocess.Popen([sys.executable, "-c", "pass"]) as past:
        past.wait()
    workflow = past.pid if gone else os.getpid()
    environment = os.environ | {orphans.WORKFLOW: str(workflow)}
    run = subprocess.run([sys.executable, runner, script, log], env=environment, capture_output=True, text=True)
    assert (run.returncode, log.exists()) == ((1, False) if gone else (0, True))
    assert ("the workflow that started this job is gone" in run.stderr) == gone


def test_a_shell_may_stand_between_workflow_and_job(tmp_path, script):
    runner, log = tmp_path / "runner.py", tmp_path / "job.log"
    runner.write_text(ORPHAN.format(scripts=str(SCRIPTS)).replace("sleep(60)", "sleep(0)"))
    environment = os.environ | {orphans.WORKFLOW: str(os.getpid())}
    command = f"{shlex.join([sys.executable, str(runner), str(script), str(log)])}; true"
    run = subprocess.run(command, shell=True, env=environment, capture_output=True, text=True)
    assert "at work" in log.read_text() and run.stderr == ""
