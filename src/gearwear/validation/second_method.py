"""Special points of periodic orbits by an eighth-order integrator with events, apart from the kernel and its analysis.

Dormand and Prince's method of order 8 (scipy) on each branch of the backlash function, restarted where a corner is
met; Newton's method on orbit and special point at once.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import root

FOLD, DOUBLING = 1.0, -1.0  # multiplier at the special point


def special_frequency(system: dict[str, Any], period: int, multiplier: float, frequency: float, state: Any) -> float:
    """Return the frequency where an orbit has a multiplier 1 or -1.

    Parameters
    ----------
    system : damping_ratio, mean_force, stiffness, error as in `oscillator.oscillator_of`.
    period : of the orbit, mesh periods.
    frequency, state : where to begin; (2,) displacement and velocity at mesh phase 0.

    Raises
    ------
    ValueError : no such orbit nearby.
    """

    def conditions(unknown: np.ndarray) -> list[Any]:
        after, matrix = _run(system, unknown[2], unknown[:2], period)
        return [*(after - unknown[:2]), np.linalg.det(matrix - multiplier * np.eye(2))]

    found = root(conditions, [*state, frequency], tol=1e-12)
    if np.abs(found.fun).max() > 1e-9:
        raise ValueError(f"no orbit of period {period} with a multiplier {multiplier:g} next to {frequency}")
    return float(found.x[2])


def _run(system: dict[str, Any], frequency: float, state: Any, periods: int) -> Any:
    """Return state and monodromy matrix after some forcing periods."""
    orders = frequency * np.arange(1, 1 + max(len(system["stiffness"]), len(system["error"])))
    k, e = (np.zeros(len(orders)) for _ in range(2))
    k[: len(system["stiffness"])], e[: len(system["error"])] = system["stiffness"], system["error"]

    def rate(t: float, y: np.ndarray, side: float) -> np.ndarray:
        wave = np.cos(orders * t)
        stiffness = abs(side) * (1 + k @ wave)
        matrix = np.array([[0.0, 1.0], [-stiffness, -2 * system["damping_ratio"]]])
        force = system["mean_force"] + (e * orders**2) @ wave + stiffness * side
        return np.concatenate([matrix @ y[:2] + [0.0, force], (matrix @ y[2:].reshape(2, 2)).ravel()])

    t, end, y = 0.0, 2 * np.pi * periods / frequency, np.array([*state, 1.0, 0.0, 0.0, 1.0])
    side = float(np.sign(y[0])) if abs(y[0]) > 1 else 0.0
    while t < end:
        ways = [_corner(side, -side)] if side else [_corner(1.0, 1.0), _corner(-1.0, -1.0)]
        part = solve_ivp(rate, (t, end), y, "DOP853", events=ways, args=(side,), rtol=1e-12, atol=1e-14)
        t, y = part.t[-1], part.y[:, -1]
        if part.status == 1:
            y[0] = corner = float(np.sign(y[0]))
            side = 0.0 if side else corner
    return y[:2], y[2:].reshape(2, 2)


def _corner(position: float, direction: float) -> Any:
    """Return the event that the displacement passes `position` in a direction; a start on it is none."""

    def distance(t: float, y: np.ndarray, side: float) -> np.ndarray:
        return y[0] - position

    vars(distance).update(terminal=True, direction=direction)
    return distance
