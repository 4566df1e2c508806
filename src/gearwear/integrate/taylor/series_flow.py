"""The flow of the translational oscillator over whole forcing periods, by power series; the error is round-off.

A period starts with its branch taken afresh: the map of one period is a pure function of the state (and, with an
external torque, of the period's index), however many periods one call runs.
"""

import math

import numpy as np

from gearwear.integrate.compiled import njit
from gearwear.integrate.status import (
    BLOW_UP,
    COLUMNS,
    COMPLETED,
    FORCE,
    GROWTH,
    HIGHEST,
    IMPACTS,
    LARGEST_DISPLACEMENT,
    LOST,
    LOWEST,
    MAPS,
    RECORDS,
    TOO_MANY_STEPS,
)
from gearwear.integrate.taylor.power_series import TERMS, extreme, shift, value
from gearwear.integrate.taylor.series_step import branch_of, expand, first_switch

MOST_SWITCHES = 1000  # in one cell


@njit
def add_torque(driven, torque, turn):
    """Add the external torque to the force of a cell; turn is the phase of its first harmonic, rad."""
    for j in range(torque.shape[0]):
        c, s = math.cos((j + 1) * turn), math.sin((j + 1) * turn)
        for n in range(TERMS):
            driven[1, n] += c * torque[j, 0, n] - s * torque[j, 1, n]


@njit
def note_step(record, side, end, length, motion, mesh):
    """Update extremes, largest force and time out of contact by a step up to a share of its length."""
    record[HIGHEST] = max(record[HIGHEST], extreme(motion[0], 1.0, end))
    record[LOWEST] = min(record[LOWEST], extreme(motion[0], -1.0, end))
    if side == 0:
        record[LOST] += end * length
    else:
        record[FORCE] = max(record[FORCE], side * extreme(mesh[1], float(side), end))


@njit
def transport(matrix, frame, moved):
    """Apply a matrix to every row of a frame."""
    for vector in range(frame.shape[0]):
        for i in range(moved.size):
            moved[i] = 0.0
            for j in range(moved.size):
                moved[i] += matrix[i, j] * frame[vector, j]
        for i in range(moved.size):
            frame[vector, i] = moved[i]


@njit
def advance(damping, stiffness, pull, length, whole, maps, side, z, frame, moved, record, records):
    """Carry a state and the rows of a frame through a cell.

    Returns
    -------
    side, status : the branch at the end of the cell, and COMPLETED, BLOW_UP or TOO_MANY_STEPS
    """
    size = z.size
    driven, still = np.empty((3, TERMS)), np.zeros((3, TERMS))
    motion, mesh = np.empty((size, TERMS)), np.empty((2, TERMS))
    other, other_mesh = np.empty((size, TERMS)), np.empty((2, TERMS))
    margin, scratch = np.empty(TERMS), np.empty(TERMS)
    begin = 0.0
    for _ in range(MOST_SWITCHES):
        left = (1.0 - begin) * length
        for n in range(3):
            shift(whole[n], begin, 1.0 - begin, driven[n])
        expand(damping, stiffness, pull, left, driven, side, z, motion, mesh)
        place, flank = first_switch(side, driven[2], motion[0], mesh, margin, scratch)
        end = min(place, 1.0)
        if records:
            note_step(record, side, end, left, motion, mesh)
        if place > 1.0 and begin == 0.0:
            transport(maps[abs(side)], frame, moved)
        else:
            for n in range(TERMS):
                still[0, n] = driven[0, n]
            for vector in range(frame.shape[0]):
                expand(damping, stiffness, pull, left, still, abs(side), frame[vector], other, other_mesh)
                for i in range(size):
                    frame[vector, i] = value(other[i], end)
        for i in range(size):
            z[i] = value(motion[i], end)
        if not (abs(z[0]) < LARGEST_DISPLACEMENT and abs(z[1]) < LARGEST_DISPLACEMENT):
            return side, BLOW_UP
        if place > 1.0:
            return side, COMPLETED
        z[0] = flank * value(driven[2], end)
        if side == 0:
            record[IMPACTS] += 1
        side = flank if side == 0 else 0
        begin += end * (1.0 - begin)
        if begin >= 1.0:
            return side, COMPLETED
    return side, TOO_MANY_STEPS


@njit
def run(linear, table, ratio, state, direction, first_period, periods, detail, stops):
    """Run whole periods, and note the state at the beginning of chosen cells of each.

    Parameters
    ----------
    linear : the three arrays of translational.LinearPart
    table : the arrays of series_table.SeriesTable but its starts
    ratio : frequency of the external torque over that of the mesh
    state, direction : (2 n,) at mesh phase 0, and a tangent vector of length 1; the direction is updated in place
    first_period, periods : index of the first period, and their number
    detail : as in strobe.strobe
    stops : (visits,) increasing indices of cells, the number of cells for the end of the period

    Returns
    -------
    states : (periods + 1, 2 n) at mesh phase 0, after the kick there
    tangents : (periods, 2 n, 2 n) derivative of the state after a period by the state before it
    growth : (periods,) logarithm of the growth of the direction
    records : (periods, COLUMNS) columns as in status
    visits : (periods, visits, 2 n)
    status : COMPLETED, BLOW_UP or TOO_MANY_STEPS; what was not reached, or not asked for, is NaN
    """
    damping, stiffness, pull = linear
    lengths, series, torque, kicks, maps = table
    size, cells = state.size, lengths.size
    states, growth = np.full((periods + 1, size), np.nan), np.full(periods, np.nan)
    tangents = np.full((periods if detail >= MAPS else 0, size, size), np.nan)
    records = np.full((periods, COLUMNS), np.nan)
    visits = np.full((periods, stops.size, size), np.nan)
    frame = np.zeros((size if detail >= MAPS else (1 if detail == GROWTH else 0), size))
    z, moved, whole, record = state.copy(), np.empty(size), np.empty((3, TERMS)), np.zeros(COLUMNS)
    motion, mesh = np.empty((size, TERMS)), np.empty((2, TERMS))
    states[0] = z
    side = 0
    for period in range(periods):
        frame[:] = 0.0
        for i in range(frame.shape[0]):
            frame[i, i] = 1.0
        if detail == GROWTH:
            frame[0] = direction
        record[:] = 0.0
        record[LOWEST], record[HIGHEST] = z[0], z[0]
        turn = 2.0 * math.pi * (((ratio % 1.0) * (first_period + period)) % 1.0)
        visited, kicked = 0, True
        for cell in range(cells):
            while visited < stops.size and stops[visited] == cell:
                visits[period, visited] = z
                visited += 1
            whole[:] = series[cell]
            add_torque(whole, torque[cell], turn)
            if kicked:
                entered = branch_of(damping, stiffness, pull, lengths[cell], whole, z, motion, mesh)
                if period + cell > 0 and entered != 0 and entered != side:
                    record[IMPACTS] += 1
                side = entered
            side, status = advance(
                damping,
                stiffness,
                pull,
                lengths[cell],
                whole,
                maps[cell],
                side,
                z,
                frame,
                moved,
                record,
                detail == RECORDS,
            )
            if status != COMPLETED:
                return states, tangents, growth, records, visits, status
            kicked = False
            for i in range(size):
                kicked = kicked or kicks[cell, i] != 0.0
                z[i] += kicks[cell, i]
            record[LOWEST], record[HIGHEST] = min(record[LOWEST], z[0]), max(record[HIGHEST], z[0])
        while visited < stops.size:
            visits[period, visited] = z
            visited += 1
        states[period + 1], records[period] = z, record
        if frame.shape[0] == 0:
            continue
        square = 0.0
        for i in range(size):
            moved[i] = frame[0, i]
            if detail >= MAPS:
                moved[i] = 0.0
                for j in range(size):
                    tangents[period, i, j] = frame[j, i]
                    moved[i] += frame[j, i] * direction[j]
            square += moved[i] * moved[i]
        growth[period] = 0.5 * math.log(square)
        for i in range(size):
            direction[i] = moved[i] / math.sqrt(square)
    return states, tangents, growth, records, visits, COMPLETED
