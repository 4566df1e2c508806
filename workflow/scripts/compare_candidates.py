"""The best candidates of all searches computed in full, and the tables of parameters and claims."""

from typing import TYPE_CHECKING

import yaml

from gearwear.calibration import table
from gearwear.calibration.verdict import compared
from gearwear.io import store
from gearwear.io.tables import write_rows
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    with open(job.input.claims, encoding="utf-8") as file:
        claims = yaml.safe_load(file)["claims"]
    found = compared(job.params.cfg, claims, [store.load(path) for path in job.input.searches])
    store.save(found, job)
    written = {
        job.output.parameters: table.parameters(found, job.params.cfg["calibration"]),
        job.output.claims: table.claims(found, claims),
    }
    for path, rows in written.items():
        write_rows(rows, path)
    for name, row in zip(found["member"].values, found["member_agrees"].values, strict=True):
        stage.announce(f"{name}: agrees with {row.sum()} of {row.size} claims about states and motion")


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
