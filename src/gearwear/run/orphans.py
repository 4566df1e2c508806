"""A job ends with the workflow that started it, so that nothing goes on writing after Snakemake was killed."""

from __future__ import annotations

import ctypes
import os
import signal
from contextlib import suppress
from pathlib import Path

# The process of Snakemake, told to the jobs: one that starts after its death has another parent and cannot know.
WORKFLOW = "GEARWEAR_WORKFLOW"
_PR_SET_PDEATHSIG = 1


def mark() -> None:
    """Let the jobs that this process starts know it."""
    os.environ[WORKFLOW] = str(os.getpid())


def end_with_workflow() -> None:
    """Ask the kernel to end this process with its parent, and end it now if the workflow is gone already.

    The workflow is the parent, or the parent of the shell that some systems leave between the two.

    Raises
    ------
    SystemExit : the workflow that started this job is gone.
    """
    with suppress(OSError, AttributeError):  # Linux only
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGTERM)
    workflow = int(os.environ.get(WORKFLOW, os.getppid()))
    with suppress(OSError):  # no /proc: not Linux, or the parent ended just now, and the kernel's signal is on its way
        if workflow not in (os.getppid(), _parent(os.getppid())):
            raise SystemExit("the workflow that started this job is gone")


def _parent(process: int) -> int:
    return int(Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[1])
