"""How the tooth pairs share the mesh force, and the transmission error that follows.

Every pair j whose flanks lack E_j (m along the line of action) deflects by S - E_j as long as that is
positive, S being the common approach of the two gears. One balance of forces settles who carries what in every zone:
the single pair, two pairs, or two pairs of which one has lost contact.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import xarray as xr


class Springs(NamedTuple):
    """Tooth pairs along the path: stiffness (N/m, (n,)), common compliance (m/N, (n,)), partner node (n,)."""

    stiffness: np.ndarray
    coupling: np.ndarray
    partner: np.ndarray


class Sharing(NamedTuple):
    """Result at every path node, shape (n,) each."""

    approach: np.ndarray
    load_share: np.ndarray
    deflection: np.ndarray


def share(springs: Springs, removed: np.ndarray, force: float | np.ndarray) -> Sharing:
    """Return approach (m), load share of the pair at each node (0 to 1) and its elastic deflection (m).

    Solves sum_j F_j = F with F_j > 0 only where S > E_j: Chen and Shao, Mech. Mach. Theory 62 (2013), Eqs 12 to 20,
    written as one balance; with a common foundation the deflections are S - E_j = sum_i C_ji F_i.

    Parameters
    ----------
    springs : the pairs.
    removed : E (m), material removed from both flanks of the pair at each node, shape (n,).
    force : mesh force (N), scalar or shape (n,); where it is not positive nothing is carried.
    """
    force = np.broadcast_to(np.asarray(force, dtype=float), removed.shape)
    pushed = np.maximum(force, 0.0)
    own = 1 / springs.stiffness
    approach = pushed * own + removed
    load = pushed.copy()
    both = np.flatnonzero(springs.partner >= 0)
    mate = springs.partner[both]
    f, c11, c22, c12 = pushed[both], own[both], own[mate], springs.coupling[both]
    e1, e2 = removed[both], removed[mate]
    pull = (f * (c22 - c12) + e2 - e1) / (c11 + c22 - 2 * c12)
    carried = np.clip(pull, 0.0, f)
    load[both] = carried
    approach[both] = np.where(pull > 0, c11 * carried + c12 * (f - carried) + e1, c22 * f + e2)
    fraction = np.divide(load, pushed, out=np.zeros_like(load), where=pushed > 0)
    deflection = np.where(load > 0, approach - removed, 0.0)
    return Sharing(approach, fraction, deflection)


def removed_by_heat(growth: np.ndarray, mode: str) -> np.ndarray:
    """Return the thermal part of E (m), shape (n,), from the growth of one flank of each gear, shape (2, n).

    Parameters
    ----------
    growth : delta_t (m), positive = thicker.
    mode : `relative`, half the growth that the four flanks lack against the most grown mesh position; `none`;
        `full_removed`, minus the growth of the two drive flanks, the plain physical sign; `full_added`, plus the
        growth of all four flanks.
    """
    four_flanks = 2 * growth.sum(axis=0)
    if mode == "relative":
        return (four_flanks.max() - four_flanks) / 2
    return {"none": 0.0, "full_removed": -0.5, "full_added": 1.0}[mode] * four_flanks


class Transmission(NamedTuple):
    """Load sharing and transmission error of one state of the flanks.

    `profile_error` is the material that a pair lacks as the transmission error sees it, `sharing_error` as load
    sharing sees it (m, along the path).
    """

    transmission_error: np.ndarray
    effective_stiffness: np.ndarray
    load_sharing_factor: np.ndarray
    load_share_path: np.ndarray
    elastic_deflection: np.ndarray
    profile_error: np.ndarray
    sharing_error: np.ndarray


def springs_of(geometry: xr.Dataset, stiffness: xr.Dataset) -> Springs:
    """Return the tooth pairs from the datasets of the geometry and mesh stiffness stages."""
    return Springs(stiffness["pair_stiffness"].values, stiffness["pair_coupling"].values, geometry["partner"].values)


def transmission(
    geometry: xr.Dataset,
    stiffness: xr.Dataset,
    wear: np.ndarray,
    growth: np.ndarray,
    force: float,
    mode: str,
    heat: str,
    heat_in_load_sharing: bool,
    made: np.ndarray | float = 0.0,
) -> Transmission:
    """Return transmission error (m, (m,)) and load sharing of the worn, hot pair.

    Parameters
    ----------
    geometry, stiffness : datasets of these stages.
    wear, growth : per flank, m, (2, n).
    force : static mesh force, N.
    mode : `loaded`, the approach under load; `no_load`, the profile error alone.
    heat : see `removed_by_heat`.
    heat_in_load_sharing : whether thermal growth takes part in load sharing and elastic deflection.
    made : material that the new pair lacks, m, (n,).
    """
    springs = springs_of(geometry, stiffness)
    cold = wear.sum(axis=0) + made
    profile_error = cold + removed_by_heat(growth, heat)
    sharing_error = profile_error if heat_in_load_sharing else cold
    loaded, carried = share(springs, profile_error, force), share(springs, sharing_error, force)
    entering, leaving = geometry["entering"].values, geometry["leaving"].values
    second = np.where(leaving < 0, 0.0, carried.load_share[leaving])
    better = profile_error[entering]
    better = np.where(leaving < 0, better, np.minimum(better, profile_error[leaving]))
    approach = loaded.approach[entering]
    return Transmission(
        transmission_error=approach if mode == "loaded" else better,
        effective_stiffness=force / (approach - better),
        load_sharing_factor=np.stack([carried.load_share[entering], second], axis=1),
        load_share_path=carried.load_share,
        elastic_deflection=carried.deflection,
        profile_error=profile_error,
        sharing_error=sharing_error,
    )
