"""Contact and flash temperature, friction and film along the path of contact."""

from typing import TYPE_CHECKING

from gearwear.figures import path_panels
from gearwear.figures.sheet import DOUBLE, sheet
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

PANELS = {
    "contact_temperature": ("Contact temperature", "Contact temperature (°C)"),
    "flash_temperature": ("Flash temperature", "Flash temperature rise (K)"),
    "friction_coefficient": ("Friction", "Coefficient of friction (1)"),
    "film_ratio": ("Film thickness over roughness", "Film ratio (1)"),
}


def main(job):
    geometry, drawn = store.load(job.input.geometry), job.params.cfg["states"]
    contacts = [store.load(path) for path in job.input.temperature]
    panels = [path_panels.Panel(*words, [one[name] for one in contacts]) for name, words in PANELS.items()]
    with sheet(job, DOUBLE, 105) as figure:
        path_panels.draw(figure, geometry, panels, drawn)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
