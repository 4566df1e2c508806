"""Excitation of an oscillator that the configuration gives instead of a gear pair."""

from typing import TYPE_CHECKING

import xarray as xr

from gearwear.io import store
from gearwear.oscillator.excitation_variables import columns
from gearwear.oscillator.prescribed import given_excitation
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    source = given_excitation(job.params.cfg["oscillators"][job.wildcards.case])
    store.save(xr.Dataset(columns(source)), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
