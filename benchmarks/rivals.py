"""The workload of kernel.py by scipy and by heyoka, as their users would write it."""

import math

import numpy as np
from scipy.integrate import odeint, solve_ivp


def rates(t, y, w):
    """Right-hand side of W."""
    x, v = y
    f = x - 1.0 if x > 1.0 else (x + 1.0 if x < -1.0 else 0.0)
    return v, 0.1 + 0.3 * w * w * math.cos(w * t) - 0.1 * v - (1.0 + 0.2 * math.cos(w * t)) * f


def scipy_solve_ivp(frequencies, periods, start, method):
    """solve_ivp at rtol 1e-8, atol 1e-10."""
    for w in frequencies:
        times = 2 * np.pi / w * np.arange(periods + 1)
        solve_ivp(rates, (0.0, times[-1]), start, method, t_eval=times, args=(w,), rtol=1e-8, atol=1e-10)


def scipy_odeint(frequencies, periods, start):
    """odeint at rtol 1e-8, atol 1e-10."""
    for w in frequencies:
        times = 2 * np.pi / w * np.arange(periods + 1)
        odeint(rates, start, times, args=(w,), tfirst=True, rtol=1e-8, atol=1e-10, mxstep=100_000)


def heyoka_sweep(frequencies, start, lanes=8):
    """Function of the number of periods that runs all frequencies, in batches; ImportError without heyoka.

    Time is the phase w t, so that all lanes of a batch end their periods together.
    """
    import heyoka as hy

    x, v = hy.make_vars("x", "v")
    w, side = hy.par[0], hy.par[1]
    stiffness = side * side * (1.0 + 0.2 * hy.cos(hy.time))
    force = 0.1 + 0.3 * w * w * hy.cos(hy.time) - 0.1 * v - stiffness * (x - side)

    def change(to):
        def callback(ta, _, lane):
            ta.pars[1, lane] = 0.0 if ta.pars[1, lane] == to else to
            return True

        return callback

    events = [hy.t_event_batch(x - 1.0, callback=change(1.0)), hy.t_event_batch(x + 1.0, callback=change(-1.0))]
    system = [(x, v / w), (v, force / w)]
    ta = hy.taylor_adaptive_batch(system, np.zeros((2, lanes)), pars=np.zeros((2, lanes)), t_events=events)

    def run(periods):
        grid = np.repeat(2 * np.pi * np.arange(periods + 1.0)[:, None], lanes, axis=1)
        for first in range(0, len(frequencies), lanes):
            ta.set_time(0.0)
            ta.state[:] = np.array(start)[:, None]
            ta.pars[0] = frequencies[first : first + lanes]
            ta.pars[1] = 1.0 if start[0] > 1.0 else 0.0
            ta.reset_cooldowns()
            ta.propagate_grid(grid)

    return run
