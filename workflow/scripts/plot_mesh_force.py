"""Dynamic mesh force at the running speed: over mesh periods, and its spectrum."""

from typing import TYPE_CHECKING

import numpy as np

from gearwear.figures import mesh_force, motion_classes
from gearwear.figures.sheet import DOUBLE, sheet
from gearwear.io import store
from gearwear.oscillator.spectrum import spectrum
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


EDGES = np.array([-1, 0, 1])  # of a cell, beside its midpoint along the path
SIMPSON = np.array([1, 4, 1]) / 6


def cells(geometry):
    """Return path nodes, mesh phases and weights of Simpson's rule over the cells, (3 m,) each."""
    middle, phase, width = (geometry[name].values[:, None] for name in ("entering", "mesh_phase", "mesh_phase_width"))
    return (middle + EDGES).ravel(), (phase + EDGES * width / 2).ravel(), (width * SIMPSON).ravel()


def main(job):
    geometry, drawn = store.load(job.input.geometry), job.params.cfg["states"]
    nodes, phase, weight = cells(geometry)
    forces = []
    for response in map(store.load, job.input.response):
        history = response["mesh_force_path"].values[:, nodes]
        lines = spectrum(history, phase, weight, min(mesh_force.HIGHEST, geometry.sizes["mesh_phase"] // 4))
        ratio, mean = (float(response[name]) for name in ("mesh_frequency_ratio", "mean_force"))
        motion = motion_classes.name_of(response["motion_class"])
        forces.append(mesh_force.Force(phase, history, mean, *lines, ratio, motion))
    with sheet(job, DOUBLE, 30 + 24 * len(drawn)) as figure:
        mesh_force.draw(figure, geometry, forces, drawn)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
