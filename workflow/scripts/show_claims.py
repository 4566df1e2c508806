"""The scorecard of the claims as a page that needs no other file."""

import csv
from pathlib import Path
from typing import TYPE_CHECKING

import yaml

from gearwear.figures import scorecard
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    claims = yaml.safe_load(Path(job.input.claims).read_text())["claims"]
    with open(job.input.scorecard, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    sweeps = {(path.parts[-4], path.stem): store.load(path) for path in map(Path, job.input.sweeps)}
    page = scorecard.page(Path(job.input.template).read_text(encoding="utf-8"), rows, claims, sweeps)
    with store.atomic(job.output[0]) as temporary:
        Path(temporary).write_text(page, encoding="utf-8")


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
