"""Mean mesh stiffness of the root model against ISO 6336-1 (2006), Method B, solid discs and 20 degree racks."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import xarray as xr

from gearwear.oscillator.harmonics import mean_over_mesh
from gearwear.validation.pairs import geometry_of, standard_pair
from gearwear.validation.stiffness import mesh_of

_C = (0.04723, 0.15551, 0.25791, -0.00635, -0.11654, -0.00193, -0.24188, 0.00529, 0.00182)


def compliance(teeth: Sequence[float], shift: Sequence[float] = (0.0, 0.0)) -> float:
    """Return q' (mm um/N), Eq. 84, of a pair of virtual numbers of teeth."""
    (z1, z2), (x1, x2) = teeth, shift
    terms = (1.0, 1 / z1, 1 / z2, x1, x1 / z1, x2, x2 / z2, x1**2, x2**2)
    return sum(c * term for c, term in zip(_C, terms, strict=True))


def theoretical(teeth: Sequence[float], shift: Sequence[float] = (0.0, 0.0)) -> float:
    """Return c'_th (N/(um mm))."""
    return 1 / compliance(teeth, shift)


def rack_factor(dedendum: float = 1.25) -> float:
    """Return C_B of a 20 degree rack whose dedendum is that many modules."""
    return 1 + 0.5 * (1.2 - dedendum)


def single(
    teeth: Sequence[float], shift: Sequence[float] = (0.0, 0.0), dedendum: float = 1.25, helix: float = 0.0
) -> float:
    """Return c' (N/(um mm)) of steel; helix angle in degrees."""
    return 0.8 * rack_factor(dedendum) * math.cos(math.radians(helix)) * theoretical(teeth, shift)


def mesh(contact_ratio: float, **pair: Any) -> float:
    """Return c_gamma_alpha (N/(um mm)), mean mesh stiffness over face width; `pair` as for `single`."""
    return single(**pair) * (0.75 * contact_ratio + 0.25)


def root_model_over_iso(teeth: Sequence[float], root_over_bore: float) -> float:
    """Return the mean mesh stiffness of the model clamped at the root over that of ISO."""
    return _over_iso(standard_pair(teeth, root_over_bore, mesh_cells=80))


def given_pair_over_iso(pair: dict[str, Any]) -> float:
    """Return the same ratio for a pair with its own bores."""
    return _over_iso(geometry_of(**pair))


def _over_iso(geometry: xr.Dataset) -> float:
    k = mean_over_mesh(mesh_of(geometry, cantilever="root"), geometry["mesh_phase_width"].values)
    published = mesh(float(geometry["contact_ratio"]), teeth=geometry["teeth"].values)
    return float(k) / float(geometry["face_width"]) * 1e-9 / published


QUANTITIES = {
    "compliance": compliance,
    "theoretical": theoretical,
    "rack_factor": rack_factor,
    "single": single,
    "mesh": mesh,
    "root_model_over_iso": root_model_over_iso,
    "given_pair_over_iso": given_pair_over_iso,
}
