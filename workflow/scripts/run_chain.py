"""The wear chain of a case of a member, all its cycles computed in one process."""

from typing import TYPE_CHECKING

from gearwear.chain.record import record
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    chain = record(job.params.cfg["chain"], job.params.cfg["updates"])
    if hindrance := chain["hindrance"].item():
        stage.log.info("wear cycle %d cannot be: %s", chain.sizes.get("wear_cycle", 0), hindrance)
    store.save(chain, job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
