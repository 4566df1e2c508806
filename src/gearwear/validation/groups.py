"""The groups of checks and the quantities that each may ask for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gearwear.validation import bifurcations, convergence, geometry, heat, iso, oscillator, sharing, stiffness, wear

QUANTITIES: Mapping[str, Mapping[str, Any]] = {
    "geometry": geometry.QUANTITIES,
    "stiffness": stiffness.QUANTITIES,
    "iso_6336": iso.QUANTITIES,
    "sharing": sharing.QUANTITIES,
    "heat": heat.QUANTITIES,
    "wear": wear.QUANTITIES,
    "oscillator": oscillator.QUANTITIES,
    "bifurcations": bifurcations.QUANTITIES,
    "convergence": convergence.QUANTITIES,
}
