"""The outcome of one member of a study: its mesh, its motions over the speed, how fast it may run."""

from typing import TYPE_CHECKING

from gearwear.io import store
from gearwear.run import stage
from gearwear.studies.outcome import outcome

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    found = outcome(job.params.cfg["outcome"], store.load(job.input.chain), job.params.cfg["update"])
    if hindrance := found["hindrance"].item():
        stage.announce(f"{job.output[0]}: this combination cannot be: {hindrance}")
    store.save(found, job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
