"""How a job of the workflow runs: it loads its inputs, calls the function of its stage and writes what that returns."""

from __future__ import annotations

import logging
import os
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from importlib import import_module
from inspect import signature
from pathlib import Path
from typing import Any, TextIO

import numpy as np

from gearwear.errors import BadFile, GearwearError
from gearwear.run import stages, token
from gearwear.run.digest import digest, source_key
from gearwear.run.orphans import end_with_workflow

log = logging.getLogger("gearwear")
SOURCES = "GEARWEAR_SOURCES"  # environment variable: the sources that the run was planned with


def run(job: Any) -> None:
    """Run the job of a stage.

    Parameters
    ----------
    job : the `snakemake` object of the script; `params.code` holds the digest of the stage by its name, since the rule
        has another name where the workflow is a module of another.
    """
    ((stage, code),) = job.params.code.items()
    with logged(job, {stages.target_of(stage): code}):
        inputs = load(job, stages.VARIABLES.get(stage, {}))
        available = {**wildcards(job), "cfg": job.params.cfg, **inputs}
        function = stages.function_of(stage)
        made = function(**{name: available[name] for name in signature(function).parameters})
        write(made, job.output, origin(stage, job.params.cfg, code, inputs))


def run_block(job: Any) -> None:
    """Run several wear cycles in one job, by the stages of the cycle.

    Parameters
    ----------
    job : `params.cfg` and `params.code` hold those of every stage by its name, every output the files of all cycles.
    """
    from gearwear.chain.cycle import CYCLE
    from gearwear.chain.history import results_of
    from gearwear.io.store import load as read

    with logged(job, {stages.target_of(stage): code for stage, code in job.params.code.items()}):
        available = load(job, {})
        for place in range(len(job.output.wear)):
            for stage, names in CYCLE.items():
                cfg, code, function = job.params.cfg[stage], job.params.code[stage], stages.function_of(stage)
                used = {name: available[name] for name in signature(function).parameters if name != "cfg"}
                made = results_of(function, {"cfg": cfg, **used})
                files = {name: job.output[name][place] for name in names}
                write(made, files, origin(stage, cfg, code, used))
                available |= {name: read(file) for name, file in files.items()}


def run_figure(job: Any) -> None:
    """Run the job of a figure.

    Parameters
    ----------
    job : `params.draw` is the draw function, as `module:function` of gearwear.figures; its other arguments are the
        inputs of the rule and `params.cfg`.
    """
    target = f"figures.{job.params.draw}"
    with logged(job, {target: job.params.code}):
        module, function = target.split(":")
        draw = getattr(import_module(f"gearwear.{module}"), function)
        inputs = load(job, draw.variables)
        style = inputs.pop("style")
        draw.write(inputs | {"cfg": job.params.cfg}, style, job.output.svg, job.output.png)


@contextmanager
def logged(job: Any, codes: Mapping[str, str]) -> Iterator[None]:
    """Run the body of a job with its output in the log file of the job.

    A GearwearError is one sentence in the log; any other exception keeps its traceback. The job ends with its parent,
    so that no orphan goes on writing after Snakemake was killed. It refuses to start if the sources changed after
    Snakemake read them, or if another run has followed the one that ordered it.

    Parameters
    ----------
    codes : digests with which the job was planned, by target.

    Raises
    ------
    SystemExit : after a GearwearError.
    """
    end_with_workflow()
    with _opened(job.log[0]) as stream:
        keep = sys.stdout, sys.stderr
        sys.stdout = sys.stderr = stream
        handler = _Handler(stream)
        handler.setFormatter(logging.Formatter("%(message)s"))
        log.addHandler(handler)
        log.setLevel(logging.INFO)
        try:
            log.info("%s: %s", job.rule, ", ".join(map(str, job.output)))
            if os.environ.get(SOURCES) != source_key() and any(digest(one) != code for one, code in codes.items()):
                raise BadFile("the source code changed while the workflow was running: start it again")
            token.check_run()
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


def report(sentence: str) -> None:
    """Write a sentence into the log and onto the screen."""
    log.info("%s", sentence)
    print(sentence, file=sys.__stdout__, flush=True)


def load(job: Any, variables: Mapping[str, tuple[str, ...]]) -> dict[str, Any]:
    """Return the inputs of a job by name: datasets of netCDF files, paths of others; lists where there are several.

    Parameters
    ----------
    variables : to read of an input; of those that are not named here, all.

    Raises
    ------
    BadFile : a file cannot be read, or does not belong to the configuration of the run or to the other files.
    """
    from gearwear.io import store
    from gearwear.run import inputs

    def read(name: str, path: str) -> Any:
        return store.load(path, variables.get(name)) if path.endswith(".nc") else Path(path)

    found = {
        name: read(name, str(paths)) if isinstance(paths, str | Path) else [read(name, str(path)) for path in paths]
        for name, paths in job.input.items()
    }
    inputs.check(job.input, found, job.config)
    return found


def wildcards(job: Any) -> dict[str, Any]:
    """Return the wildcards of a job by name; `part`, every n-th of some points, is what the n-th of m parts has."""
    found = dict(job.wildcards.items())
    if "scatteritem" in found:
        first, parts = (int(word) for word in found["scatteritem"].split("-of-"))
        found["part"] = slice(first - 1, None, parts)
    return found


def origin(stage: str, cfg: Any, code: str, inputs: Mapping[str, Any]) -> Any:
    """Return what makes the results of a stage from these inputs."""
    from gearwear.io import store

    return store.Origin(stage, cfg, code, store.lineages(inputs))


def write(made: Any, output: Any, origin: Any) -> None:
    """Write what a stage returned: datasets as netCDF, tables as CSV, text as it is.

    Parameters
    ----------
    made : a dataset, table or text, or several by the names of the outputs.
    output : files by name; of one without a name, the only one.
    """
    from gearwear.io import store
    from gearwear.io.atomic import atomic
    from gearwear.io.tables import Table, write_csv

    for name, one in made.items() if type(made) is dict else [(0, made)]:
        path = output[name]
        if isinstance(one, Table):
            write_csv(path, one.columns, one.rows)
        elif isinstance(one, str):
            with atomic(path) as temporary:
                Path(temporary).write_text(one, encoding="utf-8")
        else:
            log.info("%s", _ranges(one))
            store.save(one, path, origin)


def _ranges(dataset: Any) -> str:
    """Return the least and the greatest value of every variable of numbers."""

    found = []
    for name, values in dataset.data_vars.items():
        if values.dtype.kind == "f" and np.isfinite(values.values).any():
            found.append(f"{name} {np.nanmin(values.values):.6g} to {np.nanmax(values.values):.6g}")
    return "; ".join(found)


class _Handler(logging.StreamHandler[TextIO]):
    """A log that cannot be written, as on a full disk, speaks on the screen."""

    def handleError(self, record: logging.LogRecord) -> None:  # noqa: N802 (the name is that of logging)
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
