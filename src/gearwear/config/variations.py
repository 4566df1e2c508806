"""What the model sensitivity varies: every choice of the model in turn, and the parameters that the paper leaves open.

Plain values only: the members are made anew at every start of the workflow.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Annotated, Any, Literal, NamedTuple, get_args, get_origin

from gearwear.config.parameters import ENDS, OPTION, PARAMETER, PLACES
from gearwear.config.slices import STAGES, readers
from gearwear.config.study import Configuration
from gearwear.config.text import figure
from gearwear.config.tree import nested, value_at
from gearwear.config.types import keys

STUDY = "sensitivity"

# How a motion is computed, and a model without the branches by which a doubling is measured.
_PASSED_OVER = ("settling", "dynamics.model")
# Values of a choice beside its words.
_MORE = {"dynamics.harmonics": (1, 3)}
# What a choice takes along: without it the configuration is refused.
_COMPANIONS = {("transmission_error.mode", "no_load"): {"dynamics.ste_amplitude": "harmonic"}}


class Variation(NamedTuple):
    """One member: a key with another value, and the companions without which that value would mean nothing.

    name : of the member; group : OPTION or PARAMETER; key : dotted; value, usual : as config.yaml writes them;
    companions : "key value" of each, empty for none; overrides : all of it, nested as in the configuration.
    """

    name: str
    group: str
    key: str
    value: str
    usual: str
    companions: str
    overrides: dict[str, Any]


def variations(config: dict[str, Any]) -> list[Variation]:
    """Return every variation: the options in the order of the models, then both ends of every parameter.

    A choice enters if a stage behind the measures reads it, unless it decides only how a motion is computed (section
    `settling`) or takes the measures away (`dynamics.model`). An end that is the value of the study makes no member.

    Parameters
    ----------
    config : the checked configuration of the study.
    """
    found = []
    for key, values in _choices():
        usual = value_at(config, key)
        for value in values:
            if value != usual or type(value) is not type(usual):
                companions = _COMPANIONS.get((key, value), {})
                found.append(_variation(config, OPTION, key, value, companions, f"{key}_{_shown(value)}"))
    for name, key in PLACES.items():
        for end in ENDS:
            value = config["sensitivity"][name][end]
            if value != value_at(config, key):
                found.append(_variation(config, PARAMETER, key, value, {}, f"{name}_{end}"))
    return found


def _choices() -> Iterator[tuple[str, tuple[Any, ...]]]:
    for path, field in keys(Configuration):
        key = ".".join(path)
        values = (*_words(field.annotation), *_MORE.get(key, ()))
        passed_over = path[0] in _PASSED_OVER or key in _PASSED_OVER
        if values and not passed_over and "<" not in key and readers(path, {"measures": STAGES["measures"]}):
            yield key, values


def _words(annotation: Any) -> tuple[Any, ...]:
    """Return the values that a type lists: those of a Literal, alone or beside other types, and both of a flag."""
    if annotation is bool:
        return (False, True)
    if get_origin(annotation) is Literal:
        return get_args(annotation)
    if get_origin(annotation) is Annotated:
        return _words(get_args(annotation)[0])
    return tuple(word for part in get_args(annotation) for word in _words(part))


def _variation(
    config: dict[str, Any], group: str, key: str, value: Any, companions: dict[str, Any], name: str
) -> Variation:
    needed = {other: word for other, word in companions.items() if value_at(config, other) != word}
    taken = ", ".join(f"{other} {_shown(word)}" for other, word in needed.items())
    member = re.sub(r"[^a-z0-9]+", "_", name.lower())
    return Variation(
        member, group, key, _shown(value), _shown(value_at(config, key)), taken, nested({key: value} | needed)
    )


def _shown(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    return value if isinstance(value, str) else figure(value)
