"""A block of links of a wear chain in one job: the stage scripts themselves, cycle after cycle, in one process."""

from types import SimpleNamespace
from typing import TYPE_CHECKING

import advance_wear
import build_stiffness
import open_backlash
import share_load
import solve_response
from gearwear.run import stage
from gearwear.run.digest import digest

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

# What a link makes, in this order: the script, and the inputs of its rule.
LINK = {
    "wear": (advance_wear, ("geometry", "wear", "mesh_stiffness", "transmission_error", "response")),
    "mesh_stiffness": (build_stiffness, ("geometry", "deformation", "wear")),
    "transmission_error": (share_load, ("geometry", "deformation", "wear", "mesh_stiffness")),
    "backlash": (open_backlash, ("geometry", "deformation", "wear", "transmission_error")),
    "response": (
        solve_response,
        ("geometry", "mesh_stiffness", "transmission_error", "backlash", "reference_stiffness", "reference_error"),
    ),
}


class Inputs(dict):
    """Named input files, by attribute and as items, as a job has them."""

    __getattr__ = dict.__getitem__


def main(job):
    files = dict(job.input.items())
    for place in range(len(job.output.wear)):
        for made, (script, names) in LINK.items():
            file = job.output[made][place]
            stage.log.info("%s: %s", script.__name__, file)
            params = SimpleNamespace(cfg=job.params.cfg[made], code=digest(script.__file__))
            inputs = Inputs({name: files[name] for name in names})
            script.main(SimpleNamespace(rule=script.__name__, input=inputs, output=[file], params=params))
            files[made] = file


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
