"""What the jobs of a run cost, rule by rule: the slowest and the largest job, from the files below results/benchmarks.

    python benchmarks/costs.py [FOLDER...]    folders that hold results/, this one if none is named

The resources in profiles/slurm/config.yaml come from this table; docs/how-to/cluster.md says how.
"""

import csv
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
RULE = re.compile(r'^(?:rule |    rule:\s+name:\s+f")(\w+).*?\n(.*?)(?=^\S|\Z)', flags=re.MULTILINE | re.DOTALL)


def patterns() -> dict[str, re.Pattern]:
    """The benchmark files of every rule, as the rule files name them."""
    found = {}
    for file in sorted((ROOT / "workflow" / "rules").glob("*.smk")):
        for rule, body in RULE.findall(file.read_text()):
            if named := re.search(r'benchmark:\s+f?"([^"]+)"', body):
                parts = [
                    ".*" if part == "root" else "[^/]+" if index % 2 else re.escape(part)
                    for index, part in enumerate(re.split(r"{+(\w+)[^}]*}+", named[1]))
                ]
                found[rule.rstrip("_")] = re.compile("".join(parts))
    return found


def costs(folders: list[Path]) -> dict[str, list[tuple[float, float, float]]]:
    """Processor time (s), wall time (s) and resident memory (MB) of every job, by rule."""
    rules = patterns()
    found: dict[str, list[tuple[float, float, float]]] = {}
    for folder in folders:
        for file in sorted((folder / "results" / "benchmarks").rglob("*.tsv")):
            name = file.relative_to(folder).as_posix()
            rule = next((rule for rule, pattern in rules.items() if pattern.fullmatch(name)), None)
            with open(file, newline="") as table:
                for row in csv.DictReader(table, delimiter="\t"):
                    values = [row[key] for key in ("cpu_time", "s", "max_rss")]
                    if rule and all(re.fullmatch(r"[\d.]+", value) for value in values):
                        found.setdefault(rule, []).append(tuple(map(float, values)))
    return found


def main() -> None:
    table = costs([Path(name) for name in sys.argv[1:]] or [Path()])
    print(f"{'rule':26}{'jobs':>6}{'cpu s':>9}{'wall s':>9}{'MB':>7}   largest of all jobs; cpu of all")
    for rule, jobs in sorted(table.items()):
        cpu, wall, memory = (max(column) for column in zip(*jobs, strict=True))
        print(f"{rule:26}{len(jobs):6}{cpu:9.1f}{wall:9.1f}{memory:7.0f}   {sum(job[0] for job in jobs):9.1f}")


if __name__ == "__main__":
    main()
