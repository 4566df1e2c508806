"""Which of many settled motions are the same attractor."""

from __future__ import annotations

import numpy as np


def same_orbits(sections: np.ndarray, tolerance: float) -> np.ndarray:
    """Return labels, (motions,), equal for motions of one period that repeat the same orbit.

    Two orbits are the same if all their states agree within the tolerance, whichever mesh period either begins with.
    Labels count from 0 in the order in which the orbits appear; each is compared with the first of its label.

    Parameters
    ----------
    sections : (motions, period, size) states at mesh phase 0, one a mesh period.
    """
    labels = np.full(len(sections), -1)
    label = 0
    while (left := np.flatnonzero(labels < 0)).size:
        first = sections[left[0]]
        turns = (np.roll(first, turn, axis=0) for turn in range(len(first)))
        apart = np.min([np.abs(sections[left] - turned).max(axis=(1, 2)) for turned in turns], axis=0)
        labels[left[0]] = labels[left[apart <= tolerance]] = label
        label += 1
    return labels


def overlapping_clouds(low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """Return labels, (clouds,), equal for clouds whose bounding boxes overlap, the boxes of whole groups included.

    Labels count from 0 in the order in which the groups appear.

    Parameters
    ----------
    low, high : (clouds, size) corners of the boxes.
    """
    labels = np.full(len(low), -1)
    while (left := np.flatnonzero(labels < 0)).size:
        inside = left[:1]
        while True:
            bottom, top = low[inside].min(axis=0), high[inside].max(axis=0)
            wider = np.flatnonzero(((low <= top) & (high >= bottom)).all(axis=1))
            if wider.size == inside.size:
                break
            inside = wider
        known = labels[inside]
        labels[inside] = known[known >= 0].min() if (known >= 0).any() else labels.max() + 1
    return np.unique(labels, return_inverse=True)[1]
