"""Runs that are killed at random moments, and what the next run makes of what they left."""

import os
import random
import shutil
import signal
import time
from contextlib import suppress
from pathlib import Path

import pytest

SEED = 20230401
DATA = ("*.nc", "*.csv", "*.svg", "*.png", "*.html")


def at_work(folder: Path) -> list[int]:
    """Return the jobs that run in a folder."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        try:
            here = (process / "cwd").readlink() == folder
            command = (process / "cmdline").read_bytes()
        except OSError:  # it ended, or belongs to somebody else
            continue
        if here and b".snakemake/scripts/" in command:
            found.append(int(process.name))
    return found


def until(condition, seconds: float) -> bool:
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.02)
    return condition()


def results(folder: Path) -> dict[str, bytes]:
    """Return the contents of all results by name."""
    whole = folder / "results"
    files = [path for kind in DATA for path in whole.rglob(kind)]
    return {path.relative_to(whole).as_posix(): path.read_bytes() for path in files}


@pytest.fixture
def begun(smoke_run):
    """Return a function that starts the smoke run in another folder."""
    configs = [str(smoke_run.folder / "config" / name) for name in ("config.yaml", "smoke.yaml")]

    def begin(folder: Path, *arguments: str):
        return smoke_run.started("--directory", str(folder), "--configfile", *configs, *arguments)

    return begin


def killed(begun, folder: Path, chance: random.Random, longest: float, *arguments: str) -> str:
    """Start a run and kill it, or a job of it, at a random moment; return what was killed, "" if it ended before."""
    run = begun(folder, *arguments)
    try:
        whom, moment = chance.choice(("snakemake", "job")), chance.uniform(0, longest)
        until(lambda: at_work(folder) or run.poll() is not None, 300)
        until(lambda: run.poll() is not None, moment)
        if whom == "job":
            until(lambda: at_work(folder) or run.poll() is not None, 60)
        if whom == "snakemake":
            run.kill()
        for process in at_work(folder)[:1] if whom == "job" else ():
            with suppress(ProcessLookupError):
                os.kill(process, signal.SIGKILL)
        run.communicate(timeout=300)  # after the loss of a job, snakemake ends by itself
        if run.returncode == 0:
            return ""
        left = results(folder)
        assert until(lambda: not at_work(folder), 60), f"{whom} was killed, and a job goes on"
        assert results(folder) == left, f"{whom} was killed, and a job went on writing"
        return f"{whom} after {moment:.2f} s"
    finally:
        if run.poll() is None:
            os.killpg(run.pid, signal.SIGKILL)
            run.communicate()


def completed(run) -> str:
    with run:
        try:
            printed, _ = run.communicate()
        finally:
            run.kill()
    assert run.returncode == 0, printed
    return printed


MADE = ("wear", "mesh_stiffness", "transmission_error", "backlash", "response")
LOST = [f"results/n0700_t060/{name}/q001.nc" for name in MADE]
TARGETS = ("--", LOST[-1])


def lose(folder: Path):
    """Remove what the targets need: the last wear cycle of a case, three jobs one after another."""
    for name in LOST:
        (folder / name).unlink(missing_ok=True)


@pytest.fixture
def chain(smoke_run, tmp_path):
    """A folder with a copy of the smoke run without the last wear cycle of one case."""
    for name in ("results", ".snakemake"):
        shutil.copytree(smoke_run.folder / name, tmp_path / name, ignore=shutil.ignore_patterns("scripts"))
    lose(tmp_path)
    return tmp_path


def test_killed_runs_end_with_the_results_of_an_undisturbed_one(chain, begun, smoke_run, tmp_path_factory, long):
    """Moments, victims and seed are printed. The long form kills the whole smoke run, the quick one a wear cycle."""
    chance = random.Random(SEED)
    if long:
        folder, arguments, wanted, longest = tmp_path_factory.mktemp("killed"), ("-j2", "--", "all"), 20, 15.0
    else:
        folder, arguments, wanted, longest = chain, ("-j2", *TARGETS), 3, 3.0
    # What a run without the profile leaves behind when it is killed.
    locks = folder / ".snakemake" / "locks"
    locks.mkdir(parents=True, exist_ok=True)
    (locks / "0.output.lock").write_text("results/geometry.nc\n")
    kills = []
    while len(kills) < wanted:
        if kill := killed(begun, folder, chance, longest, *arguments):
            kills.append(kill)
            print(f"seed {SEED}, kill {len(kills)}: {kill}", flush=True)
        else:  # it came to its end before the moment
            lose(folder)
    completed(begun(folder, *arguments))
    assert "Nothing to be done" in completed(begun(folder, "-n", *arguments))
    found, expected = results(folder), results(smoke_run.folder)
    assert "n0700_t060/backlash/q001.nc" in found and set(found) == set(expected)
    assert [name for name in expected if found[name] != expected[name]] == []


def test_second_run_in_the_same_folder_is_refused(chain, begun):
    with begun(chain, "-j1", *TARGETS) as first:
        try:
            assert until(lambda: at_work(chain), 120)
            second = begun(chain, "-j1", *TARGETS)
            printed, _ = second.communicate()
            assert second.returncode != 0
            assert f"another run of this workflow is at work in {chain}" in printed
            assert first.poll() is None
        finally:
            first.kill()
    assert until(lambda: not at_work(chain), 60)
