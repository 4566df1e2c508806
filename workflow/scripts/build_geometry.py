"""Dimensions of the gear pair, the path of contact and the grids of the mesh."""

from typing import TYPE_CHECKING

from gearwear.geometry.contact_path import contact_path
from gearwear.geometry.involute import GEARS, equivalent_mass, gear_pair
from gearwear.geometry.record import dataset
from gearwear.mesh.foundation import fit_warnings
from gearwear.plumbing import stage, store

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    settings = dict(job.params.cfg["gear_pair"])
    inertia = settings.pop("inertia")
    density = {name: job.params.cfg["material"][name]["density"] for name in GEARS}
    pair = gear_pair(**settings)
    mesh = contact_path(pair, job.params.cfg["grid"]["mesh_cells"])
    moments, mass = equivalent_mass(pair, density, inertia)
    stage.log.info("contact ratio %.4f, equivalent mass %.4f kg", mesh.contact_ratio, mass)
    for i, name in enumerate(GEARS):
        for sentence in fit_warnings(pair.root_radius[i] / pair.bore_radius[i], pair.rack_root_angle[i], name):
            stage.announce(f"warning: {sentence}")
    values = {"moment_of_inertia": ("gear", moments), "equivalent_mass": mass}
    store.save(dataset(pair, mesh).assign(values), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
