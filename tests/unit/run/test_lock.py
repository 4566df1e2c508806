"""One run at a time in a working directory, even after a run was killed."""

import signal
import subprocess
import sys

import pytest

from gearwear.run import lock
from gearwear.run.lock import only_looks

HOLDER = """
import sys
from gearwear.run.lock import hold
hold()
print("held", flush=True)
sys.stdin.read()
"""


@pytest.fixture
def run(tmp_path):
    """Return a function that starts a process which holds the folder until its standard input ends."""
    started = []

    def start(folder=tmp_path):
        folder.mkdir(exist_ok=True)
        process = subprocess.Popen(
            [sys.executable, "-c", HOLDER],
            cwd=folder,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        started.append(process)
        return process

    yield start
    for process in started:
        process.kill()
        process.communicate()


def test_a_second_run_is_refused_with_the_folder_named(run, tmp_path):
    assert run().stdout.readline() == "held\n"
    output, error = run().communicate(timeout=30)
    assert output == ""
    assert "RunningAlready" in error and str(tmp_path) in error and "another run" in error


def test_the_lock_ends_with_the_run(run):
    first = run()
    assert first.stdout.readline() == "held\n"
    first.communicate(timeout=30)
    assert run().stdout.readline() == "held\n"


def test_the_lock_ends_with_a_killed_run(run):
    first = run()
    assert first.stdout.readline() == "held\n"
    first.send_signal(signal.SIGKILL)
    first.wait(timeout=30)
    assert run().stdout.readline() == "held\n"


def test_another_folder_is_free(run, tmp_path):
    assert run(tmp_path / "one").stdout.readline() == "held\n"
    assert run(tmp_path / "two").stdout.readline() == "held\n"


def test_the_process_that_tries_in_vain_can_try_again(run, tmp_path, monkeypatch):
    first = run()
    assert first.stdout.readline() == "held\n"
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(lock, "_held", [])
    with pytest.raises(lock.RunningAlready):
        lock.hold()
    assert lock._held == []
    first.communicate(timeout=30)
    lock.hold()
    (descriptor,) = lock._held
    lock.os.close(descriptor)


def test_every_run_has_a_name_of_its_own_in_the_lock_file(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(lock, "_held", [])
    names = []
    for _ in range(2):
        names.append(lock.hold())
        assert lock.LOCK.read_text() == names[-1]
        lock.os.close(lock._held.pop())
    assert len(set(names)) == 2


def test_a_file_system_without_locks_is_named(tmp_path, monkeypatch):
    def refuse(*_):
        raise OSError(38, "Function not implemented")

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(lock.fcntl, "flock", refuse)
    with pytest.raises(lock.NoLocks, match=r"Function not implemented.*--directory"):
        lock.hold()


@pytest.mark.parametrize("line", ["-n all", "-np", "all --dry-run", "--report=r.zip", "--list-rules", "--unlock", "-D"])
def test_commands_that_only_look_take_no_lock(line):
    assert only_looks(line.split())


@pytest.mark.parametrize(
    "line", ["-j2 all", "-call", "--cores 2", "-j2 --configfile config/config.yaml run.yaml", "-k -j 1"]
)
def test_commands_that_work_take_it(line):
    assert not only_looks(line.split())


def test_a_folder_that_cannot_be_written_is_named_with_the_option_that_helps(tmp_path, monkeypatch):
    def refuse(*_, **__):
        raise PermissionError(13, "Permission denied")

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(lock.Path, "mkdir", refuse)
    with pytest.raises(lock.NoLocks, match=f"{tmp_path}: cannot be written .Permission denied.: .* --directory FOLDER"):
        lock.hold()
