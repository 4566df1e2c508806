"""Whether the files that a job reads belong to the configuration of the run and to each other.

Snakemake judges a file by its time. A file of another configuration that was copied among the results, or left there,
has the right name and the right variables: what it was made of tells it apart.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any

import xarray as xr

from gearwear.errors import BadFile
from gearwear.io.store import origin_of, result_of

_REMEDY = "delete it and run the workflow again"

# Inputs that describe one state of the flanks, and those that one job makes together.
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
_TOGETHER = (("mesh_stiffness", "transmission_error", "backlash"), ("reference_stiffness", "reference_error"))
_GRIDS = ("path", "mesh_phase")


def check(files: Mapping[str, Any], loaded: Mapping[str, Any], config: Mapping[str, Any]) -> None:
    """Refuse input files that do not belong together.

    Parameters
    ----------
    files : path, or paths, of every named input.
    loaded : the same as datasets where they are results.
    config : the whole configuration of the run.

    Raises
    ------
    BadFile : a file holds another result than its place says, was made with other settings, of other files or on
        another grid than those read beside it; the message names it and says what to do.
    """
    results = {name: list(_results(files[name], one)) for name, one in loaded.items()}
    single = {name: several[0] for name, several in results.items() if isinstance(loaded[name], xr.Dataset)}
    for name, several in results.items():
        for path, dataset in several:
            if dataset.attrs.get("result") != result_of(path):
                raise BadFile(f"{path}: holds the result {dataset.attrs.get('result', 'of an old version')}; {_REMEDY}")
            _made_with(path, dataset, config)
            _made_of(path, dataset, _expected(name, dataset, single))
            _on_the_grid_of(path, dataset, single.get("geometry"))
    for made in (
        *([single[name] for name in names if name in single] for names in _TOGETHER),
        results.get("parts", []),
    ):
        _of_one_making(made)


def _results(paths: Any, loaded: Any) -> Iterator[tuple[str, xr.Dataset]]:
    if isinstance(loaded, xr.Dataset):
        yield str(paths), loaded
    elif isinstance(loaded, list):
        yield from ((str(path), one) for path, one in zip(paths, loaded, strict=True) if isinstance(one, xr.Dataset))


def _made_with(path: str, dataset: xr.Dataset, config: Mapping[str, Any]) -> None:
    below = result_of(path).split("/")
    if below[0] == "studies":  # members have a configuration of their own
        return
    case = config.get("cases", {}).get(below[0]) if len(below) > 1 else None
    now = {**config, "case": case or {}}
    for keys, value in _leaves(origin_of(dataset).config):
        found: Any = now
        for key in keys:
            found = found.get(key) if isinstance(found, Mapping) else None
        if found is not None and json.dumps(found) != json.dumps(value):
            raise BadFile(f"{path}: made with {'.'.join(keys)} {value}, and it is {found} now; {_REMEDY}")


def _leaves(settings: Mapping[str, Any], path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Any]]:
    for key, value in settings.items():
        if isinstance(value, Mapping):
            yield from _leaves(value, (*path, key))
        else:
            yield (*path, key), value


def _expected(name: str, dataset: xr.Dataset, single: Mapping[str, tuple[str, xr.Dataset]]) -> dict[str, Any]:
    """Return the files read beside a dataset that should be those it was made of."""
    # worn flanks are made of the cycle before, the reference of its own files
    names = ("geometry",) if dataset.attrs["stage"] == "wear" or name.startswith("reference_") else _STATE
    return {own: single[own] for own in names if own in single}


def _made_of(path: str, dataset: xr.Dataset, expected: Mapping[str, tuple[str, xr.Dataset]]) -> None:
    inputs = origin_of(dataset).inputs
    for name, (beside, other) in expected.items():
        if inputs.get(name, other.attrs["lineage"]) != other.attrs["lineage"]:
            raise BadFile(f"{path}: made of another file than {beside}; {_REMEDY}")


def _on_the_grid_of(path: str, dataset: xr.Dataset, geometry: tuple[str, xr.Dataset] | None) -> None:
    for name in _GRIDS if geometry else ():
        file, pair = geometry or ("", xr.Dataset())
        if pair.sizes[name] != dataset.sizes.get(name, pair.sizes[name]):
            raise BadFile(f"{path}: {dataset.sizes[name]} points of {name}, {file} has {pair.sizes[name]}; {_REMEDY}")


def _of_one_making(parts: list[tuple[str, xr.Dataset]]) -> None:
    for path, dataset in parts:
        if dataset.attrs["lineage"] != parts[0][1].attrs["lineage"]:
            raise BadFile(f"{path}: not made together with {parts[0][0]}; {_REMEDY}")
