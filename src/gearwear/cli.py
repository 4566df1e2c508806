"""Command line of the package: ``gearwear compare A B``."""

from __future__ import annotations

import argparse
import json
import math
import os
import re
import sys
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from gearwear import __version__
from gearwear.errors import GearwearError

if TYPE_CHECKING:
    from gearwear.compare import Comparison, Difference, Place

EQUAL, DIFFERENT, UNUSABLE = range(3)  # exit status
_LONGEST = 60  # characters of a value
_MOST_SETTINGS = 20
_SERIES = re.compile(r"(?:(?<=/)|^)(?:q\d{3,}|\d+-of-\d+)(?=\.nc$)")  # wear cycles, parts of a sweep, tiles of a map


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit status."""
    parser = argparse.ArgumentParser("gearwear", description="Results of the gearwear workflow.")
    parser.add_argument("--version", action="version", version=f"gearwear {__version__}")
    command = parser.add_subparsers(required=True, metavar="COMMAND").add_parser(
        "compare",
        help="compare two results folders or two result files",
        description="Compare two results folders, or two result files, variable by variable.",
        epilog="Exit status: 0 equal, 1 different, 2 an argument or a file cannot be used.",
    )
    command.add_argument("a", metavar="A", help="results folder, the folder that holds it, or a file (.nc, .csv)")
    command.add_argument("b", metavar="B", help="the same of the other run")
    command.add_argument(
        "--tolerance", type=float, default=0.0, metavar="REL", help="relative difference up to which numbers are equal"
    )
    command.add_argument("--figures", metavar="FOLDER", help="draw the curves of figures 6 to 12 of both runs there")
    command.add_argument("--json", action="store_true", help="print the table as JSON")
    given = parser.parse_args(arguments)
    try:
        return _compare(given)
    except BrokenPipeError:  # who reads the table has seen enough, as head does
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return DIFFERENT
    except GearwearError as error:
        print(f"gearwear compare: {error}", file=sys.stderr)
        return UNUSABLE


def _compare(given: argparse.Namespace) -> int:
    from gearwear.compare import compare

    found = compare(given.a, given.b, given.tolerance)
    if given.json:
        print(json.dumps(_plain(found, given.tolerance), indent=1, allow_nan=False))
    else:
        print("\n".join(_text(found, given.tolerance)))
    if given.figures is not None:
        from gearwear.figures.overlay import overlay

        for path in overlay(given.a, given.b, given.figures):
            print(path, file=sys.stderr)
    return EQUAL if found.equal else DIFFERENT


def _plain(found: Comparison, tolerance: float) -> dict[str, Any]:
    """Return the comparison as JSON has it: places as objects, NaN as null, infinity as text."""
    return _finite(
        {
            "equal": found.equal,
            "files": found.files,
            "tolerance": tolerance,
            "within_tolerance": found.within,
            "settings": [one._asdict() for one in found.settings],
            "differences": [
                one._asdict() | {"place": one.place._asdict(), "relative_place": one.relative_place._asdict()}
                for one in found.differences
            ],
        }
    )


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _finite(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(item) for item in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None if math.isnan(value) else str(value)
    return value


def _text(found: Comparison, tolerance: float) -> Iterator[str]:
    if found.settings:
        yield (
            "settings that differ: "
            + "; ".join(f"{one.key} {_setting(one.a)} / {_setting(one.b)}" for one in found.settings[:_MOST_SETTINGS])
            + (f"; and {more} more" if (more := len(found.settings) - _MOST_SETTINGS) > 0 else "")
        )
    groups: dict[str, list[Difference]] = {}
    for one in found.differences:
        groups.setdefault(_SERIES.sub("*", one.file), []).append(one)
    for series, members in groups.items():
        yield from _group(series, members)
    if found.within:
        yield f"{_count(found.within, 'variable')} equal within the relative tolerance {tolerance:g}"
    compared = f"{_count(found.files, 'file')} compared"
    if found.equal:
        yield f"equal{' within the tolerance' if found.within else ', bit for bit'}: {compared}"
    else:
        alone = sum(not one.variable for one in found.differences)
        files = len({one.file for one in found.differences if one.variable})
        parts = [f"{_count(len(found.differences) - alone, 'variable')} in {_count(files, 'file')}"] if files else []
        parts += [f"{_count(alone, 'file')} on one side only"] if alone else []
        yield f"different: {', '.join(parts)}; {compared}"


def _group(series: str, members: Sequence[Difference]) -> Iterator[str]:
    """Yield the lines of one file, or of the files of a series."""
    files = {one.file for one in members}
    name = series if len(files) > 1 else members[0].file
    variables: dict[tuple[str, str], list[Difference]] = {}
    for one in members:
        variables.setdefault((one.variable, one.what), []).append(one)
    for (variable, what), several in variables.items():
        if not variable:
            yield f"{name}: {what}" + (f" ({len(several)} files)" if len(several) > 1 else "")
    if any(variable for variable, _ in variables):
        yield name
    for (variable, _), several in variables.items():
        if variable:
            yield "  " + _line(several)


def _line(several: Sequence[Difference]) -> str:
    """Return the text of what differs in one variable."""
    first, many = several[0], len(several) > 1
    files = f" in {len(several)} files" if many else ""
    if first.what:
        return f"{first.variable}: {first.what}{files}"
    total, differing = sum(one.total for one in several), sum(one.differing for one in several)
    text = f"{first.variable}: {differing} of {_count(total, 'value')} differ{files}"
    if missing := sum(one.missing for one in several):
        text += f", {missing} of them missing (NaN) on one side"
    sized = [one for one in several if not math.isnan(one.absolute)]
    if not sized:
        return f"{text}; the first{_at(first, first.place, many)}{_values(first.place)}"
    largest, steepest = max(sized, key=lambda one: one.absolute), max(sized, key=lambda one: one.relative)
    place, relative_place = _at(largest, largest.place, many), _at(steepest, steepest.relative_place, many)
    text += f"; largest difference {_number(largest.absolute, first.unit)}{place}{_values(largest.place)}"
    relative = _number(steepest.relative)
    return (
        f"{text}, relative {relative}"
        if relative_place == place
        else (f"{text}, largest relative {relative}{relative_place}")
    )


def _at(difference: Difference, place: Place, many: bool) -> str:
    """Return the place of a difference, with its file if there are many."""
    at = [f"{name} = {_value(value, unit)}" for name, (value, unit) in place.at.items()]
    at += [difference.file.rpartition("/")[2]] if many else []
    return f" at {', '.join(at)}" if at else ""


def _values(place: Place) -> str:
    return f" (A {_value(place.a)}, B {_value(place.b)})"


def _value(value: Any, unit: str = "") -> str:
    if isinstance(value, float):
        return _number(value, unit)
    text = str(value)
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"


def _setting(value: Any) -> str:
    return "not set" if value is None else _value(json.dumps(value))


def _number(value: float, unit: str = "") -> str:
    return f"{value:.6g}{'' if unit in ('', '1') else ' ' + unit}"


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"


if __name__ == "__main__":
    sys.exit(main())
