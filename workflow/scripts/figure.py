"""Draw a figure: the files of its rule are the arguments, by their names, of the draw function in `params.draw`."""

from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from gearwear import figures
from gearwear.figures.sheet import write
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def loaded(files, variables):
    """Return the dataset of a netCDF file, the path of another file, or a list of either."""
    if isinstance(files, str):
        return store.load(files, variables) if files.endswith(".nc") else files
    return [loaded(file, variables) for file in files]


def main(job):
    module, function = job.params.draw.split(".")
    draw = getattr(import_module(f"gearwear.figures.{module}"), function)
    read = draw.sheet.variables
    inputs = {name: loaded(files, read.get(name)) for name, files in job.input.items() if name != "style"}
    write(draw, inputs | {"cfg": job.params.cfg}, job.input.style, job.output.svg, job.output.png)


if __name__ == "__main__":
    with stage.logged(snakemake, Path(figures.__file__).with_name(f"{snakemake.params.draw.split('.')[0]}.py")):
        main(snakemake)
