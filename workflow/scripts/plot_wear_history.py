"""Wear at the deepest place of either flank, transmission error and mesh stiffness over the revolutions."""

from typing import TYPE_CHECKING

import numpy as np

from gearwear.figures import history
from gearwear.figures.sheet import DOUBLE, sheet
from gearwear.io import store
from gearwear.oscillator.harmonics import mean_over_mesh
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    drawn, width = job.params.cfg["states"], store.load(job.input.geometry)["mesh_phase_width"].values
    files = iter(zip(job.input.wear, job.input.mesh_stiffness, job.input.transmission_error, strict=True))
    cycles, lines = [], []
    for state in drawn:
        rows = []
        for _ in range(state["cycle"] + 1):
            wear, stiffness, transmission = (store.load(path) for path in next(files))
            deepest = 1e6 * wear["wear_depth"].max("path").values
            error = 1e6 * mean_over_mesh(transmission["transmission_error"].values, width)
            effective = 1e-8 * mean_over_mesh(transmission["effective_stiffness"].values, width)
            rows.append((float(wear["running_cycles"]), *deepest, error, effective))
        count, *values = np.array(rows).T
        cycles.append(count)
        lines.append(values)
    pinion, gear, error, effective = zip(*lines, strict=True)
    panels = (
        history.Panel("Pinion", "Greatest wear depth (µm)", pinion),
        history.Panel("Gear", "Greatest wear depth (µm)", gear),
        history.Panel("Transmission error", "Mean over the mesh (µm)", error),
        history.Panel("Effective mesh stiffness", "Mean over the mesh (10⁸ N/m)", effective),
    )
    with sheet(job, DOUBLE, 105) as figure:
        history.draw(figure, cycles, panels, drawn)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
