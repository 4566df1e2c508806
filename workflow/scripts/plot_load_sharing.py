"""Load of one tooth pair along the path of contact, under the static and under the dynamic mesh force."""

from typing import TYPE_CHECKING

import numpy as np

from gearwear.figures import path_panels
from gearwear.figures.sheet import DOUBLE, sheet
from gearwear.io import store
from gearwear.mesh.sharing import share, springs_of
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

LABEL = "Load of the pair\nover mean mesh force"


def dynamic_load(geometry, stiffness, transmission, response):
    """Return the load of the pair over the mean mesh force (path,), mean over the periods of the response."""
    springs, removed = springs_of(geometry, stiffness), transmission["sharing_error"].values
    forces = response["mesh_force_path"].values
    loads = [np.maximum(force, 0) * share(springs, removed, force).load_share for force in forces]
    return transmission["load_share_path"].copy(data=np.mean(loads, axis=0) / float(response["mean_force"]))


def main(job):
    geometry, drawn = store.load(job.input.geometry), job.params.cfg["states"]
    names = ("mesh_stiffness", "transmission_error", "response")
    files = [[store.load(path) for path in paths] for paths in zip(*(job.input[name] for name in names), strict=True)]
    panels = (
        path_panels.Panel(
            "Static mesh force", LABEL, [transmission["load_share_path"] for _, transmission, _ in files]
        ),
        path_panels.Panel("Dynamic mesh force", LABEL, [dynamic_load(geometry, *state) for state in files]),
    )
    with sheet(job, DOUBLE, 68) as figure:
        path_panels.draw(figure, geometry, panels, drawn, one_scale=True)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
