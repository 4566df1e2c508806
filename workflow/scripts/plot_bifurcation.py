"""Figures 12, 15, 17: sections, periodic orbits, motion classes and largest Lyapunov exponents along a sweep."""

from pathlib import Path
from typing import TYPE_CHECKING

import xarray as xr
import yaml

from gearwear.figures import bifurcation
from gearwear.figures.sheet import DOUBLE, sheet
from gearwear.io import store
from gearwear.orbits.branch_variables import columns
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

ORDERS = ("restart", "up", "down")


def windows(claims, sweep, case):
    """Return (first, last, class) of the windows of motion that the paper names."""
    for claim in claims:
        if claim["kind"] != "window" or claim["sweep"] != sweep:
            continue
        if case in ([claim["case"]] if isinstance(claim["case"], str) else claim["case"]):
            yield *claim["range"], claim["class"][0]


def main(job):
    cfg = job.params.cfg
    claims = [claim for path in job.input.claims for claim in yaml.safe_load(Path(path).read_text())["claims"]]
    files = (job.input[order] for order in ORDERS)
    sweeps = [dict(zip(ORDERS, map(store.load, paths), strict=True)) for paths in zip(*files, strict=True)]
    orbits = [store.load(path) for path in job.input.branches]
    orbits = orbits or [xr.Dataset(columns([], 1, cfg["sweep"]))] * len(sweeps)
    paper = [list(windows(claims, cfg["sweep"], state["case"])) for state in cfg["states"]]
    with sheet(job, DOUBLE, bifurcation.height(len(sweeps)), layout=None) as figure:
        bifurcation.draw(figure, sweeps, orbits, paper, cfg)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
