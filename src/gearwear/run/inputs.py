"""Whether the files that a job reads belong to the configuration of the run and to each other.

Snakemake judges a file by its time. A file of another configuration that was copied among the results, or left
there, has the right name and the right variables: what it was made of tells it apart.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from gearwear.errors import BadFile
from gearwear.io import store

_REMEDY = "delete it and run the workflow again"

# Inputs that describe one state of the flanks; of the reference case, the names that its own files know them by.
_STATE = (
    "geometry",
    "temperature",
    "deformation",
    "wear",
    "mesh_stiffness",
    "transmission_error",
    "backlash",
    "excitation",
)
_REFERENCE = {"geometry": "geometry", "reference_stiffness": "mesh_stiffness", "reference_error": "transmission_error"}


def check(job) -> None:
    """Refuse input files that do not belong together.

    Parameters
    ----------
    job : object with `input` (named files) and `config`, the whole configuration of the run.

    Raises
    ------
    BadFile : a file is unreadable or foreign, was made with other settings, of other files or on another grid than
        those read beside it; the message names it and says what to do.
    """
    heads = {name: [store.head(path) for path in _results(paths)] for name, paths in job.input.items()}
    for head in (head for several in heads.values() for head in several):
        _made_with(head, job.config)
    single = {name: several[0] for name, several in heads.items() if len(several) == 1}
    for name, several in heads.items():
        for head in several:
            _made_of(head, _expected(name, head, single))
            _on_the_grid_of(head, single.get("geometry"))
        if name == "parts" and (other := next((head for head in several if head.lineage != several[0].lineage), None)):
            raise BadFile(f"{other.path}: not of one making with {several[0].path}; {_REMEDY}")


def _results(paths: Any) -> list[str]:
    several = [paths] if isinstance(paths, str | Path) else paths
    return [str(path) for path in several if str(path).endswith(".nc")]


def _made_with(head: store.Head, config: Mapping) -> None:
    parts = Path(head.path).parts
    if "studies" in parts:  # members have a configuration of their own
        return
    case = config.get("cases", {}).get(parts[1]) if len(parts) > 2 else None
    now = {**config, "case": case or {}}
    for path, value in _leaves(head.config):
        found: Any = now
        for key in path:
            found = found.get(key) if isinstance(found, Mapping) else None
        if found is not None and json.dumps(found) != json.dumps(value):
            raise BadFile(f"{head.path}: made with {'.'.join(path)} {value}, and it is {found} now; {_REMEDY}")


def _leaves(settings: Mapping, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Any]]:
    for key, value in settings.items():
        if isinstance(value, Mapping):
            yield from _leaves(value, (*path, key))
        else:
            yield (*path, key), value


def _expected(name: str, head: store.Head, single: Mapping[str, store.Head]) -> dict[str, store.Head]:
    """Return the files read beside `head` that should be those it was made of."""
    if name in _REFERENCE and name != "geometry":
        return {known: single[own] for own, known in _REFERENCE.items() if own in single}
    names = ("geometry",) if head.stage == "advance_wear" else _STATE  # worn flanks are made of the cycle before
    return {own: single[own] for own in names if own in single}


def _made_of(head: store.Head, expected: Mapping[str, store.Head]) -> None:
    for name, beside in expected.items():
        if head.inputs.get(name, beside.lineage) != beside.lineage:
            raise BadFile(f"{head.path}: made of another file than {beside.path}; {_REMEDY}")


def _on_the_grid_of(head: store.Head, geometry: store.Head | None) -> None:
    for name in ("path", "mesh_phase"):
        if geometry and (wanted := geometry.sizes[name]) != head.sizes.get(name, wanted):
            raise BadFile(f"{head.path}: {head.sizes[name]} points of {name}, {geometry.path} has {wanted}; {_REMEDY}")
