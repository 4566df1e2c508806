"""The outcomes of the members of a study as one dataset, one tidy table, and a sentence on every life."""

from typing import TYPE_CHECKING

from gearwear.io import store, tables
from gearwear.run import stage
from gearwear.studies import table
from gearwear.studies.gathering import axes_of, gathered
from gearwear.studies.outcome import impossible

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    cfg = job.params.cfg
    files = iter(job.input.outcomes)
    outcomes = [
        impossible(cfg["sweeps"]["mesh_frequency"], one["hindrance"]) if one["hindrance"] else store.load(next(files))
        for one in cfg["members"]
    ]
    axes = axes_of(cfg["study"])
    study = gathered(axes, [one["name"] for one in cfg["members"]], outcomes)
    store.save(study, job)
    tables.write_rows(table.rows(study, list(axes), cfg["sweeps"]["order"]), job.output.table)
    lives = table.sentences(study, {key: cfg["units"].get(key, "") for key in axes})
    tables.write_rows(lives, job.output.lives)
    for life in lives:
        stage.announce(life["sentence"])


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
