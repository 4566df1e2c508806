"""Members of studies: the same configuration with a few keys overridden, each computed in a folder of its own."""

from __future__ import annotations

import itertools
import re
from collections.abc import Mapping
from typing import Any, NamedTuple

from gearwear.config import ensemble, variations
from gearwear.config.check import check, refused
from gearwear.config.study import Configuration
from gearwear.config.text import Problem, dotted
from gearwear.config.tree import merged, nested
from gearwear.errors import ConfigError

Overrides = Mapping[str, Any]
_LONGEST_NAME = 60


def members(config: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """Return the checked configuration of every member, by its folder below `results/`.

    Parameters
    ----------
    config : the checked configuration of the study itself, whose folder is "".

    Returns
    -------
    folder, "" or "studies/STUDY/MEMBER/" -> checked configuration; that of a member has no studies. An option that the
    rest of the configuration does not allow makes no member of the study of the sensitivity, and an impossible
    combination none of a grid; see `refusal`.

    Raises
    ------
    ConfigError : with one line for every problem of any member, naming the member and the key.
    """
    found, problems = {"": config}, list[tuple[str, Problem]]()
    sections = dict(Configuration.model_validate(config))
    for study, table in _studies(config).items():
        for member, overrides in table.items():
            root = f"studies/{study}/{member}/"
            if "studies" in overrides:
                problems.append((root, (("studies",), "a member has no studies of its own; take them out")))
                continue
            try:
                found[root] = check(_overridden(config, overrides, sections))
            except ConfigError as error:
                if study == variations.STUDY or config["studies"].get(study, {}).get("grid"):
                    continue
                problems += [(root, problem) for _, problem in error.problems]
    if problems:
        raise refused(problems)
    return found


def refusal(config: dict[str, Any], overrides: Overrides) -> str:
    """Return why the configuration with these overrides is refused, one problem after another; "" if it is not."""
    try:
        check(_overridden(config, overrides, {}))
    except ConfigError as error:
        return "; ".join(f"{dotted(path)}: {text}" for _, (path, text) in error.problems)
    return ""


def _overridden(config: dict[str, Any], overrides: Overrides, sections: Mapping[str, Any]) -> dict[str, Any]:
    """Return the configuration of a member; `sections` are validated already and serve where nothing is overridden."""
    return merged(
        config | {name: sections[name] for name in sections.keys() - overrides.keys()} | {"studies": {}}, overrides
    )


class Combination(NamedTuple):
    """One member of a grid: its name, and the value of every key of the grid, in their order."""

    name: str
    values: dict[str, Any]


def combinations(grid: dict[str, list[Any]]) -> list[Combination]:
    """Return every combination, the last key changing fastest.

    A name is made of the last part of every key and its value; where such names are too long, or not all different,
    the combinations are numbered.

    Parameters
    ----------
    grid : values of every dotted key.
    """
    if not grid:
        return []
    rows = [dict(zip(grid, row, strict=True)) for row in itertools.product(*grid.values())]
    names = ["__".join(f"{key.rsplit('.', 1)[-1]}_{slug(value)}" for key, value in row.items()) for row in rows]
    if len(set(names)) < len(names) or any(len(name) > _LONGEST_NAME for name in names):
        names = [f"member_{number:04d}" for number in range(1, len(rows) + 1)]
    return [Combination(name, row) for name, row in zip(names, rows, strict=True)]


def slug(value: Any) -> str:
    """Return a value as part of a name: small letters, digits and underscores."""
    text = f"{value:g}" if isinstance(value, int | float) and not isinstance(value, bool) else str(value)
    return re.sub(r"[^a-z0-9]+", "_", text.lower().replace("-", "m").replace("+", ""))


def temperature_root(value: float) -> str:
    """Return the folder of the member that has a bulk temperature, degC, of the map over it."""
    return f"studies/temperature/t{slug(value)}/"


def overrides_of(study: dict[str, Any], values: dict[str, Any]) -> dict[str, Any]:
    """Return the keys in which a combination of the grid of a study differs from the configuration.

    Parameters
    ----------
    study : an entry of the section `studies`.
    values : of the keys of its grid.
    """
    return merged(study["settings"], nested(values))


def _studies(config: dict[str, Any]) -> dict[str, Mapping[str, Overrides]]:
    maps = config["maps"]
    temperatures: dict[str, Overrides] = {
        temperature_root(value).split("/")[2]: {"cases": {maps["case"]: {"bulk_temperature": value}}}
        for value in maps["temperature"]
    }
    declared: dict[str, Mapping[str, Overrides]] = {
        name: {member: merged(study["settings"], overrides) for member, overrides in study["members"].items()}
        | {one.name: overrides_of(study, one.values) for one in combinations(study["grid"])}
        for name, study in config["studies"].items()
    }
    made: dict[str, Mapping[str, Overrides]] = {
        "temperature": temperatures,
        ensemble.STUDY: ensemble.overrides(config),
        variations.STUDY: {one.name: one.overrides for one in variations.variations(config)},
    }
    return made | declared
