"""The one reader and the one writer of netCDF files.

Every array gets its units and name from the table of variables. Every file carries the settings and the code that made
it, the path of the result that it holds, and a lineage: a digest over these and the lineages of its inputs. No time,
host or machine path is written: the same configuration gives the same bytes.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import netCDF4
import numpy as np
import xarray as xr

from gearwear.errors import BadFile, Infeasible
from gearwear.io.atomic import atomic
from gearwear.io.variables import is_key, variable_of

CONVENTIONS = "CF-1.11"
SOURCE = "gearwear"
_MARKS = {"stage", "lineage", "config", "inputs"}
_REMEDY = "delete it and run the workflow again"


@dataclass(frozen=True)
class Origin:
    """What makes a result: the stage, its settings, the digest of its code, the lineages of its inputs by name."""

    stage: str
    config: Mapping[str, Any]
    code: str
    inputs: Mapping[str, str] = field(default_factory=dict)

    @property
    def lineage(self) -> str:
        """16 hexadecimal digits that change with everything behind the result."""
        made_of = json.dumps([self.stage, self._config, self.code, dict(self.inputs)], sort_keys=True)
        return hashlib.sha256(made_of.encode()).hexdigest()[:16]

    @property
    def _config(self) -> str:
        return json.dumps(self.config, sort_keys=True)

    def attributes(self) -> dict[str, str]:
        """Return the attributes that tell it in a file."""
        return {
            "stage": self.stage,
            "config": self._config,
            "code": self.code,
            "inputs": json.dumps(dict(self.inputs), sort_keys=True),
            "lineage": self.lineage,
        }


def origin_of(dataset: xr.Dataset) -> Origin:
    """Return what made a dataset that `load` read."""
    attrs = dataset.attrs
    return Origin(attrs["stage"], json.loads(attrs["config"]), attrs["code"], json.loads(attrs["inputs"]))


def load(path: str | Path, variables: Sequence[str] | None = None) -> xr.Dataset:
    """Read a result into memory.

    Parameters
    ----------
    path : of the file.
    variables : those to read, without coordinates, in a seventh of the time; None reads everything.

    Raises
    ------
    BadFile : the file is missing, truncated, not written by this program, or holds a value that is not finite.
    """
    if variables is None:
        with _readable(path), xr.open_dataset(path, engine="netcdf4", decode_times=False) as lazy:
            dataset = lazy.load()
    else:
        with _readable(path), netCDF4.Dataset(path) as file:
            file.set_auto_maskandscale(False)
            read = {name: (file[name].dimensions, file[name][...]) for name in variables}
            dataset = xr.Dataset(read, attrs={name: file.getncattr(name) for name in file.ncattrs()})
    if dataset.attrs.get("source") != SOURCE or not dataset.attrs.keys() >= _MARKS:
        raise BadFile(f"{path}: not a result of this workflow (no lineage); {_REMEDY}")
    for name, values in dataset.variables.items():
        if values.dtype.kind == "f" and not np.isfinite(values).all() and not _may_be_missing(path, name, values):
            raise BadFile(f"{path}: {name} holds values that are not finite; {_REMEDY}")
    return dataset


def save(dataset: xr.Dataset, path: str | Path, origin: Origin) -> None:
    """Write a result, complete or not at all.

    Parameters
    ----------
    dataset : variables and coordinates of the table of variables.
    path : of the file.
    origin : what made it.

    Raises
    ------
    BadFile : a variable is unknown or has other dimensions than its entry, or the file cannot be written.
    Infeasible : a variable that must be finite is not.
    """
    from gearwear import __version__

    dataset = dataset.copy()
    for name in dataset.variables:
        _describe(dataset, str(name))
    dataset.attrs = {
        "Conventions": CONVENTIONS,
        "title": f"{origin.stage.replace('_', ' ')} of a worn, hot spur gear pair",
        "source": SOURCE,
        "version": __version__,
        "result": result_of(path),
        **origin.attributes(),
    }
    encoding = {name: {"_FillValue": None} for name in dataset.variables}
    with atomic(path) as temporary:
        dataset.to_netcdf(temporary, engine="netcdf4", encoding=encoding)


def result_of(path: str | Path) -> str:
    """Return the path of a result below the folder `results`; where there is none, its name."""
    parts = Path(path).parts
    below = parts[parts.index("results") + 1 :] if "results" in parts else parts[-1:]
    return "/".join(below)


def lineages(inputs: Mapping[str, Any]) -> dict[str, str]:
    """Return the lineages behind every named input, each once: the parts of one whole share theirs.

    Parameters
    ----------
    inputs : datasets, or lists of them; what is neither has no lineage.
    """
    found = {}
    for name, one in inputs.items():
        datasets = [each for each in (one if isinstance(one, list) else [one]) if isinstance(each, xr.Dataset)]
        if datasets:
            found[name] = " ".join(sorted({each.attrs["lineage"] for each in datasets}))
    return found


def together(parts: Iterable[xr.Dataset]) -> xr.Dataset:
    """Return parts of one state as one dataset."""
    return xr.merge(parts, compat="override", join="override", combine_attrs="drop")


def attributes_of(name: str, dims: tuple[str, ...], dtype: np.dtype) -> dict[str, Any]:
    """Return the attributes of a variable with these dimensions: units, long_name and flags (CF conventions).

    Raises
    ------
    BadFile : as in variables.variable_of.
    """
    entry = variable_of(name, dims)
    attributes: dict[str, Any] = {"long_name": entry.long_name}
    if entry.units:
        attributes["units"] = entry.units
    if entry.flags:
        numbers = np.array(list(entry.flags.values()), dtype=dtype)
        attributes |= {"flag_values": numbers, "flag_meanings": " ".join(entry.flags)}
    return attributes


@contextmanager
def _readable(path: str | Path) -> Iterator[None]:
    try:
        yield
    except FileNotFoundError:
        raise BadFile(f"{path}: no such file; run the workflow again to make it") from None
    except Exception as error:
        raise BadFile(f"{path}: not a readable netCDF file ({error}); {_REMEDY}") from None


def _may_be_missing(path: str | Path, name: Any, values: xr.Variable) -> bool:
    if is_key(str(name)):
        return False
    try:
        return variable_of(str(name), tuple(map(str, values.dims))).may_be_missing
    except BadFile as error:
        raise BadFile(f"{path}: {error}; {_REMEDY}") from None


def _describe(dataset: xr.Dataset, name: str) -> None:
    values = dataset[name]
    if is_key(name):
        if values.dims != (name,):
            raise BadFile(f"{name}: dimensions {values.dims}, expected a key of the configuration along itself")
        return
    entry = variable_of(name, tuple(map(str, values.dims)))
    if values.dtype.kind == "f" and not entry.may_be_missing and not np.isfinite(values).all():
        raise Infeasible(f"{name}: holds values that are not finite")
    values.attrs = attributes_of(name, tuple(map(str, values.dims)), values.dtype)
