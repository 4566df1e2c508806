"""The formatters, the linters and the type checker have nothing to say."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.parametrize(
    "command",
    [
        ("ruff", "check", "-q", "workflow", "tests", "examples"),
        ("ruff", "format", "-q", "--check", "workflow", "tests", "examples"),
        ("snakefmt", "--check", "Snakefile", "workflow/rules"),
        ("mypy",),
    ],
    ids=["ruff-check", "ruff-format", "snakefmt", "mypy"],
)
def test_source_is_clean(command):
    run = subprocess.run([sys.executable, "-m", *command], cwd=ROOT, capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr


# What the linter of Snakemake says and why it stays: all rules run in the one environment of requirements.lock, or in a
# container of it; and input functions stand beside the rules that use them, those of several files in common.smk.
ACCEPTED = {"Specify a conda environment or container for each rule.", "Mixed rules and functions in same snakefile."}


def test_the_linter_of_snakemake_says_nothing_else(tmp_path):
    command = (sys.executable, "-m", "snakemake", "--lint", "--directory", str(tmp_path))
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    said = re.findall(r"^    \* (.+?):?$", run.stderr, flags=re.MULTILINE)
    assert set(said) == ACCEPTED, run.stderr
