"""One set of values of the parameters: the states and excitations that follow, and the sweeps of the claims."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from gearwear.chain.geometry import geometry
from gearwear.chain.history import last_state, states_of_case
from gearwear.claims.study import Study
from gearwear.claims.sweeps import Sweep
from gearwear.codes import motion_class
from gearwear.integrate.status import GROWTH, STATES
from gearwear.integrate.strobe_many import strobe_many
from gearwear.motions.section import recurrences, shrinking_periods
from gearwear.motions.settling import Settling
from gearwear.motions.start import rest_state
from gearwear.motions.sweep import settle_from_rest
from gearwear.oscillator.excitation import Excitation, SweptOscillator, excitation

SWEPT = (("without", "mesh_frequency"), ("with", "mesh_frequency"), ("with", "ste"), ("with", "backlash"))
TRANSIENT, SAMPLED = 250, 72  # mesh periods of the quick look
LARGEST_PERIOD = 16
RECURRENCE, NEAR = 1e-5, 2e-3  # over b0: the section recurs; it comes closer and is this near

Values = Mapping[tuple[str, str], np.ndarray]


class Pair(NamedTuple):
    """What a candidate makes of the gear pair.

    Attributes
    ----------
    sources : excitation of the cases `without` and `with` after their last wear cycle.
    states : geometry, wear of the case `with` cycle by cycle, and the transmission error of both cases in their last
        state, as the claims read them.
    dynamics : the section of that name.
    """

    sources: dict[str, Excitation]
    states: Study
    dynamics: dict[str, Any]


def pair_of(config: dict[str, Any]) -> Pair:
    """Return the pair that a configuration describes.

    Parameters
    ----------
    config : the sections that the stages of the chain read.

    Raises
    ------
    ValueError : the settings lead to a state that cannot be.
    """
    pair, torque, dynamics = geometry(config), config["operation"]["pinion_torque"], config["dynamics"]
    reference = last_state(config, pair, dynamics["reference_case"])
    hot = list(states_of_case(config, pair, "with", reference))
    last = {"without": last_state(config, pair, "without", reference), "with": hot[-1]}
    sources = {case: excitation(pair, state, reference, torque, dynamics) for case, state in last.items()}
    results = {"geometry": pair} | {("wear", "with", cycle): state[["wear_depth"]] for cycle, state in enumerate(hot)}
    ends = (("without", 0), ("with", len(hot) - 1))
    results |= {("transmission_error", *end): last[end[0]][["transmission_error"]] for end in ends}
    return Pair(sources, Study(results, ends), dynamics)


def quick_sweeps(config: dict[str, Any], several: Sequence[Pair], values: Values) -> list[dict[tuple[str, str], Sweep]]:
    """Return sweeps of many candidates, run side by side, every point from rest and classified by its section alone.

    A section that recurs, or comes closer to itself, within 1e-5 or 2e-3 of b0, has that period; else it is chaotic.

    Parameters
    ----------
    config : the sections that the sweeps read, alike for all candidates but for the damping ratio.
    several : the candidates.
    values : the swept values, ascending, by case and sweep.
    """
    oscillators, starts = [], []
    for one in several:
        for (case, quantity), chosen in values.items():
            swept = SweptOscillator(one.sources[case], quantity, one.dynamics, config["sweeps"][quantity])
            own = [swept.at(value) for value in chosen]
            oscillators += own
            starts += [rest_state(swept.source, oscillator, one.dynamics) for oscillator in own]
    run = strobe_many(oscillators, np.array(starts), TRANSIENT + SAMPLED, detail=STATES, detect_cycles=True)
    sections = run.states[:, -SAMPLED:]
    classes = _classes(sections)
    extents = np.concatenate([sections.min(axis=1), sections.max(axis=1)], axis=1)[:, [0, 2, 1, 3]]
    found, place = [], 0
    for _ in several:
        sweeps = {}
        for name, chosen in values.items():
            part = slice(place, place + len(chosen))
            sweeps[name] = Sweep(chosen, classes[part], extents[part])
            place += len(chosen)
        found.append(sweeps)
    return found


def settled_sweeps(
    config: dict[str, Any], sources: dict[str, Excitation], values: Values
) -> dict[tuple[str, str], Sweep]:
    """Return the sweeps of one candidate as the study computes them from rest, with all evidence for the classes."""
    dynamics, settling, found = config["dynamics"], Settling(**config["settling"]), {}
    for (case, quantity), chosen in values.items():
        swept = SweptOscillator(sources[case], quantity, dynamics, config["sweeps"][quantity])
        own = [swept.at(value) for value in chosen]
        motions = settle_from_rest(swept.source, own, dynamics, settling, detail=GROWTH)
        sections = np.array([np.column_stack([motion.displacement, motion.velocity]) for motion in motions])
        extents = np.concatenate([sections.min(axis=1), sections.max(axis=1)], axis=1)[:, [0, 2, 1, 3]]
        found[case, quantity] = Sweep(chosen, np.array([motion.motion_class for motion in motions]), extents)
    return found


def _classes(sections: np.ndarray) -> np.ndarray:
    finite = np.isfinite(sections).all(axis=(1, 2))
    classes = np.full(len(sections), motion_class.NOT_CONVERGED)
    classes[finite] = recurrences(sections[finite], LARGEST_PERIOD, RECURRENCE)[0]
    for point in np.flatnonzero(finite & (classes == 0)):
        closer = shrinking_periods(sections[point], LARGEST_PERIOD, NEAR)
        classes[point] = closer[0] if closer else motion_class.CHAOTIC
    return classes
