"""The candidates of all searches together: the best ones computed in full, and what the others tell."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import xarray as xr

from gearwear.calibration.agreement import agreements, judged, subject
from gearwear.calibration.candidate import SWEPT, pair_of, settled_sweeps
from gearwear.calibration.search import grid_of
from gearwear.calibration.table import STUDY
from gearwear.config.calibration_parameters import NAMES, OSCILLATOR, ends, values_of, with_values
from gearwear.config.parameters import SWEEPS
from gearwear.oscillator.periodic import sum_of_harmonics

_APART = 0.02  # of the range of a parameter: candidates closer than this in all of them are one


def compared(config: dict[str, Any], claims: Sequence[Mapping[str, Any]], searches: Sequence[xr.Dataset]) -> xr.Dataset:
    """Return the candidates of all searches and, along `member`, the study and the best ones computed in full.

    In full: the grid, wear step and sweeps of the study, all evidence for the class of every point. The best are those
    of greatest merit that differ from one another; they stand in the order of their claims, then of their merit.

    Parameters
    ----------
    config : the slice `calibration`.
    claims : the statements, as in `config/paper_claims.yaml`.
    searches : as search.evolve gives them.
    """
    wanted = judged(claims)
    everyone = xr.concat(searches, dim="candidate")
    low, high = ends(config["calibration"])
    best = _best(everyone, low, high, config["calibration"]["verified"])
    vectors = [values_of(config), *_vectors(everyone)[best]]
    full = [_in_full(with_values(config, vector), wanted) for vector in vectors]
    order = [0, *sorted(range(1, len(full)), key=lambda i: (-full[i][0].sum(), -full[i][1].sum()))]
    values = np.array([[*vectors[i], *full[i][2]] for i in order])
    names = [STUDY, *(f"best_{rank:02d}" for rank in range(1, len(full)))]
    about = np.array([subject(claim) for claim in wanted], dtype=object)
    agrees = everyone["claim_agrees"].values
    return everyone.assign(
        {
            "candidate_agreements": (
                ("candidate", "sweep"),
                np.array([[row[about == name].sum() for name in SWEEPS] for row in agrees], dtype=np.int32),
            ),
            "claim_subject": ("claim", about),
            "claims_of_sweep": ("sweep", np.array([(about == name).sum() for name in SWEEPS], dtype=np.int32)),
            "member_agrees": (("member", "claim"), np.array([full[i][0] for i in order], dtype=np.int32)),
            **{f"member_{name}": ("member", values[:, i]) for i, name in enumerate((*NAMES, *OSCILLATOR))},
        }
    ).assign_coords(sweep=np.array(SWEEPS, dtype=object), member=np.array(names, dtype=object))


def _vectors(everyone: xr.Dataset) -> np.ndarray:
    return np.stack([everyone[f"candidate_{name}"].values for name in NAMES], axis=1)


def _best(everyone: xr.Dataset, low: np.ndarray, high: np.ndarray, count: int) -> list[int]:
    places = (_vectors(everyone) - low) / np.where(high > low, high - low, 1.0)
    chosen: list[int] = []
    for i in np.argsort(-everyone["candidate_merit"].values, kind="stable"):
        if len(chosen) == count:
            break
        if all(np.abs(places[i] - places[j]).max() > _APART for j in chosen):
            chosen.append(int(i))
    return chosen


def _in_full(config: dict[str, Any], claims: Sequence[Mapping[str, Any]]) -> Any:
    """Return agreements, merits and parameters of the oscillator of case `with`."""
    pair = pair_of(config)
    values = {(case, sweep): grid_of(config, sweep) for case, sweep in SWEPT}
    agrees, merit = agreements(claims, settled_sweeps(config, pair.sources, values), pair.states)
    hot = pair.sources["with"]
    stiffness, shape = sum_of_harmonics(hot.stiffness), sum_of_harmonics(hot.shape)
    lag = np.angle(-np.exp(1j * (stiffness.phases[0] - shape.phases[0])))
    oscillator = [hot.force_parameter, stiffness.amplitudes[0], hot.error_amplitude / hot.force_parameter, lag]
    return agrees, merit, oscillator
