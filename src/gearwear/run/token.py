"""What a run orders its jobs to do, told to those that read the workflow anew on another machine.

A job that an executor starts reads rules, sources and settings again. It must find what the run was
planned with, and the run that ordered it must not have been followed by another.
"""

from __future__ import annotations

import hashlib
import json
import os
from pathlib import Path
from typing import Any

from gearwear.errors import GearwearError
from gearwear.run.lock import LOCK

VARIABLE = "GEARWEAR_RUN"
REMEDY = "end what is left of it (on Slurm: scancel) and start the workflow again"


class Outdated(GearwearError):
    """What a job was ordered to do is no longer asked for."""


def plan_of(config: dict[str, Any], folder: Path, sources: str) -> str:
    """Return 16 hexadecimal digits that change with the checked settings, the rules and the sources.

    Parameters
    ----------
    folder : of the rules and their scripts.
    sources : key of the sources of the package.
    """
    total = hashlib.sha256(f"{json.dumps(config, sort_keys=True)}\0{sources}".encode())
    for path in sorted(path for path in folder.rglob("*") if path.suffix in (".py", ".smk")):
        total.update(f"\0{path.relative_to(folder)}\0".encode() + path.read_bytes())
    return total.hexdigest()[:16]


def give(plan: str, run: str = "") -> None:
    """Put plan and run into the environment, which executors hand on to their jobs."""
    os.environ[VARIABLE] = f"{plan} {run}".strip()


def check_plan(plan: str) -> None:
    """Compare what a job finds with what its run was planned with.

    Raises
    ------
    Outdated : sources or settings are others, or the executor did not hand the plan on.
    """
    given = os.environ.get(VARIABLE)
    if given is None:
        raise Outdated(f"{VARIABLE} is not set: the executor must hand the environment of the run on to its jobs")
    if given.split()[0] != plan:
        raise Outdated(f"sources or settings changed while the workflow was running: {REMEDY}")


def check_run() -> None:
    """See that no other run has begun in the working directory since this job was ordered.

    Raises
    ------
    Outdated : another run holds or held the working directory.
    """
    _, _, run = os.environ.get(VARIABLE, "").partition(" ")
    if run and LOCK.exists() and LOCK.read_text() not in ("", run):
        raise Outdated(f"the run that ordered this job was followed by another in {Path.cwd()}: {REMEDY}")
