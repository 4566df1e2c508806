"""How well a candidate agrees with the claims: the verdict of the scorecard, and how far a claim is from agreeing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from gearwear.claims import rules
from gearwear.claims.events import find_event
from gearwear.claims.properties import PROPERTIES
from gearwear.claims.scorecard import cases_of
from gearwear.claims.study import Study, Undecided
from gearwear.claims.sweeps import Sweep, class_code
from gearwear.claims.windows import points_of_window

HEADLINE = "chaos-earlier-with"
STATES = "states"  # subject of the claims about wear and static transmission error
_OF_STATES = ("wear-", "ste-")  # how their names begin
_SOFTNESS = 0.05  # of the swept variable: distance beyond the tolerance over which the merit of an event falls
_BONUS = 0.1  # merit beyond agreement, so that of two that agree the safer one is better


def judged(claims: Sequence[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
    """Return the claims that a search judges: windows, events, the headline, and those about states."""
    return [
        claim for claim in claims if claim["kind"] != "qualitative" or claim["id"] == HEADLINE or _is_of_states(claim)
    ]


def subject(claim: Mapping[str, Any]) -> str:
    """Return what a claim is about: the swept quantity, or the states of the flanks."""
    return STATES if _is_of_states(claim) else claim.get("sweep", "mesh_frequency")


def agreements(
    claims: Sequence[Mapping[str, Any]], sweeps: Mapping[tuple[str, str], Sweep], states: Study
) -> tuple[np.ndarray, np.ndarray]:
    """Return for every claim whether it agrees, and its merit.

    The merit is 1 where a claim just agrees, up to 0.1 more the safer it is, and falls towards 0 with the share of the
    window that is missing, or exponentially with the distance of the event beyond its tolerance.

    Parameters
    ----------
    claims : of `judged`.
    sweeps : by case and swept quantity.
    states : what the claims about states read of the cases `without` and `with`.

    Returns
    -------
    agrees : (claims,) bool
    merit : (claims,)
    """
    found = [_judge(claim, sweeps, states) for claim in claims]
    return np.array([agrees for agrees, _ in found], dtype=bool), np.array([merit for _, merit in found])


def _is_of_states(claim: Mapping[str, Any]) -> bool:
    return claim["kind"] == "qualitative" and claim["id"].startswith(_OF_STATES)


def _judge(claim: Mapping[str, Any], sweeps: Mapping[tuple[str, str], Sweep], states: Study) -> tuple[bool, float]:
    if _is_of_states(claim):
        try:
            holds = bool(PROPERTIES[claim["id"]](states)[0])
        except Undecided:
            holds = False
        return holds, float(holds)
    if claim["kind"] == "qualitative":
        hot, cold = (_location(sweeps[case, "mesh_frequency"], "chaos onset") for case in ("with", "without"))
        earlier = hot is not None and cold is not None and hot < cold
        return earlier, float(earlier)
    if claim["kind"] == "numeric":
        return _near(_location(sweeps[claim["case"], claim["sweep"]], claim["event"]), claim["expected"])
    found = [_share(sweeps[case, claim["sweep"]], claim["range"], claim["class"]) for case in cases_of(claim)]
    share = min(found)
    need = rules.WINDOW_SHARE
    return share >= need, share / need if share < need else 1 + _BONUS * (share - need) / (1 - need)


def _near(location: float | None, expected: float) -> tuple[bool, float]:
    if location is None:
        return False, 0.0
    beyond = abs(location - expected) - rules.EVENT_TOLERANCE
    if beyond <= rules.GRID_TOLERANCE:
        return True, 1 + _BONUS * max(0.0, -beyond / rules.EVENT_TOLERANCE)
    return False, float(np.exp(-beyond / _SOFTNESS))


def _location(sweep: Sweep, event: str) -> float | None:
    try:
        return find_event(sweep, event).location
    except Undecided:
        return None


def _share(sweep: Sweep, window: Sequence[float], names: Sequence[str]) -> float:
    points = sweep.motion_class[points_of_window(sweep.swept, *window)]
    return float(np.isin(points, [class_code(name) for name in names]).mean())
