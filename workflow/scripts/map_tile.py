"""One tile of a map: the settled motions over the mesh frequency, for some rows of another parameter or state."""

from types import SimpleNamespace
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from gearwear.attractors import plane
from gearwear.attractors.record import columns
from gearwear.attractors.settling import Settling, settle_many
from gearwear.dynamics.excitation import excitation, rest_state, swept_oscillator
from gearwear.dynamics.parts import indices
from gearwear.plumbing import stage, store

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

KEPT = (
    "motion_class",
    "reason",
    "conflict",
    "period",
    "lyapunov_exponent",
    "lyapunov_exponent_error",
    "transient_periods",
    "contact_loss_share",
    "force_max",
)


def main(job):
    cfg, geometry, name = job.params.cfg, store.load(job.input.geometry), job.wildcards.map
    dynamics, settling = cfg["dynamics"], Settling(**cfg["settling"])
    frequencies = plane.values(cfg["maps"]["mesh_frequency"])
    if name == "wear":
        rows = np.array([float(store.load(path)["running_cycles"]) for path in job.input.wear])
    else:
        rows = plane.values(cfg["maps"][name])
        rows = rows[indices(len(rows), job.wildcards.scatteritem)]
    tables = []
    for place, row in enumerate(rows):
        state, reference = store.mesh_states(_state_of(job.input, place))
        source = excitation(geometry, state, reference, cfg["operation"]["pinion_torque"], dynamics)
        if name in ("ste", "backlash"):
            swept = cfg.get("sweeps", {}).get(name, {})
            at = [swept_oscillator(source, name, row, dynamics, swept | {"mesh_frequency": w}) for w in frequencies]
        else:
            at = [source.oscillator(dynamics, w) for w in frequencies]
        begins = [rest_state(source, oscillator, dynamics) for oscillator in at]
        motions = settle_many(at, begins, settling, dynamics["tolerance"])
        tables.append(columns(motions, settling.sampled_periods, source.force_parameter))
    stage.log.info("%d rows of the map over %s", len(rows), name)
    none = columns([], settling.sampled_periods, 1.0)
    whole = {key: np.array([table[key][1] for table in tables], dtype=none[key][1].dtype) for key in KEPT}
    dataset = xr.Dataset(
        {key: (("row", "column"), values.reshape(len(rows), len(frequencies))) for key, values in whole.items()},
        {plane.COORDINATES[name]: ("row", rows), "mesh_frequency": ("column", frequencies)},
    )
    store.save(dataset, job)


def _state_of(inputs, place: int) -> SimpleNamespace:
    """Return the files of the mesh behind a row: its own, or the one that all rows share."""
    files = {name: paths for name, paths in inputs.items() if name not in ("geometry", "wear")}
    return SimpleNamespace(**{name: one if isinstance(one, str) else one[place] for name, one in files.items()})


if __name__ == "__main__":
    with stage.logged(snakemake, __file__):
        main(snakemake)
