"""Speed of the oscillator kernel beside other integrators, in one run: `python benchmarks/kernel.py`.

Workload W: x'' + 0.1 x' + (1 + 0.2 cos w t) f(x) = 0.1 + 0.3 w^2 cos w t, b = 1, at 400 values of w from 0.1 to 1.7,
each from (1.1, 0): 300 periods and 200 more. W+L also measures the growth of a tangent vector. All times are CPU
seconds of one thread, medians of interleaved repeats, without compilation. What takes too long is run on every 20th w
and over fewer periods, and scaled. heyoka is left out where it is not installed.
"""

import argparse
import json
import os
import platform
import subprocess
import sys
import time
from pathlib import Path

for threads in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "NUMBA_NUM_THREADS"):
    os.environ[threads] = "1"
ROOT = Path(__file__).resolve().parents[1]

import numpy as np  # noqa: E402  (the number of threads must be set first)

from gearwear.integrate.status import GROWTH, MAPS, RECORDS, STATES  # noqa: E402
from gearwear.integrate.strobe import GENERAL, strobe  # noqa: E402
from gearwear.integrate.strobe_many import strobe_many  # noqa: E402
from gearwear.motions.settling import Settling, settle_many  # noqa: E402
from gearwear.oscillator.oscillator import Oscillator  # noqa: E402
from gearwear.oscillator.periodic import Harmonics  # noqa: E402

FREQUENCIES = np.linspace(0.1, 1.7, 400)
PERIODS, START = 500, (1.1, 0.0)
REFERENCE = "scipy solve_ivp RK45"
OURS = "affine map, sixteen lanes"


def oscillators(frequencies, error=0.3):
    """Oscillators of W, made anew: what they cache counts."""
    stiffness = Harmonics(1.0, (0.2,), (0.0,))
    return [Oscillator(w, 0.05, 0.1, stiffness, Harmonics(0.0, (error,), (0.0,))) for w in frequencies]


def early(points, periods):
    """All points in one call, each until it recurs."""
    strobe_many(points, START, periods, detail=STATES, detect_cycles=True)


def recorded(points, periods):
    """The same with all that happens within a period."""
    strobe_many(points, START, periods, detail=RECORDS, detect_cycles=True)


def settled(points, periods):
    """All points settled and classified, with 200 sampled periods after the others."""
    settle_many(points, START, Settling(periods - 200, 8 * periods, 200, 32, 1e-7, 3e-3))


def cpu_seconds(task, *arguments):
    """CPU time of this thread."""
    begin = time.thread_time()
    task(*arguments)
    return time.thread_time() - begin


def many(points, periods, detail):
    """All points in one call."""
    strobe_many(points, START, periods, detail=detail)


def each(points, periods, detail, backend="automatic"):
    """One point after the other."""
    for point in points:
        strobe(point, START, periods, detail=detail, backend=backend)


def interleaved(repeats):
    """Seconds of our kernels for W, a list each."""
    tasks = {
        OURS: (many, STATES),
        f"{OURS}, W+L": (many, GROWTH),
        f"{OURS}, tangent maps": (many, MAPS),
        f"{OURS}, extremes too": (many, RECORDS),
        "affine map, scalar": (each, STATES),
        "affine map, scalar, W+L": (each, GROWTH),
    }
    whole = {
        f"{OURS}, cycles detected": early,
        f"{OURS}, extremes too, cycles detected": recorded,
        "settled and classified": settled,
    }
    seconds = {name: [] for name in (*tasks, *whole)}
    settled(oscillators(FREQUENCIES[:20]), 210)
    for task, detail in tasks.values():
        task(oscillators(FREQUENCIES[:20]), 2, detail)
    for _ in range(repeats):
        for name, (task, detail) in tasks.items():
            seconds[name].append(cpu_seconds(task, oscillators(FREQUENCIES), PERIODS, detail))
        for name, run in whole.items():
            seconds[name].append(cpu_seconds(run, oscillators(FREQUENCIES), PERIODS))
    return seconds


def others(repeats, periods):
    """Seconds of the other integrators, scaled to W, a list each."""
    from rivals import heyoka_sweep, scipy_odeint, scipy_solve_ivp

    subset = FREQUENCIES[::20]
    scale = len(FREQUENCIES) / len(subset) * PERIODS / periods
    rivals = {
        REFERENCE: lambda: scipy_solve_ivp(subset, periods, START, "RK45"),
        "scipy solve_ivp DOP853": lambda: scipy_solve_ivp(subset, periods, START, "DOP853"),
        "scipy solve_ivp LSODA": lambda: scipy_solve_ivp(subset, periods, START, "LSODA"),
        "scipy odeint": lambda: scipy_odeint(subset, periods, START),
    }
    seconds = {}
    for name, task in rivals.items():
        seconds[f"{name} rtol 1e-8"] = [scale * cpu_seconds(task) for _ in range(repeats)]
    dense = FREQUENCIES[::10]
    each(oscillators(dense[:1]), 2, STATES, GENERAL)
    seconds["our Dormand-Prince 1e-10"] = [
        10 * cpu_seconds(each, oscillators(dense), PERIODS, STATES, GENERAL) for _ in range(repeats)
    ]
    try:
        sweep = heyoka_sweep(FREQUENCIES, START)
    except ImportError:
        return seconds
    sweep(2)
    seconds["heyoka, batches of 8, corner events"] = [cpu_seconds(sweep, PERIODS) for _ in range(repeats)]
    return seconds


def linearity():
    """Seconds of W with 200 to 3200 points of the same range."""
    table = {}
    for points in (200, 400, 800, 1600, 3200):
        runs = [cpu_seconds(many, oscillators(np.linspace(0.1, 1.7, points)), PERIODS, STATES) for _ in range(3)]
        table[points] = float(np.median(runs))
    return table


def parameter_map():
    """Seconds of a map of 400 frequencies and 100 error amplitudes, row by row."""
    return sum(cpu_seconds(many, oscillators(FREQUENCIES, e), PERIODS, STATES) for e in np.linspace(0.0, 0.6, 100))


def peak_memory():
    """Megabytes that a fresh process uses at most for W and W+L."""
    code = (
        "import kernel; many = kernel.many; points = kernel.oscillators(kernel.FREQUENCIES); "
        "many(points, kernel.PERIODS, kernel.STATES); many(points, kernel.PERIODS, kernel.GROWTH); "
        "print([line for line in open('/proc/self/status') if line.startswith('VmHWM')][0].split()[1])"
    )
    run = [sys.executable, "-c", code]
    return int(subprocess.run(run, cwd=ROOT / "benchmarks", capture_output=True, check=True).stdout) / 1024


def main():
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--rival-repeats", type=int, default=3)
    parser.add_argument("--rival-periods", type=int, default=10, help="of the scipy runs, scaled to 500")
    parser.add_argument("--skip-map", action="store_true", help="leave out the map of 40 000 points")
    chosen = parser.parse_args()
    seconds = interleaved(chosen.repeats)
    memory = peak_memory()
    seconds.update(others(chosen.rival_repeats, chosen.rival_periods))
    medians = {name: float(np.median(values)) for name, values in seconds.items()}
    reference = medians[f"{REFERENCE} rtol 1e-8"]
    print(f"{'method':40s} {'CPU s':>10s} {'least':>10s} {'RK45 / this':>12s} {'this / ours':>12s}")
    for name, median in sorted(medians.items(), key=lambda item: item[1]):
        ratios = f"{reference / median:12.0f} {median / medians[OURS]:12.2f}"
        print(f"{name:40s} {median:10.4f} {min(seconds[name]):10.4f} {ratios}")
    growing = linearity()
    per_point = {points: 1e6 * value / points for points, value in growing.items()}
    print("microseconds a point:", ", ".join(f"{points} points {value:.0f}" for points, value in per_point.items()))
    print(f"peak memory of W and W+L: {memory:.0f} MB")
    result = {"seconds": seconds, "medians": medians, "linearity": growing, "megabytes": memory}
    if not chosen.skip_map:
        result["map"] = parameter_map()
        print(f"map of 400 x 100 points: {result['map']:.1f} s")
    result["machine"] = {"processor": platform.processor() or platform.machine(), "python": platform.python_version()}
    folder = ROOT / "benchmarks" / "results"
    folder.mkdir(exist_ok=True)
    (folder / "kernel.json").write_text(json.dumps(result, indent=1, sort_keys=True) + "\n")


if __name__ == "__main__":
    main()
