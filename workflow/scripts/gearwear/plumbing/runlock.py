"""One run at a time in a working directory."""

from __future__ import annotations

import fcntl
import os
from pathlib import Path

LOCK = Path(".snakemake") / "run.lock"
_held: list[int] = []


class RunningAlready(RuntimeError):
    """Another run holds the working directory."""


def hold() -> None:
    """Hold the working directory until this process ends, however it ends: the kernel gives the lock back.

    Raises
    ------
    RunningAlready : another run holds it.
    """
    LOCK.parent.mkdir(exist_ok=True)
    descriptor = os.open(LOCK, os.O_RDWR | os.O_CREAT, 0o644)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        os.close(descriptor)
        raise RunningAlready(
            f"another run of this workflow is at work in {Path.cwd()}: wait for its end or run in another directory"
        ) from None
    _held.append(descriptor)
