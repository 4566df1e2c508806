"""Members of studies: the same configuration with a few keys overridden, each computed in a folder of its own."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gearwear.config import ensemble, variations
from gearwear.config.check import check, refused
from gearwear.config.grids import combinations, nested, slug
from gearwear.config.rules import Problem
from gearwear.config.wording import dotted
from gearwear.errors import ConfigError

Overrides = Mapping[str, Any]


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
    for study, table in _studies(config).items():
        for member, overrides in table.items():
            root = f"studies/{study}/{member}/"
            if "studies" in overrides:
                problems.append((root, (("studies",), "a member has no studies of its own; take them out")))
                continue
            try:
                found[root] = check(merged({**config, "studies": {}}, overrides), config)
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
        check(merged({**config, "studies": {}}, overrides), config)
    except ConfigError as error:
        return "; ".join(f"{dotted(path)}: {text}" for _, (path, text) in error.problems)
    return ""


def merged(base: Overrides, overrides: Overrides) -> dict[str, Any]:
    """Return `base` with `overrides` laid over it: groups of keys are merged, all else is replaced."""
    result = dict(base)
    for key, value in overrides.items():
        below = result.get(key)
        if isinstance(below, Mapping) and isinstance(value, Mapping):
            value = merged(below, value)
        result[key] = value
    return result


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
