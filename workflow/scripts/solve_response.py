"""Steady response at the running speed and the dynamic mesh force along the path of contact."""

from typing import TYPE_CHECKING

from gearwear.chain.response import response
from gearwear.codes.motion_class import class_name
from gearwear.io import store
from gearwear.run import stage

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    solved = response(job.params.cfg, store.load(job.input.geometry), *store.mesh_states(job.input))
    motion_class = int(solved["motion_class"])
    stage.log.info("mesh frequency ratio %.4f: %s", float(solved["mesh_frequency_ratio"]), class_name(motion_class))
    store.save(solved, job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
