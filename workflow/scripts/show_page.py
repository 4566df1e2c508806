"""The motions along every sweep as one interactive page that needs no other file."""

from pathlib import Path
from typing import TYPE_CHECKING

from gearwear.figures import page
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    teeth = int(store.load(job.input.geometry)["teeth"][0]) if job.input.geometry else None
    panels = zip(job.params.cfg["panels"], job.input.sweeps, job.input.motions, strict=True)
    records = [page.record(panel, store.load(sweep), store.load(motion), teeth) for panel, sweep, motion in panels]
    template, program = (Path(job.input[name]).read_text(encoding="utf-8") for name in ("template", "program"))
    with store.atomic(job.output[0]) as temporary:
        Path(temporary).write_text(page.page(template, program, records), encoding="utf-8")
    stage.log.info("%d sweeps, %.1f MB", len(records), Path(job.output[0]).stat().st_size / 1e6)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
