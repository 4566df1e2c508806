"""One tile of a map: the settled motions over the mesh frequency, for some rows of another parameter or state."""

from types import SimpleNamespace
from typing import TYPE_CHECKING

import numpy as np

from gearwear.io import store
from gearwear.motions import parameter_map
from gearwear.oscillator.excitation import excitation, swept_oscillator
from gearwear.run import stage
from gearwear.run.parts import indices

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake


def main(job):
    cfg, geometry, name = job.params.cfg, store.load(job.input.geometry), job.wildcards.map
    dynamics, torque = cfg["dynamics"], cfg["operation"]["pinion_torque"]
    frequencies = parameter_map.values(cfg["maps"]["mesh_frequency"])
    if name == "wear":
        rows = np.array([float(store.load(path)["running_cycles"]) for path in job.input.wear])
    else:
        rows = parameter_map.values(cfg["maps"][name])
        rows = rows[indices(len(rows), job.wildcards.scatteritem)]

    def row(place, value):
        source = excitation(geometry, *store.mesh_states(_state_of(job.input, place)), torque, dynamics)
        if name == "wear":
            return source, [source.oscillator(dynamics, one) for one in frequencies]
        swept = cfg.get("sweeps", {}).get(name, {})
        settings = [swept | {"mesh_frequency": one} for one in frequencies]
        return source, [swept_oscillator(source, name, value, dynamics, one) for one in settings]

    stage.log.info("%d rows of the map over %s", len(rows), name)
    found = (row(place, value) for place, value in enumerate(rows))
    store.save(parameter_map.tile(name, rows, frequencies, found, cfg), job)


def _state_of(inputs, place: int) -> SimpleNamespace:
    """Return the files of the mesh behind a row: its own, or the one that all rows share."""
    files = {name: paths for name, paths in inputs.items() if name not in ("geometry", "wear")}
    return SimpleNamespace(**{name: one if isinstance(one, str) else one[place] for name, one in files.items()})


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
