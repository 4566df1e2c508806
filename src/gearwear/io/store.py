"""The one reader and the one writer of netCDF files.

Every array gets its units and name from `fields`; every file carries the settings and the code that
made it and a lineage, one digest over these and the lineages of its inputs. No time, host or path is
written: the same configuration gives the same bytes.
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import netCDF4
import numpy as np
import xarray as xr

from gearwear.errors import BadFile
from gearwear.io.atomic import atomic
from gearwear.io.variables import field_of

CONVENTIONS = "CF-1.11"
SOURCE = "gearwear"
_MARKS = {"stage", "lineage", "config", "inputs"}
_REMEDY = "delete it and run the workflow again"

# Name of a result file, or else of its folder, and the rules that make it.
_MADE_BY = {
    "geometry": ("build_geometry",),
    "temperature": ("heat_contact",),
    "deformation": ("grow_flanks",),
    "wear": ("start_wear", "advance_wear"),
    "mesh_stiffness": ("build_stiffness",),
    "transmission_error": ("share_load",),
    "backlash": ("open_backlash",),
    "response": ("solve_response",),
    "excitation": ("build_excitation", "give_excitation"),
    "parts": ("sweep_part",),
    "restart": ("join_sweep",),
    "up": ("carry_sweep",),
    "down": ("carry_sweep",),
    "branches": ("continue_orbits",),
    "portraits": ("trace_portraits",),
    "motions": ("trace_motions",),
    "basins": ("map_basins",),
    "chains": ("run_chain",),
    "tiles": ("map_tile", "map_temperature"),
    "maps": ("join_map",),
    "onsets": ("locate_onsets",),
    "onset_variants": ("vary_onsets",),
    "member_onsets": ("measure_onsets",),
    "onset_shifts": ("compare_onsets",),
    "measures": ("measure_member",),
    "outcome": ("measure_outcome",),
    "study": ("gather_study",),
    "sensitivity": ("compare_members",),
    "searches": ("search_parameters",),
    "calibration": ("compare_candidates",),
    "handover": ("gather_handover",),
}

# names of nothing else
_SINGLE = (
    "geometry",
    "excitation",
    "onsets",
    "onset_variants",
    "member_onsets",
    "onset_shifts",
    "measures",
    "outcome",
    "study",
    "sensitivity",
    "calibration",
    "handover",
)


@dataclass(frozen=True)
class Head:
    """What a result file says of itself: its rule, lineage, settings, the lineages of its inputs, its dimensions."""

    path: str
    stage: str
    lineage: str
    config: dict[str, Any]
    inputs: dict[str, str]
    sizes: dict[str, int]


def head(path: str | Path) -> Head:
    """Read what a result file says of itself; errors are those of `load`."""
    with _readable(path), netCDF4.Dataset(path) as file:
        attrs = {name: file.getncattr(name) for name in file.ncattrs()}
        sizes = {name: len(dimension) for name, dimension in file.dimensions.items()}
    _own(path, attrs)
    config, inputs = json.loads(attrs["config"]), json.loads(attrs["inputs"])
    return Head(str(path), attrs["stage"], attrs["lineage"], config, inputs, sizes)


def load(path: str | Path, variables: Sequence[str] | None = None) -> xr.Dataset:
    """Read a result of an earlier stage into memory.

    Parameters
    ----------
    path : of the file.
    variables : those to read, without coordinates, in a seventh of the time; None reads everything.

    Raises
    ------
    BadFile : the file is missing, truncated, not written by this program, or holds a value that
        is not finite; the message names the file and says what to do.
    """
    if variables is None:
        with _readable(path), xr.open_dataset(path, engine="netcdf4", decode_times=False) as lazy:
            dataset = lazy.load()
    else:
        with _readable(path), netCDF4.Dataset(path) as file:
            file.set_auto_maskandscale(False)
            read = {name: (file[name].dimensions, file[name][...]) for name in variables}
            dataset = xr.Dataset(read, attrs={name: file.getncattr(name) for name in file.ncattrs()})
    _own(path, dataset.attrs)
    for name, values in dataset.variables.items():
        try:
            optional = field_of(str(name), tuple(map(str, values.dims))).may_be_missing
        except ValueError as error:
            raise BadFile(f"{path}: {error}; {_REMEDY}") from None
        if values.dtype.kind != "f" or optional:
            continue
        if not np.isfinite(values).all():
            raise BadFile(f"{path}: {name} holds values that are not finite; {_REMEDY}")
    return dataset


@contextmanager
def _readable(path: str | Path) -> Iterator[None]:
    try:
        yield
    except FileNotFoundError:
        raise BadFile(f"{path}: no such file; run the workflow again to make it") from None
    except Exception as error:
        raise BadFile(f"{path}: not a readable netCDF file ({error}); {_REMEDY}") from None


def _own(path: str | Path, attrs: Mapping[str, Any]) -> None:
    if attrs.get("source") != SOURCE or not attrs.keys() >= _MARKS:
        raise BadFile(f"{path}: not a result of this workflow (no lineage); {_REMEDY}")
    expected = _makers(Path(path))
    if expected and attrs["stage"] not in expected:
        raise BadFile(f"{path}: a result of {attrs['stage']}, not of {' or '.join(expected)}; {_REMEDY}")


def _makers(path: Path) -> tuple[str, ...]:
    """Return the rules that may have made a result, by its place: a swept quantity may be named like a stage."""
    # Studies, members, cases and swept quantities may be called like stages or their folders.
    if path.stem in _SINGLE:
        return _MADE_BY[path.stem]
    folder, above = path.parent.name, path.parent.parent.name
    if re.fullmatch(r"\d+-of-\d+", path.stem):
        return _MADE_BY["tiles" if above == "tiles" else "parts"]
    if re.fullmatch(r"q\d{3}", path.stem) or folder in (
        "chains",
        "branches",
        "portraits",
        "basins",
        "maps",
        "searches",
    ):
        return _MADE_BY.get(folder, ())
    if above in ("sweeps", "motions") and folder in ("restart", "up", "down"):
        return _MADE_BY[folder if above == "sweeps" else above]
    return _MADE_BY[path.stem] if path.stem in ("temperature", "deformation") else ()


def save(dataset: xr.Dataset, job) -> None:
    """Write `dataset` as the output of `job`, complete or not at all.

    Parameters
    ----------
    dataset : variables and coordinates named in `fields.FIELDS`.
    job : object with `rule`, `input` (named files), `output`, `params.cfg` and `params.code`.

    Raises
    ------
    BadFile : a variable is unknown, has other dimensions than its entry or is not finite.
    """
    dataset = dataset.copy()
    for name in dataset.variables:
        _describe(dataset, str(name))
    config = json.dumps(job.params.cfg, sort_keys=True)
    inputs = lineages(job)
    made_of = json.dumps([job.rule, config, job.params.code, inputs], sort_keys=True)
    dataset.attrs = {
        "Conventions": CONVENTIONS,
        "title": f"{job.rule.replace('_', ' ')} of a worn, hot spur gear pair",
        "source": SOURCE,
        "stage": job.rule,
        "config": config,
        "code": job.params.code,
        "inputs": json.dumps(inputs, sort_keys=True),
        "lineage": hashlib.sha256(made_of.encode()).hexdigest()[:16],
    }
    encoding = {name: {"_FillValue": None} for name in dataset.variables}
    with atomic(job.output[0]) as temporary:
        dataset.to_netcdf(temporary, engine="netcdf4", encoding=encoding)


def mesh_states(inputs) -> tuple[xr.Dataset, xr.Dataset]:
    """Return the mesh of a state and that of the pristine reference case, each as one dataset.

    Parameters
    ----------
    inputs : named files `mesh_stiffness`, `transmission_error`, `backlash`, `reference_stiffness`, `reference_error`.
    """
    state = [load(path) for path in (inputs.mesh_stiffness, inputs.transmission_error, inputs.backlash)]
    reference = [load(path) for path in (inputs.reference_stiffness, inputs.reference_error)]
    return together(state), together(reference)


def together(parts: Iterable[xr.Dataset]) -> xr.Dataset:
    """Return parts of one state as one dataset."""
    return xr.merge(parts, compat="override", join="override", combine_attrs="drop")


def lineage(path: str | Path) -> str:
    """Return the lineage of a result file."""
    with netCDF4.Dataset(path) as file:
        return file.lineage


def lineages(job) -> dict[str, str]:
    """Return the lineages behind every named input of `job`, each once: the parts of one whole share theirs."""
    found = {}
    for name, paths in sorted(job.input.items()):
        several = [paths] if isinstance(paths, str | Path) else paths
        behind = sorted({lineage(path) for path in several if str(path).endswith(".nc")})
        if behind:
            found[name] = " ".join(behind)
    return found


def _describe(dataset: xr.Dataset, name: str) -> None:
    values = dataset[name]
    field = field_of(name, tuple(map(str, values.dims)))
    if values.dtype.kind == "f" and not field.may_be_missing and not np.isfinite(values).all():
        raise BadFile(f"{name}: holds values that are not finite")
    values.attrs = {"long_name": field.long_name}
    if field.units:
        values.attrs["units"] = field.units
    if field.flags:
        numbers = np.array(list(field.flags.values()), dtype=values.dtype)
        values.attrs |= {"flag_values": numbers, "flag_meanings": " ".join(field.flags)}
