"""Stopping a motion whose section recurs to the last bit."""

from gearwear.dynamics.compiled import borrowing


@borrowing
def fill_if_recurring(states, reached):
    """Fill in the states after ``reached`` if that one is, to the last bit, an earlier one: the map has no memory.

    It is compared with the last one before whose number is a power of two (Brent's search for cycles).
    """
    mark = 1
    while 2 * mark < reached:
        mark *= 2
    if reached == mark or states[mark, 0] != states[reached, 0] or states[mark, 1] != states[reached, 1]:
        return False
    for i in range(reached + 1, states.shape[0]):
        states[i, 0], states[i, 1] = states[i - reached + mark, 0], states[i - reached + mark, 1]
    return True
