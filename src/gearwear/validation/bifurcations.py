"""Folds and period doublings of oscillators."""

from __future__ import annotations

import json
from functools import lru_cache
from typing import Any

from gearwear.codes.branch_codes import FOLD, PERIOD_DOUBLING
from gearwear.orbits.branches import Branch, Seed, explore
from gearwear.orbits.continuation import Limits, Node
from gearwear.orbits.return_map import return_maps
from gearwear.validation import second_method
from gearwear.validation.oscillator import oscillator_of

_KINDS = {"fold": (FOLD, second_method.FOLD), "doubling": (PERIOD_DOUBLING, second_method.DOUBLING)}


@lru_cache
def _branches(given: str) -> list[Branch]:
    system, first, last, frequency, state, largest_period = json.loads(given)
    family = return_maps(lambda value: oscillator_of(value, **system))
    return explore(family, [Seed(frequency, tuple(state), 1)], Limits(first, last), largest_period)


def _points(route: dict[str, Any], kind: str, period: int) -> list[Node]:
    names = ("system", "first", "last", "frequency", "state", "largest_period")
    found = _branches(json.dumps([route[name] for name in names]))
    nodes = [node for branch in found if branch.period == period for node in branch.nodes]
    return sorted((node for node in nodes if node.special == _KINDS[kind][0]), key=lambda node: node.orbit.value)


def special_points(route: dict[str, Any], kind: str, period: int) -> list[float]:
    """Return the frequencies of the folds or doublings of the orbits of a period.

    Parameters
    ----------
    route : system; first, last frequency; frequency and state of an orbit of period 1; largest_period.
    """
    return [node.orbit.value for node in _points(route, kind, period)]


def less_second_method(route: dict[str, Any], kind: str, period: int) -> list[float]:
    """Return the same less what the eighth-order integrator with events finds, started 1e-5 away."""
    return [
        orbit.value
        - second_method.special_frequency(
            route["system"], period, _KINDS[kind][1], orbit.value + 1e-5, orbit.section[0] + 1e-5
        )
        for orbit in (node.orbit for node in _points(route, kind, period))
    ]


QUANTITIES = {"special_points": special_points, "less_second_method": less_second_method}
