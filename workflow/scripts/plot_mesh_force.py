"""Dynamic mesh force at the running speed: over mesh periods, and its spectrum."""

from typing import TYPE_CHECKING

from gearwear.drawing import mesh_force
from gearwear.drawing.sheet import DOUBLE, sheet
from gearwear.dynamics.spectrum import spectrum
from gearwear.plumbing import stage, store

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    geometry, drawn = store.load(job.input.geometry), job.params.cfg["states"]
    phase, width = geometry["mesh_phase"].values, geometry["mesh_phase_width"].values
    highest = min(mesh_force.HIGHEST, phase.size // 4)
    forces = []
    for response in map(store.load, job.input.response):
        history = response["mesh_force_path"].values[:, geometry["entering"].values]
        lines = spectrum(history, phase, width, highest)
        forces.append(
            mesh_force.Force(history, float(response["mean_force"]), *lines, float(response["mesh_frequency_ratio"]))
        )
    with sheet(job, DOUBLE, 30 + 24 * len(drawn)) as figure:
        mesh_force.draw(figure, geometry, forces, drawn)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
