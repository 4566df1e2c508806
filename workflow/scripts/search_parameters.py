"""One search for the values of the open parameters that agree with most claims about the motion."""

from typing import TYPE_CHECKING

import yaml

from gearwear.calibration.search import evolve
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    with open(job.input.claims, encoding="utf-8") as file:
        claims = yaml.safe_load(file)["claims"]
    found = evolve(job.params.cfg, claims, int(job.wildcards.island))
    agreed = found["claim_agrees"].values.sum(axis=1)
    stage.log.info(
        "%d candidates, %d of them impossible; the best agrees with %d of %d claims in the quick look",
        found.sizes["candidate"],
        (found["candidate_remark"].values != "").sum(),
        agreed.max(),
        found.sizes["claim"],
    )
    store.save(found, job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
