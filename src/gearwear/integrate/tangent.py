"""The growth of a tangent vector over a period."""

import math

from gearwear.integrate.compiled import njit_inline


@njit_inline
def growth_of(direction, p, q):
    """Logarithm of the length of (p, q), what has become of a tangent vector of length 1; the vector is made it."""
    square = p * p + q * q
    share = 1.0 / math.sqrt(square)
    direction[0], direction[1] = p * share, q * share
    return 0.5 * math.log(square)
