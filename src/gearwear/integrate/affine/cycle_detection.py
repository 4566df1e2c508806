"""Stopping a motion whose section recurs to the last bit: the map of a period has no memory, so the rest is known."""

from gearwear.integrate.compiled import njit_noalloc
from gearwear.integrate.status import MAPS, RECORDS
from gearwear.integrate.tangent import growth_of


@njit_noalloc
def fill_if_recurring(reached, detail, direction, states, maps, growth, records):
    """Fill in what comes after state ``reached`` if that is, to the last bit, an earlier one.

    It is compared with the last one before whose number is a power of two (Brent's search for cycles). The tangent
    vector goes on through the maps of the cycle, so that its growth is that of the periods filled in; without maps
    there is none. Arguments as in affine_flow.run.
    """
    mark = 1
    while 2 * mark < reached:
        mark *= 2
    if reached == mark or states[mark, 0] != states[reached, 0] or states[mark, 1] != states[reached, 1]:
        return False
    for i in range(reached, states.shape[0] - 1):
        same = i - reached + mark
        states[i + 1, 0], states[i + 1, 1] = states[same + 1, 0], states[same + 1, 1]
        if detail >= MAPS:
            a, b, c, d = maps[same, 0, 0], maps[same, 0, 1], maps[same, 1, 0], maps[same, 1, 1]
            maps[i, 0, 0], maps[i, 0, 1], maps[i, 1, 0], maps[i, 1, 1] = a, b, c, d
            growth[i] = growth_of(direction, a * direction[0] + b * direction[1], c * direction[0] + d * direction[1])
        if detail == RECORDS:
            for column in range(records.shape[1]):
                records[i, column] = records[same, column]
    return True
