"""Long wear chains and large maps, planned and run: `python benchmarks/scale.py [chains] [tiles] [maps] [million]`.

`chains`: 500 wear cycles by single links and in blocks. `tiles`: one tile of maps of 1e4, 1e5 and 1e6 points, and what
all would take. `maps`: all of 1e4 and 1e5 points. `million`: all of 1e6 points, with motions of 24 mesh periods after
one, which have not settled, so that the run ends within the hour; its files have the size of any others. Grid and
settling are else those of the smoke settings. Wall and processor seconds are those of snakemake and its jobs together,
memory that of the largest process; plans are medians of repeats.
"""

import argparse
import math
import os
import statistics
import subprocess
import sys
import tempfile
import time
from functools import partial
from pathlib import Path
from typing import NamedTuple

import yaml

ROOT = Path(__file__).resolve().parents[1]
SMOKE = [ROOT / "config" / name for name in ("config.yaml", "smoke.yaml")]
SHORT = {
    "settling": {"transient_periods": 1, "longest_transient": 1, "sampled_periods": 24, "largest_period": 1},
    "dynamics": {"start": {"at": "pair_entry"}},
}
CYCLES, SOME = 500, 10
FIGURE, MADE = "results/figures/map_ste.svg", "results/without/backlash/q000.nc"
STAGES = ("wear", "mesh_stiffness", "transmission_error", "backlash", "response")


class Cost(NamedTuple):
    """Wall and processor seconds, and MB of the largest process."""

    wall: float
    cpu: float
    memory: float


def cost(folder: Path, settings: dict, *arguments: str) -> Cost:
    """Run snakemake with settings over those of the smoke run."""
    folder.mkdir(parents=True, exist_ok=True)
    overlay = folder / "overlay.yaml"
    overlay.write_text(yaml.safe_dump(settings))
    command = [sys.executable, "-m", "snakemake", "-s", ROOT / "Snakefile", "--configfile", *SMOKE, overlay, *arguments]
    with open(folder / "printed.txt", "w") as printed:
        begin = time.perf_counter()
        run = subprocess.Popen(list(map(str, command)), cwd=folder, stdout=printed, stderr=subprocess.STDOUT)
        _, status, used = os.wait4(run.pid, 0)
        wall = time.perf_counter() - begin
        run.returncode = os.waitstatus_to_exitcode(status)
    if run.returncode:
        raise SystemExit((folder / "printed.txt").read_text()[-3000:])
    return Cost(wall, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024)


def chain_of(cycles: int, block: int) -> dict:
    """Settings of a chain of so many cycles of 2e7 revolutions, in blocks."""
    others = {name: {"running_cycles": 0} for name in ("wear_only", "n0700_t060", "n1400_t080")}
    cases = others | {"with": {"running_cycles": cycles * 20_000_000}}
    return {"jobs": {"wear_cycles": block}, "wear": {"cycles_per_update": 20_000_000}, "cases": cases}


def chains(folder: Path, repeats: int) -> None:
    plans = [(cycles, block) for block in (1, 25, 50) for cycles in (CYCLES // 4, CYCLES // 2, CYCLES)]
    found: dict[tuple[int, int], list[Cost]] = {plan: [] for plan in plans}
    for _ in range(repeats):
        for cycles, block in plans:
            target = f"results/with/response/q{cycles:03d}.nc"
            found[cycles, block].append(cost(folder / "plan", chain_of(cycles, block), "-n", "--", target))
    for (cycles, block), several in found.items():
        wall, cpu, memory = (statistics.median(column) for column in zip(*several, strict=True))
        print(f"plan {cycles} cycles, {block} a job: {wall:.1f} s, cpu {cpu:.1f} s, {memory:.0f} MB", flush=True)
    for block, cycles in ((1, SOME), (25, 50), (50, CYCLES)):
        place, settings = folder / f"chain{block}", chain_of(CYCLES, block)
        cost(place, settings, "-j1", "--", "results/with/response/q000.nc")
        used = cost(place, settings, "-j1", "--", f"results/with/response/q{cycles:03d}.nc")
        print(
            f"run {cycles} cycles, {block} a job: {used.wall / cycles:.2f} s a cycle, cpu {used.cpu / cycles:.2f} s, "
            f"{used.memory:.0f} MB; {used.wall:.0f} s with planning",
            flush=True,
        )
    files = [f"results/with/{stage}/q{cycle:03d}.nc" for stage in STAGES for cycle in range(SOME + 1)]
    same = [len({(folder / f"chain{block}" / file).read_bytes() for block in (1, 25, 50)}) == 1 for file in files]
    print(f"{sum(same)} of {len(files)} files have the same bytes in all three", flush=True)


def planned(folder: Path, side: int, settings: dict, repeats: int) -> dict:
    """Plan a map of side x side points and return its settings."""
    settings = settings | {"maps": {"case": "without", "mesh_frequency": {"points": side}, "ste": {"points": side}}}
    plans = [cost(folder, settings, "-n", "--", FIGURE) for _ in range(repeats)]
    wall, cpu, memory = (statistics.median(column) for column in zip(*plans, strict=True))
    print(f"plan {side} x {side} points: {wall:.1f} s, cpu {cpu:.1f} s, {memory:.0f} MB", flush=True)
    cost(folder, settings, "-j2", "--", MADE)
    return settings


def tiles(folder: Path, repeats: int) -> None:
    for side in (100, 316, 1000):
        settings, parts = planned(folder, side, {}, repeats), max(16, math.ceil(side**2 / 5000))
        tile = f"results/without/maps/tiles/ste/{parts // 2}-of-{parts}.nc"
        none = cost(folder, settings, "-n", "--", tile)
        used = cost(folder, settings, "-j1", "--", tile)
        each = used.cpu - none.cpu
        print(
            f"  one of {parts} tiles: cpu {each:.1f} s, {1000 * each * parts / side**2:.2f} ms a point, "
            f"{used.memory:.0f} MB; all: cpu {parts * each:.0f} s",
            flush=True,
        )


def maps(folder: Path, repeats: int, sides: tuple[int, ...], settings: dict) -> None:
    for side in sides:
        place = folder / f"map{side}"
        own = planned(place, side, settings, repeats)
        for name, end in (("tiles", ("--until", "map_tile")), ("gather", ("--until", "map")), ("figure", ())):
            used = cost(place, own, "-j2", *end, "--", FIGURE)
            share = f", {1000 * used.cpu / side**2:.2f} ms a point" if name == "tiles" else ""
            print(f"  {name}: {used.wall:.1f} s, cpu {used.cpu:.1f} s{share}, {used.memory:.0f} MB", flush=True)


PARTS = {
    "chains": chains,
    "tiles": tiles,
    "maps": partial(maps, sides=(100, 316), settings={}),
    "million": partial(maps, sides=(1000,), settings=SHORT),
}


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "parts", nargs="*", metavar="PART", help=f"of {', '.join(PARTS)}; the first two if none is named"
    )
    parser.add_argument("--repeats", type=int, default=3)
    options = parser.parse_args()
    for part in options.parts or ("chains", "tiles"):
        with tempfile.TemporaryDirectory() as name:
            PARTS[part](Path(name), options.repeats)
