"""One tile of the map over the bulk temperature: every row has the last state of a wear chain of its own."""

from typing import TYPE_CHECKING

from gearwear.chain.record import state_at
from gearwear.errors import ConfigError, Infeasible
from gearwear.io import store
from gearwear.motions import parameter_map
from gearwear.oscillator.excitation import excitation
from gearwear.run import stage
from gearwear.run.parts import indices

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    cfg, dynamics = job.params.cfg["map"], job.params.cfg["map"]["dynamics"]
    frequencies, rows = (
        parameter_map.values(cfg["maps"]["mesh_frequency"]),
        parameter_map.values(cfg["maps"]["temperature"]),
    )
    rows = rows[indices(len(rows), job.wildcards.scatteritem)]

    def row(path, temperature):
        chain = store.load(path)
        try:
            state, reference = state_at(chain, job.params.cfg["updates"])
        except Infeasible as error:
            raise ConfigError(f"maps.temperature: {temperature:g} degC cannot be: {error}; take it out") from None
        source = excitation(chain, state, reference, cfg["operation"]["pinion_torque"], dynamics)
        return source, [source.oscillator(dynamics, one) for one in frequencies]

    stage.log.info("%d rows of the map over temperature", len(rows))
    found = (row(*one) for one in zip(job.input.chains, rows, strict=True))
    store.save(parameter_map.tile("temperature", rows, frequencies, found, cfg), job)


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
