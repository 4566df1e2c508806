"""Everything in which a run leaves the range of a law, each once."""

from typing import TYPE_CHECKING

from gearwear.io import store, tables
from gearwear.run import stage
from gearwear.validity import ranges

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def measured(job):
    cfg, geometry = job.params.cfg, store.load(job.input.geometry)
    yield from ranges.of_pair(geometry)
    names = ("temperature", "transmission_error", "wear", "response")
    temperature, transmission_error, wear, response = (map(store.load, job.input[name]) for name in names)
    for case, cycles in cfg["cases"].items():
        yield from ranges.of_contact(case, geometry, next(temperature), cfg)
        steps = [(next(transmission_error), next(wear)) for _ in range(cycles)]
        yield from ranges.of_chain(case, steps, [int(next(response)["motion_class"]) for _ in range(cycles + 1)])


def main(job):
    rows = ranges.rows(measured(job))
    for row in rows:
        stage.announce(ranges.sentence(row))
    tables.write(job, "warnings", ranges.COLUMNS, rows)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
