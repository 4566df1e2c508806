"""Excitation of a case in its last wear cycle: all that its oscillator takes from the mesh."""

from typing import TYPE_CHECKING

import xarray as xr

from gearwear.io import store
from gearwear.oscillator.excitation import excitation
from gearwear.oscillator.excitation_variables import columns
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    cfg, geometry = job.params.cfg, store.load(job.input.geometry)
    state, reference = store.mesh_states(job.input)
    source = excitation(geometry, state, reference, cfg["operation"]["pinion_torque"], cfg["dynamics"])
    stage.log.info("force parameter %.6f, error amplitude %.6f", source.force_parameter, source.error_amplitude)
    store.save(xr.Dataset(columns(source)), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
