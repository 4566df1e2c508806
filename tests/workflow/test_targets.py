"""The target `help` and the docstrings behind it."""

import fcntl
import re
from pathlib import Path

import pytest

from gearwear.run import help

ROOT = Path(__file__).resolve().parents[2]

SNAKEFILE = ROOT / "workflow" / "Snakefile"


def test_every_target_says_what_it_makes_and_what_it_costs():
    found = help.targets(SNAKEFILE)
    assert [target.name for target in found] == re.findall(r"^rule (\w+):", SNAKEFILE.read_text(), flags=re.MULTILINE)
    for target in found:
        assert target.makes.endswith("."), target
        assert bool(target.cost) == (target.name != "help"), target


def test_help_works_beside_a_run_and_with_a_wrong_configuration(make_project):
    project = make_project("help")
    (project.folder / "config" / "config.yaml").write_text("nonsense: 1\n")
    (project.folder / ".snakemake").mkdir()
    with open(project.folder / ".snakemake" / "run.lock", "w") as held:
        fcntl.flock(held, fcntl.LOCK_EX)
        run = project.snakemake("help")
    assert run.returncode == 0, run.stdout
    assert help.page(SNAKEFILE) in run.stdout
    assert not (project.folder / "results").exists()


def test_smoke_works_beside_a_run_in_a_folder_of_its_own(make_project):
    project = make_project("smoke_target")
    (project.folder / ".snakemake").mkdir()
    with open(project.folder / ".snakemake" / "run.lock", "w") as held:
        fcntl.flock(held, fcntl.LOCK_EX)
        run = project.snakemake("-j2", "smoke", "--until=temperature")
    assert run.returncode == 0, run.stdout
    assert (project.folder / "smoke" / "results" / "with" / "temperature.nc").exists()
    assert not (project.folder / "results").exists()


@pytest.mark.parametrize(
    ("arguments", "asked"),
    [
        (["help"], True),
        (["-j2", "help"], True),
        (["-j", "2", "help"], True),
        (["-j2", "all", "help"], False),
        (["-j2", "all", "--directory", "help"], False),
        (["--help"], False),
        ([], False),
    ],
)
def test_help_is_asked_for_alone(arguments, asked):
    assert help.asked(arguments, "help") is asked
