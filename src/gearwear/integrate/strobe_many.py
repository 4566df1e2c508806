"""Motion of many oscillators over whole forcing periods: what strobe.strobe does, point by point, in one call."""

import numpy as np

from gearwear.integrate.affine.affine_batch import count_all, run_many
from gearwear.integrate.status import RECORDS
from gearwear.integrate.strobe import (
    AUTOMATIC,
    GENERAL,
    Strobe,
    check_request,
    collected,
    stored,
    strobe,
    vector,
)
from gearwear.oscillator.oscillator import Oscillator
from gearwear.oscillator.periodic import Harmonics
from gearwear.oscillator.translational import TranslationalOscillator

LONGEST_TABLE = 1024  # cells: longer tables of sixteen lanes would take too much memory


def strobe_many(
    oscillators: list[Oscillator],
    states,
    periods: int,
    first_period: int = 0,
    tolerance: float = 1e-10,
    tangent=(1.0, 0.0),
    detail: int = RECORDS,
    backend: str = AUTOMATIC,
    detect_cycles: bool = False,
) -> Strobe:
    """Run many oscillators, each from its own state at mesh phase 0.

    Every point is that of strobe.strobe to the last bit, whatever the other points are.

    Parameters
    ----------
    oscillators : one a point, all of one kind; for many states of one oscillator repeat it
    states : (points, size) or (size,) displacement and velocity, then the rest of the state; or only these two
    tangent : as the states
    periods, first_period, tolerance, detail, backend : as in strobe.strobe
    detect_cycles : as in strobe.strobe

    Returns
    -------
    Strobe
        Every array, and ``status``, with a leading axis of points.

    Raises
    ------
    ValueError
        As strobe.strobe.
    """
    points = len(oscillators)
    if points == 0:
        raise ValueError("oscillators: the list is empty; give at least one")
    size = oscillators[0].size
    starts, directions = vector(states, "state", size, (points,)), vector(tangent, "tangent", size, (points,))
    for direction in directions if np.ndim(tangent) > 1 else directions[:1]:
        check_request(direction, periods, first_period, tolerance, detail, backend)
    alone = backend == GENERAL or points == 1 or isinstance(oscillators[0], TranslationalOscillator)
    single = np.array([alone or o.has_second_frequency for o in oscillators], dtype=bool)
    together = np.flatnonzero(~single)
    parts = []
    if together.size:
        stacked = _stack([oscillators[p] for p in together])
        counts = count_all(*stacked)
        if counts.max() > LONGEST_TABLE:
            single[together[counts > LONGEST_TABLE]] = True
            together = np.flatnonzero(~single)
            stacked = _stack([oscillators[p] for p in together]) if together.size else stacked
            counts = counts[counts <= LONGEST_TABLE]
    if together.size:
        chosen = [oscillators[p] for p in together]
        unit = directions[together] / np.hypot(*directions[together].T)[:, None]
        parts.append((together, _run(chosen, stacked, counts, starts[together], unit, periods, detail, detect_cycles)))
    for p in np.flatnonzero(single):
        run = strobe(
            oscillators[p], starts[p], periods, first_period, tolerance, directions[p], detail, backend, detect_cycles
        )
        parts.append((np.array([p]), Strobe._make(value if value is None else np.array([value]) for value in run)))
    return _merged(parts, points)


def _merged(parts, points: int) -> Strobe:
    if len(parts) == 1 and len(parts[0][0]) == points:
        return parts[0][1]
    fields = []
    for values in zip(*(part for _, part in parts), strict=True):
        whole = None
        if values[0] is not None:
            whole = np.empty((points, *values[0].shape[1:]), dtype=values[0].dtype)
            for (chosen, _), value in zip(parts, values, strict=True):
                whole[chosen] = value
        fields.append(whole)
    return Strobe._make(fields)


def _run(oscillators, stacked, counts, starts, directions, periods, detail, detect_cycles):
    order = np.argsort(counts, kind="stable")
    shared = [False] + [oscillators[a] is oscillators[b] for a, b in zip(order[1:], order[:-1], strict=True)]
    run_with = stored(detail, detect_cycles)
    states, maps, growth, records, status = run_many(
        *stacked, np.array(shared), order, counts, starts, directions, int(periods), run_with, detect_cycles
    )
    period = 2 * np.pi / stacked[0][:, :1]
    return collected(period, states, maps, growth, records, directions, status, detail)


def _stack(oscillators):
    """Coefficients of all oscillators in common arrays: see affine_batch.run_many."""
    if all(isinstance(o.stiffness, Harmonics) and isinstance(o.error, Harmonics) for o in oscillators):
        return _stack_of_harmonics(oscillators)
    parts = [oscillator.coefficients for oscillator in oscillators]
    rows = max(part.harmonics.shape[0] for part in parts)
    harmonics = np.zeros((len(parts), rows, 8))
    for p, part in enumerate(parts):
        harmonics[p, : part.harmonics.shape[0]] = part.harmonics
    places = np.cumsum([0] + [len(part.cells) for part in parts])
    cells = np.concatenate([part.cells for part in parts])
    return np.array([part.constants for part in parts], dtype=float), harmonics, cells, places


def _stack_of_harmonics(oscillators):
    """The same for oscillators without tables, in a tenth of the time."""
    points = len(oscillators)
    constants = np.array(
        [
            (o.frequency, 2 * o.damping_ratio, o.mean_force, o.clearance.mean, o.torque.frequency_ratio)
            for o in oscillators
        ]
    )
    kinds = [[getattr(o, name) for o in oscillators] for name in ("stiffness", "error", "clearance", "torque")]
    rows = max(len(wave.amplitudes) for waves in kinds for wave in waves)
    harmonics = np.empty((points, rows, 8))
    for column, waves in enumerate(kinds):
        harmonics[:, :, 2 * column : 2 * column + 2] = _cosines_and_sines(waves, rows)
    harmonics[:, :, 2:4] *= ((np.arange(1, rows + 1) * constants[:, :1]) ** 2)[:, :, None]
    cells = np.zeros((points, 6))
    cells[:, 1], cells[:, 2] = 1.0, [o.stiffness.mean for o in oscillators]
    return constants, harmonics, cells, np.arange(points + 1)


def _cosines_and_sines(waves, rows: int) -> np.ndarray:
    """(points, rows, 2) coefficients of one wave a point; what many points share is worked out once."""
    distinct = {id(wave): wave for wave in waves}
    place = {identity: number for number, identity in enumerate(distinct)}
    padding = (0.0,) * rows
    amplitudes, phases = (
        np.array([(getattr(wave, name) + padding)[:rows] for wave in distinct.values()]).reshape(-1, rows)
        for name in ("amplitudes", "phases")
    )
    table = np.stack([amplitudes * np.cos(phases), -(amplitudes * np.sin(phases))], axis=-1)
    return table[[place[id(wave)] for wave in waves]]
