"""The events on the route to chaos along one sweep of the mesh frequency, and the same computed in other ways."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import xarray as xr

from gearwear.codes import onset_codes
from gearwear.integrate.status import GROWTH
from gearwear.integrate.strobe import AUTOMATIC, GENERAL
from gearwear.motions.settling import Settling
from gearwear.motions.sweep import DOWN, RESTART, settle_by_continuation, settle_from_rest
from gearwear.onsets.chaos import Classify, onset_of_chaos
from gearwear.onsets.doublings import Doubling, Onset, doublings, onset_of_doubling
from gearwear.orbits.locating import doubling_near
from gearwear.orbits.return_map import COARSEST, return_maps
from gearwear.oscillator.excitation import Excitation, SweptOscillator

SWEEP = "mesh_frequency"
_MARGIN = 0.2  # mesh frequency over natural frequency, beyond the events of a sweep: how far others are looked for


class State(NamedTuple):
    """One state of the pair: its excitation, the sections `dynamics` and `settling`, and its branches."""

    source: Excitation
    dynamics: dict[str, Any]
    settling: Settling
    branches: xr.Dataset

    @property
    def swept(self) -> SweptOscillator:
        """The oscillator by the mesh frequency."""
        return SweptOscillator(self.source, SWEEP, self.dynamics)


def classes_from_rest(
    state: State, values: np.ndarray, tolerance: float | None = None, backend: str = AUTOMATIC
) -> np.ndarray:
    """Return the motion classes at mesh frequencies, every motion from rest.

    Parameters
    ----------
    values : (points,) mesh frequencies over the natural one.
    tolerance : of the integrator; that of `dynamics` if None.
    backend : as in strobe.strobe.
    """
    oscillators = [state.swept.at(value) for value in values]
    motions = settle_from_rest(
        state.source,
        oscillators,
        state.dynamics,
        state.settling,
        tolerance=tolerance,
        detail=GROWTH,
        backend=backend,
    )
    return np.array([motion.motion_class for motion in motions], dtype=int)


def classes_by_continuation(state: State, values: np.ndarray, begin: tuple[float, float], direction: str) -> np.ndarray:
    """Return the same with continuation; the first motion in the direction, up or down, starts from `begin`."""
    oscillators = [state.swept.at(value) for value in values]
    motions = settle_by_continuation(
        oscillators, lambda _: begin, state.settling, state.dynamics["tolerance"], direction
    )
    return np.array([motion.motion_class for motion in motions], dtype=int)


def along(state: State, sweep: xr.Dataset, order: str, refinement: int) -> list[Onset]:
    """Return the events of onset_codes.EVENTS along a sweep.

    Parameters
    ----------
    sweep : as sweep.sweep returns it, of this state.
    order : of the sweep, one of onset_codes.ORDERS.
    refinement : finer steps in the step of the sweep in which chaos begins.
    """
    sweep = sweep.sortby(SWEEP)
    ends = np.stack([sweep[f"section_{name}"].values[:, -1] for name in ("displacement", "velocity")], axis=1)

    def classify(values: Any, below: int, above: int) -> Any:
        if order == RESTART:
            return classes_from_rest(state, values)
        begin = tuple(ends[above if order == DOWN else below].tolist())
        return classes_by_continuation(state, values, begin, order)

    return _events(state, sweep[SWEEP].values, sweep["motion_class"].values, classify, refinement)


def varied(state: State, sweep: xr.Dataset, events: list[Onset], refinement: int) -> dict[str, list[Onset]]:
    """Return the events computed in other ways from rest: onset_codes.VARIANTS but the orders.

    The sweeps are those of the points given within 0.2 of its events. A doubling by another integrator is located on
    the branch anew.

    Parameters
    ----------
    sweep : the sweep from rest.
    events : those along it.
    """
    values, settling, dynamics = np.sort(sweep[SWEEP].values), state.settling, state.dynamics
    known = [event.seen for event in events if np.isfinite(event.seen)]
    if known:
        values = values[(values >= min(known) - _MARGIN) & (values <= max(known) + _MARGIN)]
    longer = settling._replace(
        transient_periods=2 * settling.transient_periods,
        longest_transient=2 * settling.longest_transient,
        sampled_periods=2 * settling.sampled_periods,
    )
    at = "pair_entry" if dynamics["start"]["at"] == "stiffest_mesh" else "stiffest_mesh"
    elsewhere = {**dynamics, "start": {**dynamics["start"], "at": at}}
    finer = np.union1d(values, (values[1:] + values[:-1]) / 2)
    found = {
        onset_codes.OTHER_START: _swept(state._replace(dynamics=elsewhere), values, refinement),
        onset_codes.LONGER: _swept(state._replace(settling=longer), values, refinement),
        onset_codes.FINER: _swept(state, finer, refinement),
    }
    tolerance = min(dynamics["tolerance"], COARSEST)
    for name, accuracy in ((onset_codes.GENERAL, tolerance), (onset_codes.GENERAL_HALVED, tolerance / 2)):
        found[name] = _swept(state, values, refinement, accuracy, GENERAL)
    return found


def _swept(
    state: State, values: np.ndarray, refinement: int, tolerance: float | None = None, backend: str = AUTOMATIC
) -> list[Onset]:
    def classify(chosen: Any, below: int = 0, above: int = 0) -> Any:
        return classes_from_rest(state, chosen, tolerance, backend)

    events = _events(state, values, classify(values), classify, refinement)
    if tolerance is None:
        return events
    maps = return_maps(state.swept.at, tolerance, backend)
    known = {one.value: one for period in onset_codes.DOUBLED for one in doublings(state.branches, SWEEP, period)}
    return [_relocated(event, known.get(event.seen), maps) for event in events]


def _relocated(event: Onset, doubling: Doubling | None, maps: Any) -> Onset:
    """Return an event that is a doubling with the place where these maps have it; others as they are."""
    if doubling is None:
        return event
    orbit = doubling_near(maps, doubling.value, np.array(doubling.state), doubling.period)
    if orbit is None:
        return Onset(np.nan, np.nan, onset_codes.ABSENT, np.nan, "the doubling is not found with this integrator")
    return event._replace(value=orbit.value, seen=orbit.value)


def _events(
    state: State, values: np.ndarray, motion_class: np.ndarray, classify: Classify, refinement: int
) -> list[Onset]:
    events: list[Onset] = []
    for period in onset_codes.DOUBLED:
        above = events[-1].value if events and np.isfinite(events[-1].value) else -np.inf
        found = doublings(state.branches, SWEEP, period)
        events.append(onset_of_doubling(found, values, motion_class, period, above))
    return [*events, onset_of_chaos(values, motion_class, classify, refinement)]
