"""Rules that tie configuration keys to one another.

Every rule looks only at values that are valid on their own (missing ones are passed over), so that
all problems of a configuration appear in one message.
"""

from __future__ import annotations

import difflib
import itertools
import math
import re
from collections.abc import Callable, Iterator
from typing import Any

from gearwear.config.pair import MOST_CYCLES
from gearwear.config.parameters import CASE_NAME, ENDS, PLACES, SWEEPS
from gearwear.config.study import MOST_UPDATES
from gearwear.config.text import Problem, dotted, figure, listed, shown
from gearwear.config.tree import dotted_keys, value_at
from gearwear.heat.bulk import BALANCE, of_case

MOST_COMBINATIONS = 10_000
REQUIRED_CASES = ("without", "temperature_only", "wear_only", "with")
DRAWN_PORTRAITS = (("mesh_frequency", "without"), ("mesh_frequency", "with"), ("ste", "with"), ("backlash", "with"))
RESERVED_NAMES = ("figures", "logs", "benchmarks", "geometry", "studies")
_RANGES = (
    *((f"sweeps.{name}", "first", "last") for name in SWEEPS),
    *((f"maps.{name}", "first", "last") for name in SWEEPS),
    *((f"basins.{name}", "first", "last") for name in ("displacement", "velocity")),
    *((f"sensitivity.{name}", *ENDS) for name in PLACES),
)
MADE_STUDIES = ["temperature", "onsets", "sensitivity", "chains"]
_SIMPLE_RULES: list[tuple[tuple[str, ...], Callable[..., str]]] = []
_LONGEST_NAME = 60
_MOST_NAMED = 12
_FOLDER_NAME = f"use small letters, digits and underscores, a letter first, at most {_LONGEST_NAME} of them"


def disagreements(values: dict[str, Any]) -> Iterator[Problem]:
    """Yield path and message of every broken rule.

    Parameters
    ----------
    values : nested dict of the values that are valid on their own; others are absent.
    """
    for keys, message in _SIMPLE_RULES:
        found = [value_at(values, key) for key in keys]
        if None not in found and (text := message(*found)):
            yield tuple(keys[-1].split(".")), text
    for rule in _RULES:
        yield from rule(values)


def _rule(*keys: str) -> Callable[[Callable[..., str]], Callable[..., str]]:
    """Register a function of the values at these keys: the message about the last of them, empty if all is well."""

    def register(message: Callable[..., str]) -> Callable[..., str]:
        _SIMPLE_RULES.append((keys, message))
        return message

    return register


def _pair(values: Any, first: str, second: str) -> tuple[Any, Any] | None:
    found = value_at(values, first), value_at(values, second)
    return None if None in found else found


def _ranges(values: dict[str, Any]) -> Iterator[Problem]:
    for section, low, high in _RANGES:
        ends = _pair(values, f"{section}.{low}", f"{section}.{high}")
        if ends and ends[1] <= ends[0]:
            text = f"{figure(ends[1])} is not above {section}.{low}, {figure(ends[0])}"
            yield (*section.split("."), high), f"{text}; exchange them or widen the range"


def _temperatures(values: dict[str, Any]) -> Iterator[Problem]:
    initial = value_at(values, "heat.initial_temperature")
    tabled = value_at(values, "elasticity.law") == "table"
    for name, case in (value_at(values, "cases") or {}).items():
        path, (bulk, reason) = ("cases", name, "bulk_temperature"), of_case(values, case)
        if reason:
            yield path, reason
        if bulk is None:
            continue
        named = f"{BALANCE}, {bulk:.1f} degC," if case["bulk_temperature"] == BALANCE else bulk
        if initial is not None and bulk < initial:
            yield path, f"{named} is below heat.initial_temperature, {initial} degC; give at least that"
        elif tabled and not 20 <= bulk <= 260:
            yield path, f"{named} is outside the table of elasticity.law table, 20 to 260 degC; use law li or linear"


@_rule("lubricant.viscosity_law", "lubricant.dynamic_viscosity", "lubricant.dynamic_viscosity_40")
def _viscosity(law: str, hot: float, warm: float) -> str:
    if law != "vogel" or warm > hot:
        return ""
    return (
        f"{figure(warm)} is not above lubricant.dynamic_viscosity, {figure(hot)} Pa s; exchange them, oil is thicker "
        "at 40 degC than at 100 degC"
    )


@_rule("friction.dry", "friction.boundary")
def _friction(dry: float, boundary: float) -> str:
    return f"{boundary} is above friction.dry, {dry}; lower it or raise friction.dry" if boundary > dry else ""


@_rule("settling.transient_periods", "settling.longest_transient")
def _transient(first: int, longest: int) -> str:
    return f"{longest} is below settling.transient_periods, {first}; give at least that many" if longest < first else ""


@_rule("settling.largest_period", "settling.sampled_periods")
def _section(period: int, sampled: int) -> str:
    if sampled >= 4 * period:
        return ""
    return (
        f"{sampled} is too few to see settling.largest_period, {period}, come back in either half; give at least "
        f"{4 * period} mesh periods"
    )


@_rule("transmission_error.mode", "dynamics.ste_amplitude")
def _unloaded_error(mode: str, amplitude: str) -> str:
    if mode != "no_load" or amplitude == "harmonic":
        return ""
    return (
        f"{amplitude} compares with the loaded error of the pristine pair, and transmission_error.mode no_load has "
        "none; give harmonic"
    )


@_rule("heat.growth", "backlash.housing.temperature_rise")
def _housing(growth: str, rise: float) -> str:
    if rise == 0 or growth == "eulerian":
        return ""
    return (
        f"{rise} moves the shafts apart, and heat.growth {growth} leaves out the growth of the gear bodies towards "
        "each other that goes with it; give heat.growth eulerian, or 0"
    )


@_rule("dynamics.harmonics", "grid.mesh_cells")
def _resolution(highest: int | str, cells: int) -> str:
    if highest == "full" or cells >= 8 * int(highest):
        return ""
    return f"{cells} cells do not resolve dynamics.harmonics, {highest}; give at least {8 * int(highest)}"


def _torque(values: dict[str, Any]) -> Iterator[Problem]:
    yield from _phases(value_at(values, "dynamics.torque_fluctuation"), ("dynamics", "torque_fluctuation"))


def _phases(waves: Any, path: tuple[str, ...]) -> Iterator[Problem]:
    lists = _pair(waves, "amplitudes", "phases")
    if lists and len(lists[0]) != len(lists[1]):
        yield (
            (*path, "phases"),
            f"{len(lists[1])} phases for {len(lists[0])} amplitudes; give one phase for every amplitude",
        )


def _oscillators(values: dict[str, Any]) -> Iterator[Problem]:
    swept = [value_at(values, f"sweeps.{sweep}.cases") for sweep in SWEEPS]
    for name, oscillator in (value_at(values, "oscillators") or {}).items():
        path = ("oscillators", name)
        yield from _folder(path, name, "not a name of an oscillator")
        if name in (value_at(values, "cases") or {}):
            yield path, "the name is that of a case; choose another"
        if None not in swept and not any(name in cases for cases in swept):
            yield path, "swept nowhere; add it to sweeps.mesh_frequency.cases"
        for wave in ("stiffness", "error"):
            yield from _phases(value_at(oscillator, wave), (*path, wave))
        amplitudes = value_at(oscillator, "error.amplitudes")
        if amplitudes and not amplitudes[0] and any(amplitudes):
            yield (
                (*path, "error", "amplitudes"),
                "the first is 0 and another is not; all are scaled by the first, so give it a value, however small",
            )


def _maps(values: dict[str, Any]) -> Iterator[Problem]:
    case, cases = value_at(values, "maps.case"), value_at(values, "cases")
    if case is not None and isinstance(cases, dict) and case not in cases:
        yield ("maps", "case"), _no_such_case(case, cases)
    temperatures, initial = value_at(values, "maps.temperature") or [], value_at(values, "heat.initial_temperature")
    for position, value in enumerate(temperatures):
        path = ("maps", "temperature", f"[{position}]")
        if position and value <= temperatures[position - 1]:
            yield path, f"{value} is not above the value before, {temperatures[position - 1]} degC; sort the list"
        elif initial is not None and value < initial:
            yield path, f"{value} is below heat.initial_temperature, {initial} degC; give at least that"


def _cases(values: dict[str, Any]) -> Iterator[Problem]:
    if isinstance(value_at(values, "cases"), dict):
        yield from _case_names(values)
        yield from _updates(values)
        yield from _reference(values)
        yield from _case_lists(values)


def _case_names(values: dict[str, Any]) -> Iterator[Problem]:
    for name in values["cases"]:
        yield from _folder(("cases", name), name, "not a case name")
    for name in REQUIRED_CASES:
        if name not in values["cases"]:
            yield ("cases", name), "missing case; figures and claims read it, so give it its three keys"


def _studies(values: dict[str, Any]) -> Iterator[Problem]:
    for name, study in (value_at(values, "studies") or {}).items():
        if not _names_a_folder(name):
            yield ("studies", name), f"not a name of a study; {_FOLDER_NAME}"
        elif name in MADE_STUDIES:
            yield ("studies", name), f"the name is taken by a study of the program; use none of {listed(MADE_STUDIES)}"
        for member in value_at(study, "members") or {}:
            if not _names_a_folder(member):
                yield ("studies", name, "members", member), f"not a name of a member; {_FOLDER_NAME}"
        if isinstance(study, dict):
            yield from ((("studies", name, *path), text) for path, text in _grid(values, study))


def _grid(values: dict[str, Any], study: dict[str, Any]) -> Iterator[Problem]:
    grid, case, cases = study.get("grid") or {}, study.get("case", "with"), value_at(values, "cases")
    if bool(grid) == bool(study.get("members")):
        yield (), "a study has either members or a grid; give one of them"
    if grid and isinstance(cases, dict) and case not in cases:
        yield ("case",), _no_such_case(case, cases)
    known = dotted_keys({name: section for name, section in values.items() if name != "studies"})
    for key in grid:
        if key not in known:
            near = difflib.get_close_matches(key[:_LONGEST_NAME], known, 1)
            yield ("grid", key), f"no key with a value of its own{f'; did you mean {near[0]}?' if near else ''}"
    for key, several in grid.items():
        for before, value in itertools.pairwise(several):
            numbers = all(isinstance(one, int | float) and not isinstance(one, bool) for one in (before, value))
            if value in several[: several.index(value)] or (numbers and value <= before) or value == before:
                yield ("grid", key), f"{shown(value)} does not come after {shown(before)}; sort the values, each once"
    count = math.prod(len(several) for several in grid.values())
    if count > MOST_COMBINATIONS:
        yield ("grid",), f"{count} combinations are more than {MOST_COMBINATIONS}; give fewer values"


def _folder(path: tuple[str, ...], name: str, refusal: str) -> Iterator[Problem]:
    if not _names_a_folder(name):
        yield path, f"{refusal}; {_FOLDER_NAME}"
    elif name in RESERVED_NAMES:
        yield path, f"the name is taken by a folder of the results; use none of {listed(list(RESERVED_NAMES))}"


def _names_a_folder(name: str) -> bool:
    return bool(re.fullmatch(CASE_NAME, name)) and len(name) <= _LONGEST_NAME


def _updates(values: dict[str, Any]) -> Iterator[Problem]:
    step = value_at(values, "wear.cycles_per_update")
    for name, case in values["cases"].items():
        cycles = value_at(case, "running_cycles")
        if step is None or cycles is None:
            continue
        path = ("cases", name, "running_cycles")
        most, least = MOST_UPDATES * step, -(-cycles // MOST_UPDATES)
        if cycles > most:
            yield (
                path,
                f"{figure(cycles)} is more than {MOST_UPDATES} times wear.cycles_per_update, {figure(step)}; "
                f"give at most {figure(most)}, or raise wear.cycles_per_update to {figure(least)} or more",
            )
        elif cycles % step:
            below = cycles // step * step
            near = [below, below + step] if below + step <= min(most, MOST_CYCLES) else [below]
            yield (
                path,
                f"{figure(cycles)} is not a whole multiple of wear.cycles_per_update, {figure(step)}; "
                f"give {listed([figure(value) for value in near], 'or')}",
            )


def _reference(values: dict[str, Any]) -> Iterator[Problem]:
    name = value_at(values, "dynamics.reference_case")
    if name is None:
        return
    path = ("dynamics", "reference_case")
    if name not in values["cases"]:
        yield path, _no_such_case(name, values["cases"])
    elif value_at(values["cases"][name], "running_cycles"):
        yield path, f"case {dotted((name,))} is worn; name a case with running_cycles 0"


def _case_lists(values: dict[str, Any]) -> Iterator[Problem]:
    for path in (*(("sweeps", sweep, "cases") for sweep in SWEEPS), ("figures", "diagonal")):
        names = value_at(values, ".".join(path))
        known = values["cases"] if path[0] == "figures" else _known(values)
        for position, name in enumerate(names or []):
            if name not in known:
                yield (*path, f"[{position}]"), _no_such_case(name, known)
            elif name in names[:position]:
                yield (*path, f"[{position}]"), f"case {dotted((name,))} is listed twice; take one out"


def _portraits(values: dict[str, Any]) -> Iterator[Problem]:
    for sweep, case in () if value_at(values, "oscillators") else DRAWN_PORTRAITS:
        drawn = value_at(values, f"portraits.{sweep}")
        if drawn is not None and not drawn.get(case):
            yield ("portraits", sweep, case), "figures 13 to 18 draw this case; give a list with at least one value"
    yield from _chosen_values(values, "portraits")
    yield from _chosen_values(values, "basins.points")


def _chosen_values(values: dict[str, Any], section: str) -> Iterator[Problem]:
    """Problems of the values of sweeps that a section lists by sweep and case."""
    cases, given = value_at(values, "cases"), value_at(values, "oscillators")
    for sweep in SWEEPS:
        for name, drawn in (value_at(values, f"{section}.{sweep}") or {}).items():
            path = (*section.split("."), sweep, name)
            swept = value_at(values, f"sweeps.{sweep}.cases") if section == "portraits" else None
            if isinstance(cases, dict) and name not in _known(values):
                yield path, _no_such_case(name, _known(values))
            elif given and name not in given:
                continue
            elif drawn and swept is not None and name not in swept:
                yield path, f"the case is not swept; add it to sweeps.{sweep}.cases or leave its list empty"
            ends = _pair(values, f"sweeps.{sweep}.first", f"sweeps.{sweep}.last")
            for position, value in enumerate(drawn):
                entry = (*path, f"[{position}]")
                if ends and ends[0] < ends[1] and not ends[0] <= value <= ends[1]:
                    yield (
                        entry,
                        f"{value} is outside the swept range, {ends[0]} to {ends[1]}; "
                        f"take it out or widen sweeps.{sweep}",
                    )
                if value in drawn[:position]:
                    yield entry, f"{value} is listed twice; take one out"


def _known(values: dict[str, Any]) -> dict[str, Any]:
    return values["cases"] | (value_at(values, "oscillators") or {})


def _no_such_case(name: str, cases: dict[str, Any]) -> str:
    near = difflib.get_close_matches(name[:_LONGEST_NAME], list(cases), 1)
    known = listed([dotted((known,)) for known in cases][:_MOST_NAMED])
    advice = f"did you mean {dotted((near[0],))}?" if near else f"cases: {known or 'none'}"
    return f"{shown(name)} is no case ({advice})"


_RULES = (_ranges, _temperatures, _torque, _oscillators, _cases, _portraits, _maps, _studies)
