"""A disk that is full or read-only: the reason is said, nothing half-written stays, and with room the run goes on."""

import os
import subprocess
from pathlib import Path

import pytest

SMOKE = ("--configfile", "config/config.yaml", "config/smoke.yaml")
QUICK = ("mesh_excitation", "plot_fig06", "claims", "parameters")
FULL = "cannot be written (No space left on device, ENOSPC); mend that and run the workflow again"


def fill(folder: Path, room: int) -> Path:
    """Fill the file system of a folder but for `room` bytes."""
    ballast = folder / "ballast"
    with open(ballast, "wb", buffering=0) as file:
        try:
            while True:
                file.write(bytes(1 << 16))
        except OSError:
            os.ftruncate(file.fileno(), max(file.tell() - room, 0))
    return ballast


@pytest.fixture
def on_small_disk(filled, small_disk, monkeypatch):
    """The results of the smoke run on a disk of 48 MB, below the current folder."""
    results = small_disk("results", "48m")
    monkeypatch.chdir(filled(results.parent))
    return results


def test_every_kind_of_job_says_that_the_disk_is_full(jobs, long, on_small_disk, smoke_run, tell):
    for rule in jobs if long else QUICK:
        one = jobs[rule]
        files = [Path(name) for name in one.job.output]
        for room in (0, 8192) if long and files[0].suffix == ".nc" else (0,):
            for file in (*files, Path(one.job.log[0])):
                file.unlink(missing_ok=True)
            ballast = fill(on_small_disk, room)
            told = tell(one.job)
            assert FULL in told and str(files[0].with_suffix("")) in told, (rule, room, told)
            assert "Traceback" not in told, (rule, room, told)
            assert not any(file.exists() for file in files) and not list(on_small_disk.rglob("*.tmp")), (rule, room)
            ballast.unlink()
        assert tell(one.job) == "", rule
        for file in files:
            assert file.read_bytes() == (smoke_run.folder / file).read_bytes(), file


def test_read_only_results_are_said_to_be(jobs, on_small_disk, tell):
    subprocess.run(["mount", "-o", "remount,ro", str(on_small_disk)], check=True)
    one = jobs["mesh_excitation"]
    assert f"{one.job.log[0]}: the log cannot be written (Read-only file system)" in tell(one.job)


def test_run_on_a_full_disk_goes_on_when_there_is_room(make_project, smoke_run, small_disk, tmp_path):
    project = make_project("full")
    results = small_disk("results", "80k")  # room for the geometry, not for the temperature
    (project.folder / "results").symlink_to(results)
    target = "results/with/temperature.nc"
    run = project.snakemake("-j1", *SMOKE, "--", target)
    assert run.returncode != 0 and FULL in run.stdout, run.stdout
    assert not (results / "with" / "temperature.nc").exists()
    subprocess.run(["mount", "-o", "remount,size=4m", str(results)], check=True)
    run = project.snakemake("-j1", *SMOKE, "--", target)
    assert run.returncode == 0 and "Building the gear pair" not in run.stdout, run.stdout
    assert (project.folder / target).read_bytes() == (smoke_run.folder / target).read_bytes()


def test_run_with_read_only_results_says_so(make_project, small_disk):
    project = make_project("readonly")
    results = small_disk("results", "4m")
    (project.folder / "results").symlink_to(results)
    subprocess.run(["mount", "-o", "remount,ro", str(results)], check=True)
    run = project.snakemake("-j1", *SMOKE, "--", "results/geometry.nc")
    assert run.returncode != 0 and "Read-only file system" in run.stdout and "results" in run.stdout, run.stdout
