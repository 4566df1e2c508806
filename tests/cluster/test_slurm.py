"""The same bytes through Slurm as on this machine alone, in few jobs of the queue."""

import os
import re
import subprocess

import pytest

# A wear chain with its reference, a sweep in parts, portraits with their figure, a table: every group of the profile.
TARGETS = (
    "results/with/response/q001.nc",
    "results/without/sweeps/restart/mesh_frequency.nc",
    "results/figures/fig13.svg",
    "results/parameters.csv",
)
SMALL = ("--configfile", "config/config.yaml", "config/smoke.yaml", "--set-scatter", "sweep=2", "--", *TARGETS)
# There is no accounting here, and jobs are short.
SITE = ("--slurm-status-command", "squeue", "--slurm-no-account", "--slurm-init-seconds-before-status-checks", "3")


@pytest.fixture(scope="module")
def submitted(submitter, make_project):
    """A copy of the program after a run through Slurm."""
    project = make_project("submitted")
    run = subprocess.run(
        [submitter, "-m", "snakemake", "--workflow-profile", "profiles/slurm", *SITE, *SMALL],
        cwd=project.folder,
        env={key: value for key, value in os.environ.items() if key != "PYTHONPATH"},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    logs = [path.read_text()[-3000:] for path in (project.folder / ".snakemake" / "slurm_logs").rglob("*.log")]
    assert run.returncode == 0, run.stdout[-10000:] + "".join(logs)
    project.printed = run.stdout
    return project


def results(project):
    """The bytes of every result, by name."""
    folder = project.folder / "results"
    found = [path for path in folder.rglob("*") if path.suffix in (".nc", ".svg", ".csv", ".html")]
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in found}


def test_slurm_makes_the_bytes_of_a_local_run(submitted, make_project):
    local = make_project("local")
    run = local.snakemake("-j2", *SMALL)
    assert run.returncode == 0, run.stdout[-10000:]
    here, there = results(local), results(submitted)
    assert here.keys() == there.keys() and len(here) > 15
    assert [name for name in here if here[name] != there[name]] == []


def test_groups_spare_the_queue(submitted):
    jobs = re.findall(r"submitted with SLURM jobid (\d+)", submitted.printed)
    made = int(re.search(r"^total\s+(\d+)$", submitted.printed, flags=re.MULTILINE)[1])
    # geometry; the chains of two cases; the sweep; the portraits; figure and table
    assert len(set(jobs)) == 6 < made / 3


def test_a_run_through_slurm_needs_no_other_afterwards(submitted):
    plan = submitted.snakemake("-n", *SMALL)
    assert "Nothing to be done" in plan.stdout, plan.stdout[-3000:]


def test_nothing_is_left_in_the_queue(submitted, slurm):
    slurm.wait_for("jobs do not end", lambda: not slurm.jobs())
