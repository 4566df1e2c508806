"""One search for the values of the open parameters that agree with most claims: differential evolution."""

from __future__ import annotations

import logging
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import xarray as xr
from scipy.optimize import OptimizeResult, differential_evolution
from scipy.stats import qmc

from gearwear.calibration.agreement import agreements, judged
from gearwear.calibration.candidate import SWEPT, pair_of, quick_sweeps
from gearwear.calibration.sampling import points
from gearwear.config.calibration_parameters import NAMES, ends, values_of, with_values
from gearwear.errors import Infeasible

_MUTATION, _RECOMBINATION = (0.4, 0.9), 0.8

log = logging.getLogger("gearwear")


def evolve(config: dict[str, Any], claims: Sequence[Mapping[str, Any]], island: int) -> xr.Dataset:
    """Return every candidate that a search computed, with the claims it agrees with.

    A search starts from a Latin hypercube with the values of the study as its first candidate (Storn and Price, 1997,
    in the form of scipy.optimize.differential_evolution, best1bin). Merit is the number of claims that agree plus their
    merit (agreement.agreements), so that a candidate improves before a verdict changes.

    Parameters
    ----------
    config : the slice `calibration`.
    claims : the statements, as in `config/paper_claims.yaml`.
    island : number of the search, 1 and up; the seed of its random numbers.

    Returns
    -------
    dataset along `candidate` and `claim`; a candidate that cannot be computed agrees with nothing and has
    the reason as its remark.
    """
    settings, wanted = config["calibration"], judged(claims)
    low, high = ends(settings)
    coarse = {
        **config,
        "grid": {"mesh_cells": settings["mesh_cells"]},
        "wear": {**config["wear"], "cycles_per_update": settings["cycles_per_update"]},
    }
    values = {(case, sweep): grid_of(config, sweep)[chosen_of(config, claims, sweep)] for case, sweep in SWEPT}
    record: list[tuple[np.ndarray, np.ndarray, float, str]] = []

    def cost(columns: np.ndarray) -> np.ndarray:
        found = _judged(coarse, columns.T, wanted, values)
        record.extend(found)
        return np.array([-merit for _, _, merit, _ in found])

    def tell(intermediate_result: OptimizeResult) -> None:
        generation, merit = intermediate_result.nit, -intermediate_result.fun
        log.info("generation %d of %d: best merit %.3f", generation, settings["generations"], merit)

    start = qmc.scale(qmc.LatinHypercube(len(NAMES), rng=island).random(settings["population"]), low, high)
    if island == 1:
        start[0] = np.clip(values_of(config), low, high)
    differential_evolution(
        cost,
        list(zip(low, high, strict=True)),
        init=start,
        maxiter=settings["generations"],
        mutation=_MUTATION,
        recombination=_RECOMBINATION,
        tol=0.0,
        polish=False,
        vectorized=True,
        updating="deferred",
        rng=island,
        callback=tell,
    )
    return xr.Dataset(
        {
            **{
                f"candidate_{name}": ("candidate", np.array([one[0][i] for one in record]))
                for i, name in enumerate(NAMES)
            },
            "claim_agrees": (("candidate", "claim"), np.array([one[1] for one in record], dtype=np.int32)),
            "candidate_merit": ("candidate", np.array([one[2] for one in record])),
            "candidate_remark": ("candidate", np.array([one[3] for one in record], dtype=object)),
        },
        {"claim": np.array([claim["id"] for claim in wanted], dtype=object)},
    )


def grid_of(config: dict[str, Any], sweep: str) -> np.ndarray:
    """Return the swept values of the study."""
    swept = config["sweeps"][sweep]
    return np.linspace(swept["first"], swept["last"], swept["points"])


def chosen_of(config: dict[str, Any], claims: Sequence[Mapping[str, Any]], sweep: str) -> np.ndarray:
    """Return the indices of the swept values that a search computes."""
    return points(claims, sweep, grid_of(config, sweep))


def _judged(
    config: dict[str, Any], vectors: Any, claims: Any, values: Any
) -> list[tuple[np.ndarray, np.ndarray, float, str]]:
    """Return values, agreements, merit and remark of every candidate."""
    own, several, remarks = [], [], {}
    for place, vector in enumerate(vectors):
        changed = with_values(config, vector)
        try:
            several.append(pair_of(changed))
            own.append(place)
        except Infeasible as error:
            remarks[place] = str(error)
    found = [(vector, np.zeros(len(claims), dtype=bool), 0.0, remarks.get(i, "")) for i, vector in enumerate(vectors)]
    if several:
        for place, pair, sweeps in zip(own, several, quick_sweeps(config, several, values), strict=True):
            agrees, merit = agreements(claims, sweeps, pair.states)
            found[place] = (vectors[place], agrees, float(agrees.sum() + merit.sum()), "")
    return found
