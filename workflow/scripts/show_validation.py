"""All checks as one table, and as a page that needs no other file."""

from pathlib import Path
from typing import TYPE_CHECKING

from gearwear.figures import validation_page
from gearwear.io import store, tables
from gearwear.run import stage
from gearwear.validation import outcomes
from gearwear.validation.checks import read, titles

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    rows = [row for path in job.input.found for row in outcomes.read_rows(path)]
    found = outcomes.merged(read(job.input.checks), rows)
    figures = {Path(path).stem: Path(path).read_bytes() for path in job.input.figures}
    template = Path(job.input.template).read_text(encoding="utf-8")
    page = validation_page.page(template, found, titles(job.input.checks), figures)
    tables.write_rows(rows, job.output.table)
    with store.atomic(job.output.page) as html:
        Path(html).write_text(page, encoding="utf-8")
    stage.announce(f"Validation: {outcomes.summary(found)}.")


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
