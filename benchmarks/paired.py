"""Two checkouts side by side: `python benchmarks/paired.py OTHER [--runs N] [TARGET ...]`.

Each checkout, this one and OTHER, computes the targets from nothing with its own .venv, on two cores, in a temporary
folder, in turn. Wall and processor seconds of whole processes; only the ratios within one run count. Let each checkout
compute the targets once before, so that no kernel is compiled.
"""

from __future__ import annotations

import argparse
import resource
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parents[1]


def measured(checkout: Path, targets: list[str]) -> tuple[float, float]:
    """Return wall and processor seconds of the targets, computed from nothing."""
    with tempfile.TemporaryDirectory() as folder:
        command = [checkout / ".venv/bin/python", "-m", "snakemake", "-j2", *targets, "--directory", folder]
        before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        run = subprocess.run(list(map(str, command)), cwd=checkout, capture_output=True, text=True)
        wall, after = time.perf_counter() - begin, resource.getrusage(resource.RUSAGE_CHILDREN)
    if run.returncode:
        raise SystemExit(f"{checkout}: failed\n{run.stdout[-2000:]}{run.stderr[-2000:]}")
    return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("other", type=Path)
    parser.add_argument("targets", nargs="*", default=["all"])
    parser.add_argument("--runs", type=int, default=1)
    options = parser.parse_args()
    checkouts = {"other": options.other.resolve(), "this": HERE}
    found: dict[str, list[tuple[float, float]]] = {name: [] for name in checkouts}
    for _ in range(options.runs):
        for name, checkout in checkouts.items():
            found[name].append(measured(checkout, options.targets))
            print(f"{name:6} wall {found[name][-1][0]:7.1f} s   processor {found[name][-1][1]:7.1f} s", flush=True)
    for place, kind in enumerate(("wall", "processor")):
        ratios = [this[place] / other[place] for this, other in zip(found["this"], found["other"], strict=True)]
        print(f"{kind}: this / other {statistics.median(ratios):.2f}  ({min(ratios):.2f} to {max(ratios):.2f})")


if __name__ == "__main__":
    main()
