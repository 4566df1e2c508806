"""The flow of the oscillator over whole forcing periods, with its tangent and what happened on the way.

A period starts at time 0 exactly, with its branch and its step size taken afresh: the map of one period is a pure
function of the state (and, with an external torque, of the period's index), however many periods one call runs.
"""

import math

import numpy as np

from gearwear.integrate.compiled import njit
from gearwear.integrate.dormand_prince.dormand_prince import (
    FRICTION,
    full_load,
    linear_step,
    squared_error,
    stage_loads,
)
from gearwear.integrate.dormand_prince.switching_points import (
    CLEAR,
    EXIT,
    UNDECIDED,
    branch_at,
    exit_of_step,
    highest_force,
    highest_value,
)
from gearwear.integrate.status import (
    BLOW_UP,
    COLUMNS,
    COMPLETED,
    FORCE,
    HIGHEST,
    IMPACTS,
    LARGEST_DISPLACEMENT,
    LOST,
    LOWEST,
    TOO_MANY_STEPS,
)

LARGEST_STEP = 0.5
MOST_STEPS = 2_000_000
TANGENT_TOLERANCE = 100.0  # tangent vectors, over the tolerance of the state
GRAZING_BAND = 1e3  # interpolated margins below this times the tolerance are settled by stepping
STEPS = COLUMNS  # one more column of the records: the steps taken


@njit
def initial_branch(cell, harmonics, t, x, v):
    """Branch of the state at the time t in a cell."""
    at = full_load(cell, harmonics, 0, t)
    return branch_at(x, v, at[1] - cell[FRICTION] * v, at)


@njit
def advance(cell, harmonics, t, t_end, y, branch, h, tolerance, record):
    """Carry y = (x, v, tangent 1, tangent 2) from t to t_end inside one cell; record is updated.

    Returns
    -------
    branch, h, status : the branch at t_end, the next step to try, and COMPLETED, BLOW_UP or TOO_MANY_STEPS
    """
    c = cell[FRICTION]
    no_force = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    before = full_load(cell, harmonics, branch, t)
    while t < t_end:
        record[STEPS] += 1
        if record[STEPS] > MOST_STEPS:
            return branch, h, TOO_MANY_STEPS
        last = h >= (t_end - t) * (1 - 1e-9)
        step = t_end - t if last else h
        x, v = y[0], y[1]
        k, g, after = stage_loads(cell, harmonics, branch, t, step, before)
        x1, v1, a1, dx, dv = linear_step(step, c, x, v, k, g)
        if not (abs(x1) < LARGEST_DISPLACEMENT and abs(v1) < LARGEST_DISPLACEMENT):
            return branch, h, BLOW_UP
        p1, q1, _, dp, dq = linear_step(step, c, y[2], y[3], k, no_force)
        p2, q2, _, dr, ds = linear_step(step, c, y[4], y[5], k, no_force)
        error = max(
            squared_error(tolerance, x, v, x1, v1, dx, dv),
            max(
                squared_error(TANGENT_TOLERANCE * tolerance, y[2], y[3], p1, q1, dp, dq),
                squared_error(TANGENT_TOLERANCE * tolerance, y[4], y[5], p2, q2, dr, ds),
            ),
        )
        proposal = step * min(5.0, max(0.2, 0.9 * max(error, 1e-20) ** -0.1))
        if error > 1.0:
            h = proposal
            continue
        if proposal < h or not last:
            h = min(proposal, LARGEST_STEP)
        a = g[0] - c * v - k[0] * x
        verdict, length, side = exit_of_step(
            cell,
            harmonics,
            branch,
            t,
            step,
            (x, v, a),
            (x1, v1, a1),
            before,
            after,
            GRAZING_BAND * tolerance,
        )
        if verdict == UNDECIDED:
            h = 0.5 * step
            continue
        if verdict != CLEAR and length < step:
            last, step = False, length
            k, g, after = stage_loads(cell, harmonics, branch, t, step, before)
            x1, v1, a1, _, _ = linear_step(step, c, x, v, k, g)
            p1, q1, _, _, _ = linear_step(step, c, y[2], y[3], k, no_force)
            p2, q2, _, _, _ = linear_step(step, c, y[4], y[5], k, no_force)
        record[HIGHEST] = max(record[HIGHEST], highest_value(step, x, v, a, x1, v1, a1))
        record[LOWEST] = min(record[LOWEST], -highest_value(step, -x, -v, -a, -x1, -v1, -a1))
        if branch == 0:
            record[LOST] += step
        else:
            force = highest_force(step, branch, x, v, before, x1, v1, after)
            record[FORCE] = max(record[FORCE], force)
        t = t_end if last else t + step
        before = after
        y[0], y[1], y[2], y[3], y[4], y[5] = x1, v1, p1, q1, p2, q2
        if verdict == EXIT:
            y[0] = side * after[2]
            entered = branch_at(y[0], v1, a1, after)
            if entered != 0 and branch == 0:
                record[IMPACTS] += 1
            if entered != branch:
                branch = entered
                before = full_load(cell, harmonics, branch, t)
    return branch, h, COMPLETED


@njit
def run(constants, harmonics, cells, state, direction, first_period, periods, tolerance, phases):
    """Run whole periods, and note the state at mesh phases in [0, 1] (increasing, may be none) of each.

    Parameters
    ----------
    constants, harmonics, cells : as in Coefficients
    state, direction : (2,) state at mesh phase 0 and tangent vector; the direction is updated in place

    Returns
    -------
    states : (periods + 1, 2) at mesh phase 0, after the kick there
    maps : (periods, 2, 2) derivative of the state after a period by the state before it
    growth : (periods,) logarithm of the growth of the direction
    records : (periods, COLUMNS + 1) columns as in status, and STEPS
    visits : (periods, phases, 2)
    status : COMPLETED, BLOW_UP or TOO_MANY_STEPS; what was not reached is NaN
    """
    frequency, friction, mean_force, clearance, ratio = constants
    period = 2.0 * math.pi / frequency
    states = np.full((periods + 1, 2), np.nan)
    maps = np.full((periods, 2, 2), np.nan)
    growth = np.full(periods, np.nan)
    records = np.full((periods, COLUMNS + 1), np.nan)
    visits = np.full((periods, phases.size, 2), np.nan)
    y, record = np.empty(6), np.zeros(COLUMNS + 1)
    y[0], y[1] = state[0], state[1]
    states[0, 0], states[0, 1] = y[0], y[1]
    branch = 0
    for i in range(periods):
        y[2], y[3], y[4], y[5] = 1.0, 0.0, 0.0, 1.0
        record[LOWEST], record[HIGHEST] = y[0], y[0]
        record[FORCE:] = 0.0
        torque_phase = 2.0 * math.pi * (((ratio % 1.0) * (first_period + i)) % 1.0)
        h = 4.0 * tolerance**0.2
        noted = 0
        for n in range(cells.shape[0]):
            start, stop, stiffness, slope = cells[n, 0], cells[n, 1], cells[n, 2], cells[n, 3]
            t, t_end = start * period, stop * period
            cell = (
                frequency,
                stiffness,
                slope,
                t,
                mean_force,
                clearance,
                ratio * frequency,
                torque_phase,
                friction,
            )
            if n == 0 or cells[n - 1, 4] != 0.0 or cells[n - 1, 5] != 0.0:
                entered = initial_branch(cell, harmonics, t, y[0], y[1])
                if i + n > 0 and entered != 0 and entered != branch:
                    record[IMPACTS] += 1
                branch = entered
            while noted < phases.size and phases[noted] < stop:
                target = min(phases[noted] * period, t_end)
                branch, h, status = advance(cell, harmonics, t, target, y, branch, h, tolerance, record)
                if status != COMPLETED:
                    return states, maps, growth, records, visits, status
                visits[i, noted, 0], visits[i, noted, 1] = y[0], y[1]
                noted += 1
                t = max(t, target)
            branch, h, status = advance(cell, harmonics, t, t_end, y, branch, h, tolerance, record)
            if status != COMPLETED:
                return states, maps, growth, records, visits, status
            y[0] += cells[n, 4]
            y[1] += cells[n, 5]
            record[LOWEST], record[HIGHEST] = min(record[LOWEST], y[0]), max(record[HIGHEST], y[0])
        while noted < phases.size:
            visits[i, noted, 0], visits[i, noted, 1] = y[0], y[1]
            noted += 1
        states[i + 1, 0], states[i + 1, 1] = y[0], y[1]
        maps[i, 0, 0], maps[i, 1, 0], maps[i, 0, 1], maps[i, 1, 1] = y[2], y[3], y[4], y[5]
        records[i] = record
        p = y[2] * direction[0] + y[4] * direction[1]
        q = y[3] * direction[0] + y[5] * direction[1]
        size = math.hypot(p, q)
        growth[i] = math.log(size / math.hypot(direction[0], direction[1]))
        direction[0], direction[1] = p / size, q / size
    return states, maps, growth, records, visits, COMPLETED
