"""How a stage job behaves: its log, its failures, its end."""

from __future__ import annotations

import ctypes
import linecache
import logging
import os
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress

from gearwear.plumbing.closure import digest
from gearwear.plumbing.orders import check_run

log = logging.getLogger("gearwear")

_PR_SET_PDEATHSIG = 1


@contextmanager
def logged(job, script: str) -> Iterator[None]:
    """Run the body of a stage job with its output in the job's log file.

    An error that the project words itself is one sentence in the log; any other keeps its traceback.

    The job stops with its parent, so that no orphan goes on writing after Snakemake was killed, and
    refuses to start if its source changed after Snakemake read it, so that no result is mislabelled,
    or if another run has followed the one that ordered it.

    Parameters
    ----------
    job : the `snakemake` object of the script.
    script : path of the script.
    """
    _die_with_parent()
    with open(job.log[0], "w", buffering=1) as stream:
        keep = sys.stdout, sys.stderr
        sys.stdout = sys.stderr = stream
        handler = logging.StreamHandler(stream)
        handler.setFormatter(logging.Formatter("%(message)s"))
        log.addHandler(handler)
        log.setLevel(logging.INFO)
        try:
            log.info("%s: %s", job.rule, ", ".join(job.output))
            if job.params.code != digest(script):
                raise ValueError("the source code changed while the workflow was running: start it again")
            check_run()
            yield
        except ValueError as error:
            if not worded(error):
                log.exception("failed: %s", error)
                raise
            log.error("failed: %s", error)
            raise SystemExit(1) from None
        except Exception as error:
            log.exception("failed: %s", error)
            raise
        finally:
            log.removeHandler(handler)
            sys.stdout, sys.stderr = keep


def worded(error: ValueError) -> bool:
    """Return whether `error` comes from a `raise` of this project's code, and not from inside a library."""
    trace = error.__traceback__
    while trace.tb_next is not None:
        trace = trace.tb_next
    file, line = trace.tb_frame.f_code.co_filename, trace.tb_lineno
    return linecache.getline(file, line).lstrip().startswith("raise ") and "site-packages" not in file


def announce(sentence: str) -> None:
    """Say `sentence` in the log and on the screen."""
    log.info("%s", sentence)
    print(sentence, file=sys.__stdout__, flush=True)


def _die_with_parent() -> None:
    parent = os.getppid()
    with suppress(OSError, AttributeError):  # Linux only
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGTERM)
    if os.getppid() != parent:  # it was gone before the call
        raise SystemExit("the workflow that started this job is gone")
