"""The oscillator with backlash by heyoka (Taylor series, corners as terminal events): an independent second opinion.

`python benchmarks/heyoka_oracle.py` writes the reference of tests/unit/integrate/test_affine_flow.py anew, in
80-bit arithmetic. It needs heyoka (`.venv/bin/pip install heyoka`), which the project itself does not.
"""

from pathlib import Path

import heyoka as hy
import numpy as np

REFERENCE = Path(__file__).parents[1] / "tests" / "unit" / "integrate" / "affine_reference.npz"
PARAMETERS = ("frequency", "damping_ratio", "mean_force", "stiffness", "error", "phase", "clearance")
PERIODS = 10


def equation(waves=1):
    """Equation of motion and its variables, for one harmonic of stiffness and error; the last par is the branch.

    x'' + 2 zeta x' + |side| (1 + kappa cos w t) (x - side b) = F + e w^2 cos(w t + phi)
    """
    x, v = hy.make_vars("x", "v")
    w, z, force, kappa, error, phase, b, side = (hy.par[i] for i in range(8))
    stiffness = 1.0 + kappa * hy.cos(w * hy.time)
    drive = force + error * w * w * hy.cos(w * hy.time + phase)
    contact = side * side
    return x, v, b, [(x, v), (v, drive - 2.0 * z * v - contact * stiffness * (x - side * b))]


def sides(x, b):
    """Branch of displacements."""
    return np.where(x > b, 1.0, np.where(x < -b, -1.0, 0.0))


def integrator(kind=np.longdouble):
    """Scalar integrator that changes its branch at the corners."""
    x, _, b, system = equation()

    def change(side):
        def callback(ta, _):
            ta.pars[7] = kind(0 if ta.pars[7] == side else side)
            return True

        return callback

    events = [hy.t_event(x - b, callback=change(1), fp_type=kind), hy.t_event(x + b, callback=change(-1), fp_type=kind)]
    return hy.taylor_adaptive(system, np.zeros(2, kind), pars=np.zeros(8, kind), t_events=events, fp_type=kind)


def sections(ta, parameters, start, periods, kind=np.longdouble):
    """(periods + 1, 2) states at mesh phase 0."""
    ta.time = kind(0)
    ta.pars[:7] = np.array(parameters, kind)
    ta.state[:] = np.array(start, kind)
    ta.pars[7] = kind(sides(start[0], parameters[6]))
    ta.reset_cooldowns()
    period = (
        2 * np.pi / kind(parameters[0]) if kind is float else 2 * kind("3.14159265358979323846") / kind(parameters[0])
    )
    states = np.empty((periods + 1, 2))
    states[0] = start
    for i in range(1, periods + 1):
        ta.propagate_until(i * period)
        states[i] = ta.state
    return states


def sweep_points():
    """Parameters and starts of the 400 points of a sweep with 147 chaotic ones."""
    frequency = np.linspace(0.1, 1.7, 400)
    return [((w, 0.05, 0.1, 0.2, 0.3, 0.0, 1.0), (1.1, 0.0)) for w in frequency]


def random_points(count=320):
    """Random parameters, clearances from 1 down to 0.001, and starts."""
    random = np.random.default_rng(20)
    points = []
    for i in range(count):
        low, high = np.array([[0.1, 0.01, -0.3, 0.0, 0.0, 0.0], [2.2, 0.1, 0.5, 0.4, 0.6, 6.28]])
        clearance = (1.0, 0.1, 0.01, 0.001)[i % 4]
        points.append(((*random.uniform(low, high), clearance), tuple(random.uniform(-1.5, 1.5, 2))))
    return points


if __name__ == "__main__":
    ta = integrator()
    result = {}
    for name, points in (("sweep", sweep_points()), ("random", random_points())):
        result[f"{name}_parameters"] = np.array([parameters for parameters, _ in points])
        result[f"{name}_states"] = np.array([sections(ta, *point, PERIODS) for point in points])
    np.savez_compressed(REFERENCE, **result)
    print(REFERENCE, REFERENCE.stat().st_size)
