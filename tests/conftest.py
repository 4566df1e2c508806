"""One small run of the whole workflow, shared by the tests that look at it."""

import fcntl
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[1]
SMOKE = ("--configfile", "config/config.yaml", "config/smoke.yaml")


def pytest_addoption(parser):
    parser.addoption("--cluster", action="store_true", help="install and start Slurm, and test the run through it")
    parser.addoption("--long", action="store_true", help="the faults of tests/faults at every kind of stage and moment")


def pytest_collection_modifyitems(items):
    """Leave the many small files of the units for the end, where they fill the time of a worker that has no other."""
    items.sort(key=lambda item: item.path.is_relative_to(ROOT / "tests" / "unit"))


class Project:
    """A copy of the program in a folder of its own."""

    def __init__(self, folder: Path, source: Path = ROOT, results: tuple[str, ...] = ()):
        self.folder = folder
        self.printed = ""
        for name in ("Snakefile", "src", "workflow", "config", "profiles", *results):
            copy = shutil.copytree if (source / name).is_dir() else shutil.copy
            copy(source / name, folder / name)

    def snakemake(self, *arguments: str, cwd: Path | None = None, **variables: str) -> subprocess.CompletedProcess:
        """Run snakemake in the copy and return what it printed, both streams in `stdout`."""
        with self.started(*arguments, cwd=cwd, **variables) as run:
            printed, _ = run.communicate()
        return subprocess.CompletedProcess(run.args, run.returncode, printed)

    def started(self, *arguments: str, cwd: Path | None = None, **variables: str) -> subprocess.Popen:
        """Start snakemake in the copy, in a session of its own, with variables added to the environment."""
        environment = dict(os.environ) | {"PYTHONPATH": str(self.folder / "src")}
        return subprocess.Popen(
            [sys.executable, "-m", "snakemake", *arguments],
            cwd=cwd or self.folder,
            env=environment | variables,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            start_new_session=True,
        )

    def smoke(self, settings: dict | None = None) -> tuple[str, ...]:
        """Return the options of the smoke study, with settings laid over its own."""
        if not settings:
            return SMOKE
        (self.folder / "overlay.yaml").write_text(yaml.safe_dump(settings))
        return (*SMOKE, "overlay.yaml")

    def summary(self, *arguments: str) -> dict[str, bool]:
        """Return the result files behind targets, and whether they would be made anew."""
        table = self.snakemake("--summary", *arguments)
        assert table.returncode == 0, table.stdout
        files = re.findall(r"^(results/\S+)\t.*\t(update pending|no update)$", table.stdout, flags=re.MULTILINE)
        return {name: plan == "update pending" for name, plan in files}

    def planned(self, settings: dict | None = None) -> set[str]:
        """Return the result files of the smoke study that `snakemake all` would make anew."""
        files = self.summary("all", *self.smoke(settings))
        assert len(files) > 100
        return {name for name, anew in files.items() if anew}

    def jobs(self, *arguments: str) -> dict[str, int]:
        """Return how many jobs of every rule a dry run plans."""
        plan = self.snakemake("-n", *arguments)
        assert plan.returncode == 0, plan.stdout[-8000:]
        table = re.search(r"^Job stats:\n(.*?)\n\n", plan.stdout, flags=re.MULTILINE | re.DOTALL)
        counts = re.findall(r"^(\w+) +(\d+)$", table[1], flags=re.MULTILINE) if table else ()
        return {rule: int(count) for rule, count in counts}


@pytest.fixture(scope="session")
def make_project(tmp_path_factory):
    """Return a function that copies the program into a folder of its own."""
    return lambda name: Project(tmp_path_factory.mktemp(name))


@pytest.fixture(scope="session")
def smoke_run(request, tmp_path_factory):
    """A copy of the program after `snakemake -j2 all` on the smoke configuration, of which every worker has its own."""
    shared = tmp_path_factory.getbasetemp()
    if hasattr(request.config, "workerinput"):
        shared = shared.parent
    made = shared / "smoke_run"
    with open(shared / "smoke_run.lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # the first worker makes it, on all processors, and the others wait
        if not made.exists():
            project = Project(tmp_path_factory.mktemp("making"))
            # tests/faults run single jobs again
            run = project.snakemake("-j2", "all", *SMOKE, "--skip-script-cleanup")
            assert run.returncode == 0, run.stdout[-20000:]
            (project.folder / "printed.txt").write_text(run.stdout)
            project.folder.rename(made)
    project = Project(tmp_path_factory.mktemp("smoke"), made, ("results", ".snakemake"))
    project.printed = (made / "printed.txt").read_text()
    return project
