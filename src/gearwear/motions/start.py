"""The state that a motion starts from."""

from __future__ import annotations

from typing import Any

from gearwear.integrate.strobe import visited
from gearwear.oscillator.excitation import Excitation
from gearwear.oscillator.oscillator import Oscillator


def rest_state(source: Excitation, oscillator: Oscillator, settings: dict[str, Any]) -> tuple[float, ...]:
    """Return the state at mesh phase 0 after the start that the configuration gives; bearings start without load.

    `settings["start"]["at"]`: `pair_entry`, the state given is that at mesh phase 0; `stiffest_mesh`, it is given where
    the first harmonic of the stiffness is largest, the origin of time of Kahraman and Singh (1990), and the oscillator
    is run from there to the next entry of a pair.
    """
    start = settings["start"]
    state = (start["displacement"], start["velocity"])
    if start["at"] == "pair_entry" or source.stiffest_phase == 0:
        return state
    before = oscillator.seen_from(source.stiffest_phase)
    run = visited(before, state, [1.0 - source.stiffest_phase], 1, tolerance=settings["tolerance"])
    return tuple(run[0, 0].tolist())
