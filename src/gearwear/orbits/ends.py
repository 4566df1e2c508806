"""Why a branch ends, and how it is seen that it does."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from gearwear.codes.branch_codes import CLOSED, HALVED, NODE_LIMIT, RANGE_END, STOPPED
from gearwear.orbits.curve import Point
from gearwear.orbits.newton import Orbit

_NEAR = 0.1  # of a step, from the chord of the step


class End(NamedTuple):
    """End of a branch: a code, the last good orbit, and both in words."""

    reason: int
    orbit: Orbit
    words: str


def at_bound(orbit: Orbit) -> End:
    """Return the end at a bound of the parameter."""
    return End(RANGE_END, orbit, f"the range of the parameter ends at {orbit.value:.10g}")


def closed(orbit: Orbit) -> End:
    """Return the end of a branch that comes back to where it began."""
    return End(CLOSED, orbit, f"the branch closes at {orbit.value:.10g}")


def halved(orbit: Orbit) -> End:
    """Return the end at an orbit of half the period."""
    return End(HALVED, orbit, f"the orbit has half the period at {orbit.value:.10g}")


def stopped(orbit: Orbit, trouble: str) -> End:
    """Return the end where even the smallest step fails."""
    x, v = orbit.section[0]
    return End(STOPPED, orbit, f"stopped: {trouble}; last good point {orbit.value:.10g}, state ({x:.10g}, {v:.10g})")


def at_limit(orbit: Orbit, most: int) -> End:
    """Return the end where the nodes are used up."""
    x, v = orbit.section[0]
    words = f"{most} nodes are used up; last good point {orbit.value:.10g}, state ({x:.10g}, {v:.10g})"
    return End(NODE_LIMIT, orbit, words)


def gap(orbit: Orbit) -> float:
    """Return the distance of the states half a period apart; infinite for an odd period."""
    return float(np.linalg.norm(_gap(orbit))) if orbit.period % 2 == 0 else np.inf


def signed_gap(reference: Orbit) -> Callable[[Orbit], float]:
    """Return the function that measures the step of an orbit over half its period along that of a reference."""
    along = _gap(reference)
    return lambda orbit: float(_gap(orbit) @ along)


def passes_half_period(here: Point, reached: Point) -> bool:
    """Whether the step over half the period turns round: the branch goes through an orbit of half the period.

    Beyond it come the same orbits again, seen half a period later.
    """
    if here.orbit.period % 2:
        return False
    size = gap(here.orbit) + gap(reached.orbit)
    near = size <= 4 * np.linalg.norm(reached.place - here.place)
    return bool(near and signed_gap(here.orbit)(reached.orbit) < 0)


def passes_through(here: Point, reached: Point, start: Point) -> bool:
    """Whether a step passes the start of the branch, seen in any of its mesh periods."""
    chord = reached.place - here.place
    length = np.linalg.norm(chord)
    for state in start.orbit.section:
        from_here = np.append(state, start.place[2]) - here.place
        along = from_here @ chord / length
        if 0 <= along <= length and np.linalg.norm(from_here - along / length * chord) <= _NEAR * length:
            return True
    return False


def _gap(orbit: Orbit) -> np.ndarray:
    return orbit.section[orbit.period // 2] - orbit.section[0]
