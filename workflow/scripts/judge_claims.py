"""The statements of the reference paper, held against the computed arrays."""

from pathlib import Path
from typing import TYPE_CHECKING

import yaml

from gearwear.claims import scorecard
from gearwear.io import store, tables
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


class Results(dict):
    """Result files by stage, case and wear cycle, read once, when they are asked for."""

    def __getitem__(self, key):
        found = super().__getitem__(key)
        if isinstance(found, str):
            self[key] = found = store.load(found)
        return found


def key_of(path: str):
    """Return the key of a result file: results/CASE/STAGE/qNNN.nc, results/CASE/sweeps/ORDER/NAME.nc and the like."""
    *_, before, case, folder, name = ("", "", "", *Path(path).with_suffix("").parts)
    if case == "sweeps":
        return "sweep", before, name
    if name.startswith("q") and name[1:].isdigit():
        return folder, case, int(name[1:])
    return name if folder == "results" else (name, folder)


def main(job):
    claims = yaml.safe_load(Path(job.input.claims).read_text())
    results = Results({key_of(path): str(path) for path in job.input.results})
    diagonal = [(state["case"], state["cycle"]) for state in job.params.cfg["states"]]
    rows = scorecard.evaluate(claims, results, diagonal)
    tables.write_rows(rows, job.output[0])
    stage.announce(f"Claims of the paper: {scorecard.summary(rows)}.")


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
