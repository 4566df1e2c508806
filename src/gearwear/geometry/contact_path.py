"""The path of contact and the two grids of the mesh.

The position of a contact on the line of action is its distance s from the pinion's base tangent point.
A pair enters at s_A at mesh phase 0 and leaves at s_E; while the phase is below the contact ratio less
one, the pair that entered one mesh period before is in contact too, one base pitch ahead.

Both grids share their points: the mesh phases are the midpoints of cells, the path holds cell edges and
midpoints, so that what is known along the path of one pair is known at every mesh phase by indexing.
Where the number of pairs changes (s_B and s_D) the path has two nodes, for the values of either side.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from gearwear.errors import Infeasible
from gearwear.geometry.involute import GearPair


class ContactPath(NamedTuple):
    """Marks of the path of contact, m from the pinion's base tangent point, and its two grids."""

    line_of_action: float
    start_of_contact: float
    lowest_single_contact: float
    pitch_point: float
    highest_single_contact: float
    end_of_contact: float
    contact_ratio: float
    path: np.ndarray
    path_phase: np.ndarray
    partner: np.ndarray
    mesh_phase: np.ndarray
    mesh_phase_width: np.ndarray
    entering: np.ndarray
    leaving: np.ndarray


def contact_path(pair: GearPair, mesh_cells: int) -> ContactPath:
    """Return marks and grids of the path of contact (ISO 21771).

    Parameters
    ----------
    pair : the gear pair.
    mesh_cells : number of cells of one mesh period, at least 8.

    Returns
    -------
    ContactPath : `path` (m) and `path_phase` (mesh phase in [0, 1] when the pair is there) of shape (n,);
        `partner` (n,) index of the node where the other pair is at the same instant, -1 if none;
        `mesh_phase` and `mesh_phase_width` (m,) cell midpoints and widths; `entering` and `leaving` (m,)
        path nodes of the two pairs at these phases, `leaving` -1 in single contact.

    Raises
    ------
    Infeasible : contact ratio not between 1 and 2, or contact beyond a base tangent point.
    """
    base, tip = pair.base_radius, pair.tip_radius
    reach = np.sqrt(tip**2 - base**2)
    length = float(base.sum() * math.tan(pair.working_pressure_angle))
    start, end = length - float(reach[1]), float(reach[0])
    pitch_point = float(base[0] * math.tan(pair.working_pressure_angle))
    ratio = (end - start) / pair.base_pitch
    if not 1 < ratio < 2:
        raise Infeasible(
            f"gear_pair: the contact ratio is {ratio:.4f}; it must lie between 1 and 2, change addendum_coefficient, "
            "centre_distance or teeth"
        )
    for name, overshoot in (("gear", -start), ("pinion", end - length)):
        if overshoot >= 0:
            raise Infeasible(
                f"gear_pair: the tip of the {name} meets its mate {1e3 * overshoot:.4f} mm beyond the base tangent "
                f"point, where there is no involute; reduce the addendum_coefficient of the {name}"
            )
    double = ratio - 1
    edges = _phase_edges(double, (pitch_point - start) / pair.base_pitch, mesh_cells)
    nodes = _with_midpoints(edges)
    split = int(np.flatnonzero(nodes == double)[0])
    first, single = nodes[: split + 1], nodes[split:]
    n_first, n_single = len(first), len(single)
    phase = np.concatenate([first, single, first])
    lag = np.repeat([0.0, 0.0, 1.0], [n_first, n_single, n_first])
    path = start + (phase + lag) * pair.base_pitch
    path[n_first - 1] = path[n_first] = end - pair.base_pitch
    path[-1] = end
    if start < pitch_point < end:  # the mark is hit to round-off; sliding is exactly zero only there
        path[np.argmin(abs(path - pitch_point))] = pitch_point
    ahead = n_first + n_single + np.arange(n_first)
    partner = np.concatenate([ahead, np.full(n_single, -1), np.arange(n_first)])
    in_first = np.arange(1, n_first, 2)
    in_single = n_first + np.arange(1, n_single, 2)
    return ContactPath(
        line_of_action=length,
        start_of_contact=start,
        lowest_single_contact=end - pair.base_pitch,
        pitch_point=pitch_point,
        highest_single_contact=start + pair.base_pitch,
        end_of_contact=end,
        contact_ratio=float(ratio),
        path=path,
        path_phase=phase,
        partner=partner,
        mesh_phase=np.concatenate([first[1::2], single[1::2]]),
        mesh_phase_width=np.diff(edges),
        entering=np.concatenate([in_first, in_single]),
        leaving=np.concatenate([ahead[1::2], np.full(len(in_single), -1)]),
    )


def _phase_edges(double: float, pitch_phase: float, mesh_cells: int) -> np.ndarray:
    marks = [0.0, double, 1.0]
    inside = pitch_phase % 1.0
    if 0 <= pitch_phase <= 1 + double and min(abs(inside - mark) for mark in marks) > 1e-9:
        marks = sorted([*marks, inside])
    pieces = []
    for low, high in zip(marks, marks[1:], strict=False):
        cells = max(2, round(mesh_cells * (high - low)))
        pieces.append(low + (high - low) * np.arange(cells) / cells)
    return np.append(np.concatenate(pieces), 1.0)


def _with_midpoints(edges: np.ndarray) -> np.ndarray:
    nodes = np.empty(2 * len(edges) - 1)
    nodes[::2] = edges
    nodes[1::2] = (edges[1:] + edges[:-1]) / 2
    return nodes
