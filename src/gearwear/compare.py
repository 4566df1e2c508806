"""Compare two results folders, or two result files, variable by variable.

Values are compared, with type, dimensions, coordinates, unit and flags. What says how a run was made is not: global
attributes of netCDF files, and the tables ``versions.csv`` and ``parameters.csv``.
"""

from __future__ import annotations

import csv
import filecmp
import json
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

import netCDF4
import numpy as np

from gearwear.errors import BadFile

KINDS = (".nc", ".csv")
_PROVENANCE = ("versions.csv", "parameters.csv")
_MEANING = ("units", "coordinates", "flag_values", "flag_meanings")  # attributes that decide what values mean
_SWEPT = ("mesh_frequency", "ste", "backlash")  # name the points of a sweep, without being coordinates in every file


class Variable(NamedTuple):
    """Dimensions, values and attributes of a variable, or of a column of a table."""

    dims: tuple[str, ...]
    values: np.ndarray
    attributes: dict[str, Any]


class Place(NamedTuple):
    """Place of one value, and the value in A and in B.

    The place has value and unit of the coordinate along every dimension, or the index along one without coordinate.
    """

    at: dict[str, tuple[Any, str]]
    a: Any
    b: Any


_NOWHERE = Place({}, None, None)


class Difference(NamedTuple):
    """What differs in one variable, or in one file if `variable` is empty.

    what : in words, where it is not values that differ: missing, type, dimensions, shape, an attribute.
    unit : of the values in A.
    total, differing, missing : number of values, of those that differ, and of those that one side alone has (NaN).
    absolute, relative : largest differences of numbers that both sides have, NaN where there are none; the relative one
        is |A - B| over the larger of |A| and |B|.
    place, relative_place : of the largest absolute and relative difference. Where there is none, and for text and
        flags, `place` is that of the first value that differs.
    """

    file: str
    variable: str
    what: str = ""
    unit: str = ""
    total: int = 0
    differing: int = 0
    missing: int = 0
    absolute: float = math.nan
    place: Place = _NOWHERE
    relative: float = math.nan
    relative_place: Place = _NOWHERE


class Setting(NamedTuple):
    """A setting that differs: dotted key, values in A and in B (None: has no such key), the first file with them."""

    key: str
    a: Any
    b: Any
    file: str


@dataclass
class Comparison:
    """Result of `compare`.

    files : number of files found on both sides.
    differences : by file and variable; empty if everything is equal.
    within : number of variables that differ by no more than the tolerance.
    settings : those that differ, by key.
    """

    files: int = 0
    differences: list[Difference] = field(default_factory=list)
    within: int = 0
    settings: list[Setting] = field(default_factory=list)

    @property
    def equal(self) -> bool:
        """Whether nothing differs by more than the tolerance."""
        return not self.differences


def compare(a: str | Path, b: str | Path, tolerance: float = 0.0) -> Comparison:
    """Compare two results folders, or two files.

    Parameters
    ----------
    a, b : str or Path
        Two results folders (or the folders that hold them under the name ``results``), or two files of one kind
        (netCDF or CSV).
    tolerance : float
        Relative difference up to which two numbers count as equal; 0 asks for equal bits. NaN equals NaN.

    Returns
    -------
    Comparison

    Raises
    ------
    BadFile
        A path does not exist or holds nothing to compare, or a file cannot be read.
    """
    if not 0 <= tolerance < 1:
        raise BadFile(f"tolerance: {tolerance:g} must be at least 0 and below 1; it is relative")
    a, b = results_folder(a), results_folder(b)
    found, configs = Comparison(), list[tuple[str, dict[Any, Any], dict[Any, Any]]]()
    if a.is_dir() != b.is_dir():
        raise BadFile(f"{a} and {b}: one is a folder, the other a file; give two folders or two files")
    if not a.is_dir():
        if a.suffix != b.suffix:
            raise BadFile(f"{a} and {b}: files of two kinds; give two netCDF files or two CSV tables")
        pairs = {a.name: (a, b)}
    else:
        ours, theirs = _files(a), _files(b)
        for name in sorted(ours.keys() ^ theirs.keys()):
            found.differences.append(Difference(name, "", f"only in {'A' if name in ours else 'B'}"))
        pairs = {name: (ours[name], theirs[name]) for name in sorted(ours.keys() & theirs.keys())}
    found.files = len(pairs)
    for name, (one, other) in pairs.items():
        if filecmp.cmp(one, other, shallow=False):
            continue
        (x, config), (y, other_config) = read(one), read(other)
        configs.append((name, dict(_flat(config)), dict(_flat(other_config))))
        for difference in _of_file(name, x, y, tolerance):
            if difference is None:
                found.within += 1
            else:
                found.differences.append(difference)
    found.differences.sort(key=lambda difference: difference[:2])
    found.settings = _differing(configs)
    return found


def results_folder(path: str | Path) -> Path:
    """Return the folder that holds the results, for itself or for its parent; a file for a file.

    Raises
    ------
    BadFile : there is no such file or folder, or it is of no kind that can be compared.
    """
    path = Path(path)
    if not path.exists():
        raise BadFile(f"{path}: no such file or folder")
    if path.is_dir():
        path = path / "results" if (path / "results").is_dir() else path
        if not _files(path):
            raise BadFile(f"{path}: holds no netCDF file and no CSV table; give a results folder")
    elif path.suffix not in KINDS:
        raise BadFile(f"{path}: neither a netCDF file (.nc) nor a CSV table (.csv)")
    return path


def read(path: Path) -> tuple[dict[str, Variable], dict[str, Any]]:
    """Return the variables of a result file by name, and the settings behind it.

    Raises
    ------
    BadFile : the file cannot be read.
    """
    try:
        return _read_table(path) if path.suffix == ".csv" else _read_netcdf(path)
    except (OSError, RuntimeError, UnicodeDecodeError, csv.Error) as error:
        kind = "CSV table" if path.suffix == ".csv" else "netCDF file"
        raise BadFile(f"{path}: not a readable {kind} ({error})") from None


def _files(folder: Path) -> dict[str, Path]:
    found = {path.relative_to(folder): path for kind in KINDS for path in folder.rglob(f"*{kind}")}
    return {
        name.as_posix(): path
        for name, path in found.items()
        if name.name not in _PROVENANCE and not any(part.startswith(".") for part in name.parts)
    }


def _read_netcdf(path: Path) -> tuple[dict[str, Variable], dict[str, Any]]:
    found = {}
    with netCDF4.Dataset(path) as file:
        file.set_auto_maskandscale(False)
        for name, variable in file.variables.items():
            attributes = {key: variable.getncattr(key) for key in variable.ncattrs() if key in _MEANING}
            found[name] = Variable(variable.dimensions, np.asarray(variable[...]), attributes)
        config = getattr(file, "config", "{}")
    return found, json.loads(config)


def _read_table(path: Path) -> tuple[dict[str, Variable], dict[str, Any]]:
    with open(path, encoding="utf-8", newline="") as file:
        header, *rows = list(csv.reader(file)) or [[]]
    found = {}
    for place, heading in enumerate(header):
        cells = [row[place] if place < len(row) else "" for row in rows]
        unit = heading.partition("[")[2].removesuffix("]")
        found[heading] = Variable((header[0],), np.array(cells, dtype=object), {"units": unit} if unit else {})
    return found, {}


def _of_file(
    file: str, a: dict[str, Variable], b: dict[str, Variable], tolerance: float
) -> Iterator[Difference | None]:
    """Yield what differs in two files, None for a variable that differs within the tolerance only."""
    for name in sorted(a.keys() | b.keys()):
        if name not in a or name not in b:
            yield Difference(file, name, f"only in {'A' if name in a else 'B'}")
        elif unlike := _unlike(a[name], b[name]):
            yield Difference(file, name, unlike)
        else:
            yield from _of_values(file, name, a[name], b[name], a, tolerance)


def _of_values(
    file: str, name: str, a: Variable, b: Variable, known: Mapping[str, Variable], tolerance: float
) -> Iterator[Difference | None]:
    kind, flags = a.values.dtype.kind, "flag_values" in a.attributes
    if kind in "fiu" and not flags:
        yield from _of_numbers(file, name, a, b, known, tolerance)
    elif kind == "O" and (numbers := _numbers(a, b)):  # cells of a table
        found = list(_of_numbers(file, name, *numbers, known, tolerance))
        yield from found or _of_words(file, name, a, b, known)
    else:
        yield from _of_words(file, name, a, b, known)


def _numbers(a: Variable, b: Variable) -> tuple[Variable, Variable] | None:
    try:
        return a._replace(values=a.values.astype(np.float64)), b._replace(values=b.values.astype(np.float64))
    except ValueError:
        return None


def _unlike(a: Variable, b: Variable) -> str:
    """Return what forbids to compare the values, in words."""
    if a.values.dtype != b.values.dtype:
        return f"type {a.values.dtype} in A, {b.values.dtype} in B"
    if a.dims != b.dims:
        return f"dimensions ({', '.join(a.dims)}) in A, ({', '.join(b.dims)}) in B"
    if a.values.shape != b.values.shape:
        sizes = [" x ".join(map(str, one.values.shape)) for one in (a, b)]
        return f"{sizes[0]} values in A, {sizes[1]} in B"
    for key in _MEANING:
        ours, theirs = a.attributes.get(key, ""), b.attributes.get(key, "")
        if not np.array_equal(ours, theirs):
            return f"{key} {_short(ours)} in A, {_short(theirs)} in B"
    return ""


def _of_numbers(
    file: str, name: str, a: Variable, b: Variable, known: Mapping[str, Variable], tolerance: float
) -> Iterator[Difference | None]:
    x, y = np.asarray(a.values, order="C"), np.asarray(b.values, order="C")
    if x.tobytes() == y.tobytes():
        return
    if x.dtype.kind == "f":
        bits = f"i{x.dtype.itemsize}"
        unequal = np.asarray((x.view(bits) != y.view(bits)) & ~(np.isnan(x) & np.isnan(y)))
        wide_x, wide_y = x.astype(np.float64), y.astype(np.float64)
    else:
        unequal, wide_x, wide_y = np.asarray(x != y), x.astype(np.int64), y.astype(np.int64)
    if not unequal.any():
        return
    missing = unequal & (np.isnan(wide_x) | np.isnan(wide_y))
    with np.errstate(all="ignore"):
        absolute = np.asarray(np.abs(wide_x - wide_y), dtype=np.float64)
        largest = np.maximum(np.abs(wide_x), np.abs(wide_y))
        relative = np.where(np.isinf(absolute), np.inf, np.where(absolute > 0, absolute / largest, 0.0))
    if tolerance:
        unequal = unequal & (missing | (relative > tolerance))
    if not unequal.any():
        yield None
        return
    unit = str(a.attributes.get("units", ""))
    found = Difference(file, name, "", unit, x.size, int(unequal.sum()), int(missing.sum()))
    sized = unequal & ~missing
    if not sized.any():
        yield found._replace(place=_place(_largest(missing), a, b, known))
        return
    at, relative_at = (_largest(np.where(sized, sizes, -1.0)) for sizes in (absolute, relative))
    yield found._replace(
        absolute=float(absolute[at]),
        place=_place(at, a, b, known),
        relative=float(relative[relative_at]),
        relative_place=_place(relative_at, a, b, known),
    )


def _of_words(file: str, name: str, a: Variable, b: Variable, known: Mapping[str, Variable]) -> Iterator[Difference]:
    """Yield the difference of text, of flags, or of what else has no size."""
    unequal = np.asarray(a.values != b.values)
    if unequal.any():
        place = _place(_largest(unequal), a, b, known)
        yield Difference(file, name, total=a.values.size, differing=int(unequal.sum()), place=place)


def _largest(sizes: np.ndarray) -> tuple[Any, ...]:
    """Return the index of the largest value, the first of equal ones."""
    return np.unravel_index(np.argmax(sizes), sizes.shape)


def _place(index: tuple[Any, ...], a: Variable, b: Variable, known: Mapping[str, Variable]) -> Place:
    at: dict[str, tuple[Any, str]] = {}
    listed = str(a.attributes.get("coordinates", "")).split()
    for dim, position in zip(a.dims, index, strict=True):
        name = next((one for one in (dim, *listed, *_SWEPT) if one in known and known[one].dims == (dim,)), None)
        if name is None:
            at[dim] = int(position), "index"
        else:
            at[name] = _plain(known[name].values[position]), str(known[name].attributes.get("units", ""))
    return Place(at, *(_named(_plain(one.values[index]), one.attributes) for one in (a, b)))


def _plain(value: Any) -> Any:
    return value.item() if isinstance(value, np.generic | np.ndarray) else value


def _named(value: Any, attributes: Mapping[str, Any]) -> Any:
    """Return the name of a flag; any other value as it is."""
    if "flag_values" not in attributes:
        return value
    flags = zip(np.atleast_1d(attributes["flag_values"]).tolist(), attributes["flag_meanings"].split(), strict=False)
    return dict(flags).get(value, value)


def _short(value: Any) -> str:
    text = str(value)
    return repr(text if len(text) <= 60 else f"{text[:57]}...")


def _differing(configs: Sequence[tuple[str, dict[str, Any], dict[str, Any]]]) -> list[Setting]:
    """Return the settings that differ; one that only one of two files has must be in no file of the other side."""
    everywhere = [{key for config in configs for key in config[side]} for side in (1, 2)]
    found: dict[tuple[str, str], Setting] = {}
    for file, a, b in configs:
        for key in a.keys() | b.keys():
            both = a.get(key), b.get(key)
            comparable = (key in a or key not in everywhere[0]) and (key in b or key not in everywhere[1])
            if comparable and both[0] != both[1]:
                found.setdefault((key, repr(both)), Setting(key, *both, file))
    return sorted(found.values(), key=lambda setting: (setting.key, setting.file))


def _flat(settings: Any, path: tuple[str, ...] = ()) -> Iterator[tuple[str, Any]]:
    if isinstance(settings, dict) and settings:
        for key, value in settings.items():
            yield from _flat(value, (*path, str(key)))
    elif path:
        yield ".".join(path), settings
