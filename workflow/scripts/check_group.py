"""One group of checks: what the program finds, and whether it agrees with the sources."""

from typing import TYPE_CHECKING

from gearwear.io import tables
from gearwear.run import stage
from gearwear.validation import outcomes
from gearwear.validation.checks import read
from gearwear.validation.groups import QUANTITIES

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    group = job.params.cfg["group"]
    checks = [check for check in read(job.input.checks) if check.group == group]
    found = [outcomes.compute(check, QUANTITIES[group]) for check in checks]
    tables.write_rows(outcomes.rows(found), job.output[0])
    stage.log.info("%s", outcomes.summary(found))


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
