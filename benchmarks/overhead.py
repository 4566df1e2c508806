"""What the workflow costs beside its work, in one run: `python benchmarks/overhead.py`.

Start-up of the lightest stage jobs over a bare Python; an up-to-date `snakemake all` over a Snakefile with as many
trivial jobs; the share of a run outside the processes of the jobs. All of it on the smoke settings in a temporary
folder, in wall seconds, medians of interleaved repeats: only ratios and differences within one run count.
"""

import argparse
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SMOKE = [ROOT / "config" / name for name in ("config.yaml", "smoke.yaml")]
CORES = 2
TRIVIAL = """
rule all:
    input: expand("out/{{i}}.txt", i=range({count}))

rule one:
    output: "out/{{i}}.txt"
    log: "logs/{{i}}.log"
    params: cfg={{"a": 1.0}}, code="0123456789abcdef"
    shell: "echo {{wildcards.i}} > {{output}} 2> {{log}}"
"""


def seconds(*command, cwd) -> float:
    """Return the wall seconds of a command that must succeed."""
    begin = time.perf_counter()
    run = subprocess.run([str(part) for part in command], cwd=cwd, capture_output=True, text=True)
    if run.returncode:
        raise SystemExit(f"{' '.join(map(str, command))} failed:\n{run.stdout[-3000:]}{run.stderr[-3000:]}")
    return time.perf_counter() - begin


def snakemake(*arguments):
    """Return the command line of this environment's snakemake."""
    return [sys.executable, "-m", "snakemake", f"-j{CORES}", *arguments]


def job_times(folder: Path) -> list[float]:
    """Return the wall seconds of every job, from the benchmark files."""
    return [float(path.read_text().splitlines()[1].split("\t")[0]) for path in folder.rglob("*.tsv")]


def main(repeats: int) -> None:
    study = snakemake("all", "-s", ROOT / "Snakefile", "--configfile", *SMOKE)
    with tempfile.TemporaryDirectory() as name:
        ours, plain = Path(name, "study"), Path(name, "trivial")
        for folder in (ours, plain):
            folder.mkdir()
        warm = seconds(*study, cwd=ours)  # compiles the kernels
        shutil.rmtree(ours / "results")
        whole = seconds(*study, cwd=ours)
        times = job_times(ours / "results" / "benchmarks")
        (plain / "Snakefile").write_text(TRIVIAL.format(count=len(times)))
        trivial = [*snakemake(), "all"]
        seconds(*trivial, cwd=plain)
        pairs = [(seconds(*study, cwd=ours), seconds(*trivial, cwd=plain)) for _ in range(repeats)]
        bare, libraries = (
            statistics.median(seconds(sys.executable, "-c", code, cwd=plain) for _ in range(9))
            for code in ("pass", "from snakemake import script; import xarray, netCDF4")
        )
    light = statistics.median(sorted(times)[: max(len(times) // 4, 1)])
    ratio = statistics.median(a / b for a, b in pairs)
    print(
        f"a run of {len(times)} jobs on {CORES} processors: {whole:.1f} s ({warm:.1f} s when the kernels are compiled)"
    )
    print(f"lightest quarter of the jobs: {light:.2f} s a job, {light - bare:.2f} s over a bare Python ({bare:.2f} s)")
    print(f"the imports of any job with Snakemake and xarray alone: {libraries - bare:.2f} s over a bare Python")
    print(f"nothing to do: {pairs[0][0]:.1f} s, {ratio:.2f} times {len(times)} trivial jobs ({pairs[0][1]:.1f} s)")
    print(f"neither import nor computation: {100 * (1 - sum(times) / (CORES * whole)):.0f} % of the processors' time")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--repeats", type=int, default=3)
    main(parser.parse_args().repeats)
