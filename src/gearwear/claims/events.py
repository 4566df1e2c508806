"""Events along a sweep: changes of period, onset of chaos, amplitude jump."""

import re
from dataclasses import dataclass

import numpy as np

from gearwear.claims import rules
from gearwear.claims.study import Study, Undecided
from gearwear.claims.sweeps import Sweep, class_code, read_sweep
from gearwear.codes.motion_class import CHAOTIC, NOT_CONVERGED
from gearwear.errors import BadFile
from gearwear.motions.sequence import changes, first_run


@dataclass(frozen=True)
class Event:
    """Where a sweep shows an event (None: nowhere) and the numbers it was found by."""

    location: float | None
    found: str


def find_event(sweep: Sweep, event: str) -> Event:
    """Return where `sweep` shows `event`: "P1->P2" or the like, "chaos onset" or "amplitude jump".

    Raises
    ------
    Undecided
        If no point of the sweep, or of the range of the amplitude jump, allows a judgement.
    BadFile
        If the event is of none of these kinds.
    """
    change = re.fullmatch(r"(P\d+)->(P\d+)", event)
    if change:
        return change_of_period(sweep, class_code(change[1]), class_code(change[2]))
    if event == "chaos onset":
        return onset_of_chaos(sweep)
    if event == "amplitude jump":
        return amplitude_jump(sweep)
    raise BadFile(f"event {event!r} is unknown; use 'P1->P2' or the like, 'chaos onset', 'amplitude jump'")


def change_of_period(sweep: Sweep, before: int, after: int) -> Event:
    """Return the midpoint between the first run of class `before` that a run of class `after` follows.

    Points that did not converge are left out first, then runs shorter than `rules.PERIOD_RUN` points.
    """
    swept, motion_class = _classified(sweep)
    found = changes(motion_class, before, after, rules.PERIOD_RUN)
    if not found:
        return Event(None, _absent(sweep))
    low, high = swept[list(found[0])]
    return Event(float((low + high) / 2), f"between {low:.4f} and {high:.4f}")


def onset_of_chaos(sweep: Sweep) -> Event:
    """Return the start of the first run of at least `rules.CHAOS_RUN` chaotic points.

    Points that did not converge are left out first.
    """
    swept, motion_class = _classified(sweep)
    run = first_run(motion_class, CHAOTIC, rules.CHAOS_RUN)
    if run is None:
        return Event(None, _absent(sweep))
    return Event(float(swept[run[0]]), f"run of {run[1] - run[0] + 1} points from {swept[run[0]]:.4f}")


def amplitude_jump(sweep: Sweep) -> Event:
    """Return the midpoint of the two neighbouring points between which the section changes most.

    The section lies in the phase plane: the change is the largest of those of its least and greatest displacement
    and velocity, all over the half clearance (and the natural frequency). Points without a section are left out. A
    change of at most `rules.AMPLITUDE_JUMP_LEAST` is no event.
    """
    low, high = rules.AMPLITUDE_JUMP_RANGE
    sweep.require_span(low, high)
    tolerance = rules.GRID_TOLERANCE
    inside = (sweep.swept >= low - tolerance) & (sweep.swept <= high + tolerance)
    inside &= np.isfinite(sweep.extent).all(axis=1)
    swept = sweep.swept[inside]
    if swept.size < 2:
        raise Undecided(f"fewer than two points with a section between {low} and {high}")
    change = np.abs(np.diff(sweep.extent[inside], axis=0)).max(axis=1)
    place = int(np.argmax(change))
    found = f"largest change {change[place]:.3f} half clearances between {swept[place]:.4f} and "
    found += f"{swept[place + 1]:.4f}"
    if change[place] <= rules.AMPLITUDE_JUMP_LEAST:
        return Event(None, f"no event; {found}")
    return Event(float((swept[place] + swept[place + 1]) / 2), found)


def judge_event(sweep: Sweep, event: str, expected: float) -> tuple[bool, str]:
    """Return whether `event` lies within `rules.EVENT_TOLERANCE` of `expected`, and where it was found."""
    sweep.require_span(expected, expected)
    seen = find_event(sweep, event)
    if seen.location is None:
        return False, seen.found
    distance = abs(seen.location - expected)
    return distance <= rules.EVENT_TOLERANCE + rules.GRID_TOLERANCE, f"{seen.location:.4f} ({seen.found})"


def chaos_earlier_with_temperature_and_wear(study: Study) -> tuple[bool | None, str]:
    """Return whether chaos starts at a lower mesh frequency in case ``with`` than in case ``without``."""
    onsets = {case: onset_of_chaos(read_sweep(study, case, "mesh_frequency")).location for case in ("with", "without")}
    found = ", ".join(f"{case} {'no onset' if at is None else f'{at:.4f}'}" for case, at in onsets.items())
    hot, cold = onsets["with"], onsets["without"]
    return None if hot is None or cold is None else hot < cold, found


def _classified(sweep: Sweep) -> tuple[np.ndarray, np.ndarray]:
    converged = sweep.motion_class != NOT_CONVERGED
    if not converged.any():
        raise Undecided("no point of the sweep converged")
    return sweep.swept[converged], sweep.motion_class[converged]


def _absent(sweep: Sweep) -> str:
    lost = int(np.count_nonzero(sweep.motion_class == NOT_CONVERGED))
    return f"no event; {lost} of {sweep.swept.size} points not converged"
