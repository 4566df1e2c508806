"""Jobs of the smoke run, as Snakemake made them, that can be run again one by one."""

import io
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from gearwear.run import stage


@dataclass(frozen=True)
class Job:
    """A job: the file that Snakemake ran, and the object that it gave to the script in it."""

    file: Path
    job: Any

    @property
    def files(self) -> list[tuple[str, str]]:
        """Name and path of every netCDF file that it reads."""
        named = [(name, [paths] if isinstance(paths, str) else paths) for name, paths in self.job.input.items()]
        return [(name, path) for name, paths in named for path in paths if path.endswith(".nc")]


def read(file: Path) -> Job:
    """Return the job behind a script that Snakemake left in `.snakemake/scripts`."""
    path, given = list(sys.path), {"__file__": str(file)}
    exec(file.read_text().splitlines()[1], given)
    sys.path[:] = path
    return Job(file, given["snakemake"])


@pytest.fixture(scope="session")
def every_job(smoke_run):
    """All jobs of the smoke run by their results."""
    found = map(read, (smoke_run.folder / ".snakemake" / "scripts").glob("*.py"))
    return {name: one for one in sorted(found, key=lambda one: one.job.output[0]) for name in one.job.output}


@pytest.fixture(scope="session")
def jobs(every_job):
    """One job of every rule of the smoke run, with as many inputs and as late in its wear chain as there is."""
    return {one.job.rule: one for one in sorted(every_job.values(), key=lambda one: len(one.files))}


@pytest.fixture(scope="session")
def long(request):
    """Return whether every fault is wanted, and not a quick choice of them."""
    return request.config.getoption("--long")


@pytest.fixture(scope="session")
def filled(smoke_run):
    """Return a function that fills a folder with the results of the smoke run, beside the program."""

    def fill(folder: Path) -> Path:
        shutil.copytree(smoke_run.folder / "results", folder / "results", dirs_exist_ok=True)
        for name in ("config", "workflow"):
            (folder / name).symlink_to(smoke_run.folder / name)
        return folder

    return fill


@pytest.fixture(scope="module")
def copied(filled, tmp_path_factory):
    """A folder with a copy of the results of the smoke run."""
    return filled(tmp_path_factory.mktemp("copied"))


@pytest.fixture
def tell(monkeypatch):
    """Return a function that runs a job in the current folder and tells what went wrong: its log and the screen."""
    monkeypatch.setattr(
        stage, "end_with_workflow", lambda: None
    )  # the test must not be bound to the life of its parent

    def run(job: Any) -> str:
        screen = io.StringIO()
        with monkeypatch.context() as here:
            here.setattr(sys, "__stderr__", screen)
            here.setattr(sys, "__stdout__", screen)
            try:
                (stage.run_figure if hasattr(job.params, "draw") else stage.run)(job)
            except SystemExit as end:
                return Path(job.log[0]).read_text() + screen.getvalue() + str(end)
        return ""

    return run


@pytest.fixture
def small_disk(tmp_path):
    """Return a function that mounts a small file system at a folder of the test; skips where that is not allowed."""
    mounted = []

    def mount(name: str, size: str) -> Path:
        folder = tmp_path / name
        folder.mkdir(parents=True)
        command = ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(folder)]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode:
            pytest.skip(f"no small disk can be mounted here: {done.stderr.strip()}")
        mounted.append(folder)
        return folder

    yield mount
    for folder in mounted:
        subprocess.run(["umount", "-l", str(folder)], check=True)
