"""The tabulated affine map of one oscillator over whole forcing periods: the readable specification.

Nearly all cells are passed in one step of a tabulated affine map; a cell that may hold a switching point goes through
cell_crossing. The branch at mesh phase 0 is that of the state there: the map of a period is a function of it alone.
"""

import numpy as np

from gearwear.integrate.affine.affine_table import (
    CLEARANCE_HIGH,
    CLEARANCE_LOW,
    COMMON,
    CONTACT,
    FREE,
    FRESH,
    HALF_WIDTH,
    INTO,
    KICK_V,
    KICK_X,
    STEP,
)
from gearwear.integrate.affine.cell_crossing import MAP, affine, cross_cell, side_at_start
from gearwear.integrate.affine.cell_exit import READY
from gearwear.integrate.affine.cell_extremes import WORK, note_piece
from gearwear.integrate.affine.cycle_detection import fill_if_recurring
from gearwear.integrate.compiled import njit, njit_inline, njit_noalloc
from gearwear.integrate.status import (
    BLOW_UP,
    COLUMNS,
    COMPLETED,
    GROWTH,
    HIGHEST,
    IMPACTS,
    LARGEST_DISPLACEMENT,
    LOWEST,
    MAPS,
    RECORDS,
    TOO_MANY_STEPS,
)
from gearwear.integrate.tangent import growth_of

THIRD = 1.0 / 3.0


@njit_inline
def stays(side, x, v, x1, v1, half, low, high, slack_x, slack_v, slack_1):
    """Whether a cell is passed on one branch for sure: the hull of cell_exit keeps its side of the switching points."""
    q1, q3 = x + 0.5 * half * v, x1 - 0.5 * half * v1
    q2 = 0.5 * (x + x1) + THIRD * half * (v - v1)
    slack = slack_x * abs(x) + slack_v * abs(v) + slack_1
    free = side == 0.0
    gap1 = low - abs(q1) if free else side * q1 - high
    gap2 = low - abs(q2) if free else side * q2 - high
    gap3 = low - abs(q3) if free else side * q3 - high
    gap4 = low - abs(x1) if free else side * x1 - high
    return (gap1 > 0.0) & (gap2 > slack) & (gap3 > 0.0) & (gap4 > 0.0)


@njit_noalloc
def run_period(rows, slack, state, side, index, detail, start, work, record, stops, visits):
    """Carry a state through one period; arguments as in run, the number ``index`` of the period.

    ``side`` is the branch before it, for an entry into contact by the last kick. The state and the record
    (1, COLUMNS) are updated, visits (stops, 2) written.

    Returns
    -------
    a, b, c, d, side, status : the matrix ``start`` multiplied by the tangent map of the period; branch at its end
    """
    x, v = state[0], state[1]
    a, b, c, d = start
    record[0, :] = 0.0
    record[0, LOWEST], record[0, HIGHEST] = x, x
    noted = 0
    for r in range(rows.shape[0]):
        while noted < stops.size and stops[noted] == r:
            visits[noted, 0], visits[noted, 1] = x, v
            noted += 1
        common = rows[r, COMMON]
        if common[FRESH] != 0.0:
            entered = side_at_start(common, x, v)
            if index + r > 0 and entered != 0.0 and entered != side:
                record[0, IMPACTS] += 1.0
            side = entered
        branch = rows[r, CONTACT if side != 0.0 else FREE]
        x1, v1 = affine(branch, STEP, side, x, v)
        if stays(
            side,
            x,
            v,
            x1,
            v1,
            common[HALF_WIDTH],
            common[CLEARANCE_LOW],
            common[CLEARANCE_HIGH],
            slack[0],
            slack[1],
            slack[2],
        ):
            m0, m1, m2, m3 = branch[STEP], branch[STEP + 1], branch[STEP + 2], branch[STEP + 3]
            if detail == RECORDS:
                work[READY] = 0.0
                middle = affine(branch, INTO, side, x, v)
                note_piece(common, branch, (side, middle[0], middle[1]), -1.0, x, v, 1.0, x1, v1, work, record, 0)
        else:
            x1, v1, side, completed = cross_cell(rows[r], side, x, v, detail, work, record, 0)
            if not completed:
                return a, b, c, d, side, BLOW_UP if not abs(x1) < LARGEST_DISPLACEMENT else TOO_MANY_STEPS
            m0, m1, m2, m3 = work[MAP], work[MAP + 1], work[MAP + 2], work[MAP + 3]
        a, b, c, d = m0 * a + m1 * c, m0 * b + m1 * d, m2 * a + m3 * c, m2 * b + m3 * d
        x, v = x1 + common[KICK_X], v1 + common[KICK_V]
        record[0, LOWEST], record[0, HIGHEST] = min(record[0, LOWEST], x), max(record[0, HIGHEST], x)
    while noted < stops.size:
        visits[noted, 0], visits[noted, 1] = x, v
        noted += 1
    state[0], state[1] = x, v
    if not (abs(x) < LARGEST_DISPLACEMENT and abs(v) < LARGEST_DISPLACEMENT):
        return a, b, c, d, side, BLOW_UP
    return a, b, c, d, side, COMPLETED


@njit
def run(rows, slack, state, direction, first_period, periods, detail, stops, detect_cycles):
    """Run whole periods of the oscillator of a table.

    Parameters
    ----------
    rows, slack : as in AffineTable
    first_period : index of the first one, which tells the table it begins with
    state, direction : (2,) state at mesh phase 0 and tangent vector of length 1; the direction is updated in place
    detail : STATES; GROWTH of the direction; MAPS too; RECORDS too. What is not asked for is NaN
    stops : increasing numbers of cells at whose start the state is noted; the number of cells for the period's end
    detect_cycles : whether a motion whose state recurs is filled in by cycle detection; with one table, without stops

    Returns
    -------
    states : (periods + 1, 2) at mesh phase 0, after the kick there
    maps : (periods, 2, 2) derivative of the state after a period by the state before it
    growth : (periods,) logarithm of the growth of the direction
    records : (periods, COLUMNS) columns as in status
    visits : (periods, stops, 2)
    status : COMPLETED, BLOW_UP or TOO_MANY_STEPS; what was not reached is NaN
    """
    states = np.full((periods + 1, 2), np.nan)
    maps = np.full((periods, 2, 2), np.nan)
    growth = np.full(periods, np.nan)
    records = np.full((periods, COLUMNS), np.nan)
    visits = np.full((periods, stops.size, 2), np.nan)
    work, record, last = np.zeros(WORK), np.zeros((1, COLUMNS)), 0.0
    state = state.copy()
    states[0] = state
    for i in range(periods):
        start = (1.0, 0.0, 0.0, 1.0) if detail >= MAPS else (direction[0], 0.0, direction[1], 0.0)
        a, b, c, d, last, status = run_period(
            rows[(first_period + i) % rows.shape[0]],
            slack,
            state,
            last,
            i,
            detail,
            start,
            work,
            record,
            stops,
            visits[i],
        )
        if status != COMPLETED:
            visits[i] = np.nan
            return states, maps, growth, records, visits, status
        states[i + 1] = state
        if detail == GROWTH:
            growth[i] = growth_of(direction, a, c)
        if detail >= MAPS:
            growth[i] = growth_of(direction, a * direction[0] + b * direction[1], c * direction[0] + d * direction[1])
            maps[i, 0, 0], maps[i, 0, 1], maps[i, 1, 0], maps[i, 1, 1] = a, b, c, d
        if detail == RECORDS:
            records[i] = record[0]
        if detect_cycles and fill_if_recurring(i + 1, detail, direction, states, maps, growth, records):
            break
    return states, maps, growth, records, visits, COMPLETED
