"""Elastic modulus of hot steel."""

from __future__ import annotations

from typing import Any

import numpy as np

from gearwear.errors import Infeasible

REFERENCE_TEMPERATURE = 20.0  # degC, at which the modulus of the configuration holds

# Carbon steel, carbon up to 0.3 %: temperature degC, modulus GPa (ASME B31.3, table C-6).
_TABLE_TEMPERATURE = np.array([21.0, 93.0, 149.0, 204.0, 260.0])
_TABLE_MODULUS = np.array([203.4, 198.6, 195.1, 191.0, 188.2])

# Iron: Shomate coefficients of the solid below 700 K (NIST WebBook), J/(mol K) with T in units of 1000 K.
_SHOMATE = (18.42868, 24.64301, -8.913720, 9.664706, -0.012643)
_MELTING, _BOILING = 1811.0, 3134.0  # K
_FUSION, _EVAPORATION = 13.8e3, 340.0e3  # J/mol
_LIQUID_HEAT = 46.0  # J/(mol K)
_MELT_ENTHALPY = 58.7e3  # J/mol, solid iron from 293 K to melting


def modulus_ratio(
    temperature: float | np.ndarray, law: str, thermal_expansion: float = 1.16e-5, calibration: float = 5.3
) -> np.ndarray:
    """Return E(T) over E(20 degC).

    Parameters
    ----------
    temperature : degC, array or scalar.
    law : `li`, the form of Li et al., Mech. Mater. 139 (2019) 103194, with iron data and the factor
        `calibration` fitted to tabulated steel: E/E20 = (1 + int l dT)^-3 (1 - K int C dT / H*);
        `linear`, 1 - 3.25e-4 (T - 20); `table`, carbon steel of ASME B31.3; `constant`.
    thermal_expansion : l, 1/K.
    calibration : K, dimensionless.

    Raises
    ------
    Infeasible : unknown law, or a temperature outside the table.
    """
    temperature = np.asarray(temperature, dtype=float)
    warming = temperature - REFERENCE_TEMPERATURE
    if law == "constant":
        return np.ones_like(temperature)
    if law == "linear":
        return 1 - 3.25e-4 * warming
    if law == "table":
        if temperature.min() < REFERENCE_TEMPERATURE or temperature.max() > _TABLE_TEMPERATURE[-1]:
            raise Infeasible(
                f"elasticity.law table holds from 20 to 260 degC, not at {temperature} degC; use law li or linear"
            )
        first = np.interp(temperature, _TABLE_TEMPERATURE, _TABLE_MODULUS)
        return first / _TABLE_MODULUS[0]
    if law == "li":
        latent = _MELT_ENTHALPY + _FUSION + _LIQUID_HEAT * (_BOILING - _MELTING) + _EVAPORATION
        heat = _heat_content(temperature) - _heat_content(REFERENCE_TEMPERATURE)
        return (1 + thermal_expansion * warming) ** -3 * (1 - calibration * heat / latent)
    raise Infeasible(f"elasticity.law: {law!r} is unknown; use li, linear, table or constant")


def hot_modulus(material: dict[str, Any], elasticity: dict[str, Any], temperature: float) -> np.ndarray:
    """Return the modulus of pinion and gear at `temperature` (degC), Pa, shape (2,)."""
    return np.array(
        [
            material[name]["youngs_modulus"]
            * modulus_ratio(
                temperature, elasticity["law"], material[name]["thermal_expansion"], elasticity["calibration"]
            )
            for name in ("pinion", "gear")
        ]
    )


def _heat_content(temperature: float | np.ndarray) -> np.ndarray:
    """Return the enthalpy of iron above 0 K but for a constant, J/mol, at `temperature` in degC."""
    t = (np.asarray(temperature) + 273.15) / 1000
    a, b, c, d, e = _SHOMATE
    return 1000 * (a * t + b * t**2 / 2 + c * t**3 / 3 + d * t**4 / 4 - e / t)
