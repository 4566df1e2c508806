"""Power series in u from 0 to 1, and where one that begins at or above zero falls below it."""

import numpy as np

from gearwear.integrate.compiled import njit

DEGREE = 20
TERMS = DEGREE + 1
NONE = 2.0  # a place beyond the end
_LEAST_WIDTH = 2**20  # parts of the step; a touch within one of them is too shallow to be a crossing


@njit
def value(series, u):
    """Value of a series."""
    total = 0.0
    for n in range(DEGREE, -1, -1):
        total = total * u + series[n]
    return total


@njit
def slope(series, u):
    """Derivative of a series by u."""
    total = 0.0
    for n in range(DEGREE, 0, -1):
        total = total * u + n * series[n]
    return total


@njit
def shift(series, start, width, out):
    """Write to out the series in w with u = start + width w."""
    for n in range(TERMS):
        out[n] = series[n]
    if start != 0.0:
        for i in range(DEGREE):
            for n in range(DEGREE - 1, i - 1, -1):
                out[n] += start * out[n + 1]
    power = 1.0
    for n in range(TERMS):
        out[n] *= power
        power *= width


@njit
def crossing(series, low, high):
    """Root between two places where a series falls and has a sign each, to round-off: Newton's method in a bracket."""
    u = high
    for _ in range(100):
        at, rate = value(series, u), slope(series, u)
        if at == 0.0:
            return u
        if at > 0.0:
            low = u
        else:
            high = u
        following = u - at / rate if rate < 0.0 else -1.0
        if not low < following < high:
            following = 0.5 * (low + high)
        if following in (low, high) or abs(following - u) < 1e-16:
            return following
        u = following
    return u


@njit
def first_fall(series, scratch):
    """First place in (0, 1] where a series that begins at zero or above falls below, NONE without one.

    The interval is halved until a piece is positive throughout or monotone, by the moduli of its coefficients.
    """
    rest = 0.0
    for n in range(1, TERMS):
        rest += abs(series[n])
    if series[0] > rest:
        return NONE
    place, parts = 0, 1  # of the piece: it begins at place / parts and is 1 / parts wide
    while place < parts:
        half = 0.5 / parts
        shift(series, (2 * place + 1) * half, half, scratch)
        rest, bend = 0.0, 0.0
        for n in range(1, TERMS):
            rest += abs(scratch[n])
            if n > 1:
                bend += n * abs(scratch[n])
        if scratch[0] <= rest:
            if abs(scratch[1]) <= bend and parts < _LEAST_WIDTH:
                place, parts = 2 * place, 2 * parts
                continue
            low, high = place / parts, (place + 1) / parts
            if value(series, high) < 0.0:
                return crossing(series, low, high)
        place += 1
        while place % 2 == 0 and parts > 1:
            place, parts = place // 2, parts // 2
    return NONE


@njit
def extreme(series, sign, end):
    """Largest (sign 1) or least (sign -1) value of a series over [0, end], with one turn inside at most."""
    first, last = value(series, 0.0), value(series, end)
    found = max(sign * first, sign * last)
    if sign * slope(series, 0.0) > 0.0 and sign * slope(series, end) < 0.0:
        low, high, u = 0.0, end, 0.5 * end
        for _ in range(60):
            if sign * slope(series, u) > 0.0:
                low = u
            else:
                high = u
            if high - low < 1e-9:
                break
            u = 0.5 * (low + high)
        found = max(found, sign * value(series, u))
    return sign * found


def waves(length: float, count: int) -> np.ndarray:
    """(count, TERMS) complex series of exp(i j length u), j = 1 to count."""
    order = np.arange(1, count + 1)[:, None]
    steps = 1j * order * length / np.arange(1, TERMS)
    return np.cumprod(np.concatenate([np.ones((count, 1)), steps], axis=1), axis=1)
