"""The tabulated affine map of sixteen oscillators side by side: affine_flow for the vector registers of a processor.

Every lane has its own table and meets its own switching points, by the same operations in the same order as in
affine_flow: its results are those of affine_flow to the last bit, whatever its neighbours are. The lanes share nothing
but the loop over cells; one with fewer cells, or none to run, stands still in cells that change nothing.
"""

import math

import numpy as np

from gearwear.integrate.affine.affine_table import COMMON, CONTACT, FREE, FRESH, INTO, KICK_V, KICK_X
from gearwear.integrate.affine.cell_crossing import MAP, affine, cross_cell, side_at_start
from gearwear.integrate.affine.cell_exit import READY
from gearwear.integrate.affine.cell_extremes import WORK, note_piece
from gearwear.integrate.affine.cycle_detection import fill_if_recurring
from gearwear.integrate.affine.plain_step import (
    GROWN,
    LANES,
    PLACES,
    S0,
    S1,
    S2,
    S3,
    SIDE,
    T0,
    T1,
    T2,
    T3,
    V0,
    X0,
    V,
    X,
    make_unit,
    plain_steps,
    stand_still,
)
from gearwear.integrate.compiled import njit, njit_noalloc
from gearwear.integrate.status import (
    BLOW_UP,
    COLUMNS,
    GROWTH,
    HIGHEST,
    IMPACTS,
    LARGEST_DISPLACEMENT,
    LOWEST,
    MAPS,
    RECORDS,
    STATES,
    TOO_MANY_STEPS,
)
from gearwear.integrate.tangent import growth_of


@njit_noalloc
def enter_branch(common, lanes, lane, record, counts):
    """Set the branch of a lane from its state at the start of a cell."""
    entered = side_at_start(common, lanes[X * LANES + lane], lanes[V * LANES + lane])
    if counts and entered != 0.0 and entered != lanes[SIDE * LANES + lane]:
        record[lane, IMPACTS] += 1.0
    lanes[SIDE * LANES + lane] = entered


@njit_noalloc
def cross_lane(cell, lanes, lane, detail, work, record):
    """Carry a lane that may meet a switching point through its cell; False if it cannot be carried on."""
    x1, v1, side, completed = cross_cell(
        cell,
        lanes[SIDE * LANES + lane],
        lanes[X0 * LANES + lane],
        lanes[V0 * LANES + lane],
        detail,
        work,
        record,
        lane,
    )
    lanes[X * LANES + lane], lanes[V * LANES + lane], lanes[SIDE * LANES + lane] = x1, v1, side
    if detail >= GROWTH:
        m0, m1, m2, m3 = work[MAP], work[MAP + 1], work[MAP + 2], work[MAP + 3]
        a, b = lanes[S0 * LANES + lane], lanes[S1 * LANES + lane]
        c, d = lanes[S2 * LANES + lane], lanes[S3 * LANES + lane]
        lanes[T0 * LANES + lane], lanes[T1 * LANES + lane] = m0 * a + m1 * c, m0 * b + m1 * d
        lanes[T2 * LANES + lane], lanes[T3 * LANES + lane] = m2 * a + m3 * c, m2 * b + m3 * d
    return completed


@njit_noalloc
def note_lane(cell, lanes, lane, work, record):
    """Take a plain step of a lane into the record of its period."""
    side, x, v = lanes[SIDE * LANES + lane], lanes[X0 * LANES + lane], lanes[V0 * LANES + lane]
    branch = cell[CONTACT if side != 0.0 else FREE]
    xm, vm = affine(branch, INTO, side, x, v)
    x1, v1 = lanes[X * LANES + lane], lanes[V * LANES + lane]
    work[READY] = 0.0
    note_piece(cell[COMMON], branch, (side, xm, vm), -1.0, x, v, 1.0, x1, v1, work, record, lane)


@njit_noalloc
def kick_lane(common, lanes, lane, record):
    """Add the kick at the end of a cell, and take the state after it into the record."""
    x = lanes[X * LANES + lane] + common[KICK_X]
    lanes[X * LANES + lane], lanes[V * LANES + lane] = x, lanes[V * LANES + lane] + common[KICK_V]
    record[lane, LOWEST], record[lane, HIGHEST] = min(record[lane, LOWEST], x), max(record[lane, HIGHEST], x)


@njit_noalloc
def freeze(lanes, lane, plain, cells):
    """Let a lane stand still for good."""
    for n in range(cells):
        stand_still(plain, n, lane)
    lanes[X * LANES + lane] = lanes[V * LANES + lane] = lanes[SIDE * LANES + lane] = 0.0


@njit_noalloc
def end_period(lanes, lane, i, detail, direction, states, maps, growth, record, records):
    """Store what a lane did in period i; False if it blew up."""
    x, v = lanes[X * LANES + lane], lanes[V * LANES + lane]
    if not (abs(x) < LARGEST_DISPLACEMENT and abs(v) < LARGEST_DISPLACEMENT):
        return False
    states[i + 1, 0], states[i + 1, 1] = x, v
    if detail >= GROWTH:
        a, b = lanes[T0 * LANES + lane], lanes[T1 * LANES + lane]
        c, d = lanes[T2 * LANES + lane], lanes[T3 * LANES + lane]
        if detail == GROWTH:
            growth[i] = 0.5 * math.log(lanes[GROWN * LANES + lane])
            direction[0], direction[1] = a, c
        if detail >= MAPS:
            growth[i] = growth_of(direction, a * direction[0] + b * direction[1], c * direction[0] + d * direction[1])
            maps[i, 0, 0], maps[i, 0, 1], maps[i, 1, 0], maps[i, 1, 1] = a, b, c, d
        if detail == RECORDS:
            for column in range(COLUMNS):
                records[i, column] = record[lane, column]
    return True


@njit
def new_scratch(longest):
    """Working arrays of a group whose longest table has so many cells."""
    return (
        np.zeros(PLACES * LANES),
        np.zeros(WORK),
        np.zeros((LANES, COLUMNS)),
        np.zeros(LANES, np.bool_),
        np.zeros(longest, np.bool_),
    )


@njit_noalloc
def run_group(
    rows,
    counts,
    plain,
    slack,
    group,
    periods,
    detail,
    detect_cycles,
    scratch,
    directions,
    states,
    maps,
    growth,
    records,
    status,
):
    """Run whole periods of up to sixteen oscillators; arguments and results as affine_flow.run, with an axis of points.

    Parameters
    ----------
    rows : tables of the lanes, one below the other, each in as many rows as the longest needs
    counts : (LANES,) number of cells, 0 for a lane without a point
    plain, slack : as from pack_plain, and (3 LANES,)
    group : (LANES,) number of the point of every lane
    detect_cycles : whether a lane whose state recurs is filled in
    scratch : arrays of the sizes of new_scratch
    """
    lanes, work, record, alive, kicked = scratch
    longest = kicked.size
    lanes[:] = 0.0
    kicked[:] = False
    for lane in range(LANES):
        alive[lane] = counts[lane] > 0
        lanes[T0 * LANES + lane] = 1.0
        if alive[lane]:
            lanes[T0 * LANES + lane], lanes[T2 * LANES + lane] = directions[group[lane], 0], directions[group[lane], 1]
            lanes[X * LANES + lane], lanes[V * LANES + lane] = states[group[lane], 0, 0], states[group[lane], 0, 1]
            for n in range(counts[lane]):
                r = lane * longest + n
                kicked[n] |= rows[r, COMMON, KICK_X] != 0.0 or rows[r, COMMON, KICK_V] != 0.0
    for i in range(periods):
        for lane in range(LANES):
            if detail >= MAPS:
                lanes[T0 * LANES + lane], lanes[T1 * LANES + lane] = 1.0, 0.0
                lanes[T2 * LANES + lane], lanes[T3 * LANES + lane] = 0.0, 1.0
            if detail == RECORDS:
                record[lane, :] = 0.0
                record[lane, LOWEST] = record[lane, HIGHEST] = lanes[X * LANES + lane]
            if alive[lane]:
                enter_branch(rows[lane * longest, COMMON], lanes, lane, record, i > 0)
        for n in range(longest):
            if n > 0 and kicked[n - 1]:
                for lane in range(LANES):
                    if alive[lane] and n < counts[lane] and rows[lane * longest + n, COMMON, FRESH] != 0.0:
                        enter_branch(rows[lane * longest + n, COMMON], lanes, lane, record, True)
            if detail == STATES:
                doubtful = plain_steps(plain[n], slack, lanes, 0)
            elif detail == GROWTH:
                doubtful = plain_steps(plain[n], slack, lanes, 1)
            else:
                doubtful = plain_steps(plain[n], slack, lanes, 2)
            if detail == RECORDS:
                for lane in range(LANES):
                    if alive[lane] and n < counts[lane] and not doubtful >> lane & 1:
                        note_lane(rows[lane * longest + n], lanes, lane, work, record)
            lane = 0
            while doubtful:
                if doubtful & 1 and not cross_lane(rows[lane * longest + n], lanes, lane, detail, work, record):
                    blown = not abs(lanes[X * LANES + lane]) < LARGEST_DISPLACEMENT
                    status[group[lane]] = BLOW_UP if blown else TOO_MANY_STEPS
                    alive[lane] = False
                    freeze(lanes, lane, plain, longest)
                doubtful >>= 1
                lane += 1
            if kicked[n]:
                for lane in range(LANES):
                    if alive[lane] and n < counts[lane]:
                        kick_lane(rows[lane * longest + n, COMMON], lanes, lane, record)
        if detail == GROWTH:
            make_unit(lanes)
        living = 0
        for lane in range(LANES):
            p = group[lane]
            if alive[lane]:
                done = not end_period(
                    lanes, lane, i, detail, directions[p], states[p], maps[p], growth[p], record, records[p]
                )
                if done:
                    status[p] = BLOW_UP
                elif detect_cycles:
                    done = fill_if_recurring(i + 1, detail, directions[p], states[p], maps[p], growth[p], records[p])
                if done:
                    alive[lane] = False
                    freeze(lanes, lane, plain, longest)
            living += 1 if alive[lane] else 0
        if living == 0:
            break
