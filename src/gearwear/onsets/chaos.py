"""The onset of chaos along a sweep, between its points."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from gearwear.claims.rules import CHAOS_RUN
from gearwear.codes.motion_class import CHAOTIC, NOT_CONVERGED
from gearwear.codes.onset_codes import ABSENT, BELOW_RANGE, MET
from gearwear.motions.sequence import first_run
from gearwear.onsets.doublings import Onset

Classify = Callable[[np.ndarray, int, int], np.ndarray]


def onset_of_chaos(values: np.ndarray, motion_class: np.ndarray, classify: Classify, refinement: int) -> Onset:
    """Return where chaos begins in a sweep.

    It begins in the step below the first run of at least `rules.CHAOS_RUN` chaotic points, points that did not
    converge left out: at the lowest value of a finer grid in that step from which on all motions are chaotic.

    Parameters
    ----------
    values, motion_class : (points,) of the sweep, ascending.
    classify : (values, below, above) -> motion classes at ascending values between the points of these indices.
    refinement : finer steps in the step.
    """
    run = first_run(motion_class, CHAOTIC, CHAOS_RUN)
    if run is None:
        return Onset(np.nan, np.nan, ABSENT, np.nan, f"no {CHAOS_RUN} successive points of the sweep are chaotic")
    onset, before = float(values[run[0]]), np.flatnonzero(motion_class[: run[0]] != NOT_CONVERGED)
    if not before.size:
        return Onset(onset, onset, BELOW_RANGE, np.nan, "the sweep is chaotic from its first point on")
    below, above = int(before[-1]), run[0]
    step = (onset - values[below]) / refinement
    finer = values[below] + step * np.arange(1, refinement)
    for value, code in zip(finer[::-1], classify(finer, below, above)[::-1], strict=True):
        if code == CHAOTIC:
            onset = float(value)
        elif code != NOT_CONVERGED:
            break
    return Onset(onset, onset, MET, float(step), f"chaotic in {run[1] - run[0] + 1} points of the sweep from there on")
