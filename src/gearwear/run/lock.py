"""One run at a time in a working directory."""

from __future__ import annotations

import fcntl
import os
import re
import secrets
from pathlib import Path

LOCK = Path(".snakemake") / "run.lock"
# Options of snakemake that show something and make no result; -n may stand in a group such as -np.
LOOKING = re.compile(
    r"-[a-zA-Z]*n[a-zA-Z]*|-[SDlh]|--(dry-?run|summary|detailed-summary|report|dag|d3dag|rulegraph|filegraph|lint|list.*"
    r"|unlock|archive|generate-unit-tests|print-compilation|help|version)"
)
_held: list[int] = []


class RunningAlready(RuntimeError):
    """Another run holds the working directory."""


def only_looks(arguments: list[str]) -> bool:
    """Return whether a command line of snakemake shows something and makes no result."""
    return any(LOOKING.fullmatch(argument.partition("=")[0]) for argument in arguments)


class NoLocks(RuntimeError):
    """The working directory cannot be written or has no locks."""


def hold() -> str:
    """Hold the working directory until this process ends, however it ends: the kernel gives the lock back.

    Returns
    -------
    A name of this run, which the lock file bears until the next run.

    Raises
    ------
    RunningAlready : another run holds it.
    NoLocks : it cannot be written, or its file system does not know `flock`.
    """
    try:
        LOCK.parent.mkdir(exist_ok=True)
        descriptor = os.open(LOCK, os.O_RDWR | os.O_CREAT, 0o644)
    except OSError as error:
        raise NoLocks(
            f"{Path.cwd()}: cannot be written ({error.strerror}): run in a folder of your own with --directory FOLDER"
        ) from None
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        os.close(descriptor)
        raise RunningAlready(
            f"another run of this workflow is at work in {Path.cwd()}: wait for its end or run in another directory"
        ) from None
    except OSError as error:
        os.close(descriptor)
        raise NoLocks(
            f"{Path.cwd()}: its file system refuses locks ({error.strerror}): have it mounted with flock, "
            "or run on another with --directory"
        ) from None
    name = secrets.token_hex(8)
    os.truncate(descriptor, 0)
    os.write(descriptor, name.encode())
    _held.append(descriptor)
    return name
