"""Basins of attraction on a slice of initial states, and the attractors with their shares."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearwear.codes.motion_class import CHAOTIC, LARGEST_PERIOD, NOT_CONVERGED
from gearwear.motions.destinations import destinations, share_escaping
from gearwear.motions.matching import overlapping_clouds, same_orbits
from gearwear.motions.settling import Attractor, Settling, settle_many
from gearwear.oscillator.oscillator import Oscillator

UNDECIDED = -1
SAME_ATTRACTOR = 1e-5  # of the half backlash
_WATCHED = 16  # motions of a chaotic attractor that are followed to the end of the longest transient


class Basins(NamedTuple):
    """Attractors and where they are reached from.

    attractors : by class, those of one class by their largest section displacement, the undecided class last
    escaped : (attractors,) of the first sixteen chaotic motions, the share that had become periodic after the longest
        transient; 0 for other attractors
    destination : (states,) place in that list of the attractor that a state leads to, or UNDECIDED
    """

    attractors: list[Attractor]
    escaped: np.ndarray
    destination: np.ndarray

    @property
    def shares(self) -> np.ndarray:
        """(attractors,) part of the states that lead to each."""
        return np.array([(self.destination == place).mean() for place in range(len(self.attractors))])


def cell_centres(first: float, last: float, count: int) -> np.ndarray:
    """Return the centres of equal cells between two bounds, (count,)."""
    return first + (last - first) * (np.arange(count) + 0.5) / count


def basins(oscillator: Oscillator, states: np.ndarray, settling: Settling, tolerance: float = 1e-10) -> Basins:
    """Return the attractors that the states lead to, and which state leads to which.

    Motions of one period are the same attractor if their sections agree within 1e-5, whichever mesh period they begin
    with; chaotic ones if the boxes around their sections overlap, and so for quasi-periodic ones. Every attractor is
    then settled from one of its own states, for the evidence, and compared with the others once more: two slow
    approaches to one orbit are further apart than the orbits they end on.

    Parameters
    ----------
    states : (states, 2) displacement and velocity at mesh phase 0

    Raises
    ------
    ValueError
        For states or settings outside their range.
    """
    ends = destinations(oscillator, states, settling, tolerance)
    index = _grouped(*ends)
    firsts = [int(np.flatnonzero(index == group)[0]) for group in range(index.max() + 1)]
    if not firsts:
        return Basins([], np.zeros(0), index)
    motions = settle_many([oscillator] * len(firsts), ends.sections[firsts, -1], settling, tolerance)
    sections = np.array([np.stack([motion.displacement, motion.velocity], axis=-1) for motion in motions])
    classes = [motion.motion_class or ends.motion_class[first] for motion, first in zip(motions, firsts, strict=True)]
    again = _grouped(np.array(classes), sections, sections.min(axis=1), sections.max(axis=1))
    known = [motions[int(np.flatnonzero(again == group)[0])] for group in range(again.max() + 1)]
    order = sorted(range(len(known)), key=lambda place: _rank(known[place]))
    known = [known[place] for place in order]
    index = np.where(index >= 0, np.argsort(order)[again[index]], UNDECIDED)
    escaped = np.zeros(len(known))
    for place, motion in enumerate(known):
        if motion.motion_class == CHAOTIC:
            watched = ends.sections[index == place, -1][:_WATCHED]
            escaped[place] = share_escaping(oscillator, watched, settling, tolerance)
    return Basins(known, escaped, index)


def _grouped(classes: np.ndarray, sections: np.ndarray, low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """Return labels, (motions,), equal for motions on the same attractor, UNDECIDED where the class is not known."""
    labels = np.full(len(classes), UNDECIDED)
    for code in np.unique(classes[classes != NOT_CONVERGED]):
        own = np.flatnonzero(classes == code)
        if code <= LARGEST_PERIOD:
            groups = same_orbits(sections[own, -code:], SAME_ATTRACTOR)
        else:
            groups = overlapping_clouds(low[own], high[own])
        labels[own] = labels.max() + 1 + groups
    return labels


def _rank(motion: Attractor) -> tuple[bool, int, float]:
    return motion.motion_class == NOT_CONVERGED, motion.motion_class, -float(motion.displacement.max())
