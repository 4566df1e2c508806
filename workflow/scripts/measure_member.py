"""The measures of one member of a study: its wear chains and its route to chaos, computed in one process."""

from typing import TYPE_CHECKING

from gearwear.io import store
from gearwear.run import stage
from gearwear.sensitivity.measures import measures

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    found = measures(job.params.cfg)
    for case in found["case"].values:
        if hindrance := found["hindrance"].sel(case=case).item():
            stage.log.info("case %s cannot be: %s", case, hindrance)
    store.save(found, job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
