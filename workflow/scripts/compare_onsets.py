"""The shift of the onsets from case `without` to case `with`: numerical error, ensemble, one table."""

from typing import TYPE_CHECKING

from gearwear.config import ensemble
from gearwear.io import store, tables
from gearwear.onsets import table
from gearwear.onsets.shifts import CASES, shifts
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    cfg = job.params.cfg
    factors = ensemble.factors(cfg["onsets"])
    onsets, variants = (
        {case: store.load(path) for case, path in zip(CASES, paths, strict=True)}
        for paths in (job.input.onsets, job.input.variants)
    )
    loaded = [store.load(path) for path in job.input.members]
    members = {case: {name: one.sel(case=case) for name, one in zip(factors, loaded, strict=True)} for case in CASES}
    compared = shifts(onsets, variants, members, cfg["sweeps"]["order"], factors)
    store.save(compared, job)
    rows = table.rows(compared)
    tables.write_rows(rows, job.output.table)
    for row in rows:
        drawn = f"{row['percentile_5']} to {row['percentile_95']}"
        stage.announce(
            f"{row['event']}: with less without {row['shift']}, {row['lowest']} to {row['highest']} over ways of "
            f"computing; ensemble {drawn}, {row['members_with_event']} of {row['members']} members"
        )


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
