"""How a stage job behaves: its log, its failures, its end."""

from __future__ import annotations

import gc
import logging
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import TextIO

from gearwear.errors import BadFile, GearwearError
from gearwear.run import inputs
from gearwear.run.digest import digest
from gearwear.run.orphans import end_with_workflow
from gearwear.run.token import check_run

log = logging.getLogger("gearwear")


@contextmanager
def logged(job, script: str) -> Iterator[None]:
    """Run the body of a stage job with its output in the job's log file.

    A GearwearError is one sentence in the log; any other exception keeps its traceback.

    The job stops with its parent, so that no orphan goes on writing after Snakemake was killed, and
    refuses to start if its source changed after Snakemake read it, so that no result is mislabelled, if another
    run has followed the one that ordered it, or if its input files do not belong together.

    Parameters
    ----------
    job : the `snakemake` object of the script.
    script : path of the script.
    """
    end_with_workflow()
    with _opened(job.log[0]) as stream, _hidden("pint"):  # xarray asks of every array whether it is of its kind
        keep = sys.stdout, sys.stderr
        sys.stdout = sys.stderr = stream
        handler = _Handler(stream)
        handler.setFormatter(logging.Formatter("%(message)s"))
        log.addHandler(handler)
        log.setLevel(logging.INFO)
        try:
            log.info("%s: %s", job.rule, ", ".join(job.output))
            if job.params.code != digest(script):
                raise BadFile("the source code changed while the workflow was running: start it again")
            check_run()
            inputs.check(job)
            yield
        except GearwearError as error:
            log.error("failed: %s", error)
            raise SystemExit(1) from None
        except Exception as error:
            log.exception("failed: %s", error)
            raise
        finally:
            log.removeHandler(handler)
            sys.stdout, sys.stderr = keep
            gc.freeze()  # the process ends here: what is left needs no search for garbage


def announce(sentence: str) -> None:
    """Say `sentence` in the log and on the screen."""
    log.info("%s", sentence)
    print(sentence, file=sys.__stdout__, flush=True)


@contextmanager
def _hidden(module: str) -> Iterator[None]:
    """Let imports of `module`, if there were none, find nothing: the library that asks for it can do without."""
    hide = module not in sys.modules
    if hide:
        sys.modules[module] = None  # type: ignore[assignment]  # what makes an import fail
    try:
        yield
    finally:
        if hide:
            del sys.modules[module]


class _Handler(logging.StreamHandler):
    """A log that cannot be written, as on a full disk, speaks on the screen."""

    def handleError(self, record):  # noqa: N802 (the name is that of logging)
        print(self.format(record), file=sys.__stderr__, flush=True)


@contextmanager
def _opened(path: str) -> Iterator[TextIO]:
    try:
        stream = open(path, "w", buffering=1)  # noqa: SIM115 (closed below, where a full disk is no error)
    except OSError as error:
        raise SystemExit(f"{path}: the log cannot be written ({error.strerror})") from None
    try:
        yield stream
    finally:
        with suppress(OSError):  # what could not be written is on the screen
            stream.close()
