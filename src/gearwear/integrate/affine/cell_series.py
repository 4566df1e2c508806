"""Power series of the linear motion inside one cell of the forcing period.

On a branch the oscillator is linear. About the middle of a cell of half width H, in s = (t - t_middle) / H from -1
to 1,

    x(s) = P(s) x_m + Q(s) v_m + R_F(s) + side R_b(s),

(x_m, v_m) the state that the branch has in the middle, side 1, 0, -1 the branch (contact, free, contact on the back
flank). P and Q solve the homogeneous equation, R_F answers the external force and R_b the shift k b of the contact.
"""

import math

from gearwear.integrate.compiled import njit_noalloc

DEGREE = 14
TERMS = 16  # coefficients kept, the last one zero: a multiple of the width of vector registers
P, Q, R_FORCE, R_CLEARANCE = range(4)


@njit_noalloc
def add_wave(series, start, cosine, sine, angle, turn):
    """Add the Taylor coefficients of cosine cos(angle + turn s) + sine sin(angle + turn s) to series[start:]."""
    c, s = math.cos(angle), math.sin(angle)
    even, odd = cosine * c + sine * s, sine * c - cosine * s
    power = 1.0
    for n in range(DEGREE + 1):
        series[start + n] += (even if n % 2 == 0 else odd) * power
        power *= turn / (n + 1)
        if n % 2 == 1:
            power = -power


@njit_noalloc
def fundamental_series(waves, in_contact, half_width, friction, stiffness, force, shift, clearance, steady):
    """Write the coefficients of P, then Q, R_F and R_b of a cell, TERMS of each.

    Power series of x'' + c x' + k x = F + side k b, term by term: with H the half width,
    (j + 1)(j + 2) x_{j+2} = H^2 (G_j - sum_i k_i x_{j-i}) - c H (j + 1) x_{j+1}.

    Parameters
    ----------
    waves : (4 TERMS,) where they go
    in_contact : False without contact, k = 0
    clearance, steady : b in the middle, and whether it stays; then R_b = b (1 - P), with k b in proportion to k
    stiffness, force, shift : (TERMS,) Taylor coefficients in s of k, F and k b
    """
    square, damping = half_width * half_width, friction * half_width
    for n in range(4 * TERMS):
        waves[n] = 0.0
    p, q, f, b = waves[:TERMS], waves[TERMS : 2 * TERMS], waves[2 * TERMS : 3 * TERMS], waves[3 * TERMS :]
    p[0], q[1] = 1.0, half_width
    for j in range(DEGREE - 1):
        new_p, new_q, new_f, new_b = 0.0, 0.0, force[j], 0.0
        if in_contact:
            for i in range(j + 1):
                new_p -= stiffness[i] * p[j - i]
                new_q -= stiffness[i] * q[j - i]
                new_f -= stiffness[i] * f[j - i]
            if not steady:
                new_b = shift[j]
                for i in range(j + 1):
                    new_b -= stiffness[i] * b[j - i]
        share, drag = 1.0 / ((j + 1) * (j + 2)), damping * (j + 1)
        p[j + 2] = (square * new_p - drag * p[j + 1]) * share
        q[j + 2] = (square * new_q - drag * q[j + 1]) * share
        f[j + 2] = (square * new_f - drag * f[j + 1]) * share
        b[j + 2] = (square * new_b - drag * b[j + 1]) * share
    if in_contact and steady:
        for j in range(2, DEGREE + 1):
            b[j] = -clearance * p[j]


@njit_noalloc
def product_series(first, second, result):
    """Taylor coefficients, up to the degree kept, of the product of two series."""
    for n in range(DEGREE + 1):
        total = 0.0
        for i in range(n + 1):
            total += first[i] * second[n - i]
        result[n] = total


@njit_noalloc
def values_at_ends(series, start):
    """Sum of a series and of its slope at s = -1, then at s = 1; the smallest terms first."""
    even, odd, even_slope, odd_slope = 0.0, 0.0, 0.0, 0.0
    for n in range(DEGREE, -1, -2):
        even += series[start + n]
        odd_slope += n * series[start + n]
        odd += series[start + n + 1]
        even_slope += (n + 1) * series[start + n + 1]
    return even - odd, even_slope - odd_slope, even + odd, even_slope + odd_slope


@njit_noalloc
def fourth_derivative_bound(series, start):
    """Bound of the fourth derivative over s in [-1, 1]: the sum of the moduli of its coefficients."""
    bound = 0.0
    for n in range(4, DEGREE + 1):
        bound += n * (n - 1) * (n - 2) * (n - 3) * abs(series[start + n])
    return bound
