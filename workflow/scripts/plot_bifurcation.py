"""Figures 12, 15, 17: sections, motion classes and largest Lyapunov exponents along a sweep."""

from pathlib import Path
from typing import TYPE_CHECKING

import yaml

from gearwear.drawing import bifurcation
from gearwear.drawing.sheet import DOUBLE, sheet
from gearwear.plumbing import stage, store

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def windows(claims, sweep, case):
    """Return (first, last, class) of the windows of motion that the paper names."""
    for claim in claims:
        cases = claim.get("case", [])
        if claim["kind"] == "window" and claim["sweep"] == sweep and case in ([cases] if cases == case else cases):
            yield *claim["range"], claim["class"][0]


def main(job):
    cfg = job.params.cfg
    claims = yaml.safe_load(Path(job.input.claims).read_text())["claims"]
    sweeps = [store.load(path) for path in job.input.sweep]
    paper = [list(windows(claims, cfg["sweep"], state["case"])) for state in cfg["states"]]
    with sheet(job, DOUBLE, bifurcation.height(len(sweeps)), layout=None) as figure:
        bifurcation.draw(figure, sweeps, paper, cfg)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
