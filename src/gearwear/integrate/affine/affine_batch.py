"""Many oscillators through the tabulated affine map, sixteen at a time."""

import numpy as np

from gearwear.integrate.affine.affine_lanes import new_scratch, run_group
from gearwear.integrate.affine.affine_table import WIDTH, cell_counts, fill_table
from gearwear.integrate.affine.cell_series import TERMS
from gearwear.integrate.affine.plain_step import LANES, PLAIN, pack_plain, stand_still
from gearwear.integrate.compiled import njit
from gearwear.integrate.status import COLUMNS, COMPLETED, GROWTH, MAPS, RECORDS


@njit
def count_all(constants, harmonics, cells, places):
    """(points,) number of cells of every oscillator; arguments as in run_many."""
    counts = np.empty(constants.shape[0], np.int64)
    for p in range(constants.shape[0]):
        parts = cell_counts(constants[p], harmonics[p], cells[places[p] : places[p + 1]])
        counts[p] = 0
        for n in range(parts.size):
            counts[p] += parts[n]
    return counts


@njit
def run_many(
    constants, harmonics, cells, places, shared, order, counts, starts, directions, periods, detail, detect_cycles
):
    """Run whole periods of many oscillators.

    Parameters
    ----------
    constants, harmonics : (points, 5) and (points, harmonics, 8), rows as in Coefficients
    cells, places : cells of all oscillators one below the other; those of p are places[p] to places[p + 1]
    shared : (points,) True where the oscillator is that of the point before it in ``order``
    order : (points,) in which the points are dealt to the lanes; counts : from count_all
    starts, directions : (points, 2); the directions, of length 1, are updated in place
    detect_cycles : see affine_lanes.run_group

    Returns
    -------
    states, maps, growth, records, status : as affine_flow.run, each with a leading axis of points
    """
    points = starts.shape[0]
    states = np.full((points, periods + 1, 2), np.nan)
    maps = np.full((points, periods if detail >= MAPS else 0, 2, 2), np.nan)
    growth = np.full((points, periods if detail >= GROWTH else 0), np.nan)
    records = np.full((points, periods if detail == RECORDS else 0, COLUMNS), np.nan)
    status = np.full(points, COMPLETED)
    states[:, 0, :] = starts
    own, one_slack, scratch = np.zeros(LANES, np.int64), np.zeros(3), np.empty(2 * TERMS)
    group, slack = np.zeros(LANES, np.int64), np.zeros(3 * LANES)
    for begin in range(0, points, LANES):
        own[:] = 0
        longest = 0
        for lane in range(min(LANES, points - begin)):
            group[lane] = order[begin + lane]
            own[lane] = counts[group[lane]]
            longest = max(longest, own[lane])
        rows = np.empty((LANES * longest, 3, WIDTH))
        plain = np.empty((longest, PLAIN * LANES))
        for lane in range(LANES):
            p, first = group[lane], lane * longest
            if own[lane] > 0:
                table = rows[first : first + own[lane]]
                if lane > 0 and shared[begin + lane]:
                    table[:] = rows[first - longest : first - longest + own[lane]]
                else:
                    part = cells[places[p] : places[p + 1]]
                    parts = cell_counts(constants[p], harmonics[p], part)
                    fill_table(constants[p], harmonics[p], part, parts, scratch, table, one_slack)
                for k in range(3):
                    slack[k * LANES + lane] = one_slack[k]
                pack_plain(rows, first, own[lane], plain, lane)
            for n in range(own[lane], longest):
                stand_still(plain, n, lane)
        run_group(
            rows,
            own,
            plain,
            slack,
            group,
            periods,
            detail,
            detect_cycles,
            new_scratch(longest),
            directions,
            states,
            maps,
            growth,
            records,
            status,
        )
    return states, maps, growth, records, status
