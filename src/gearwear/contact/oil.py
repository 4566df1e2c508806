"""Viscosity of the lubricant."""

from __future__ import annotations

from typing import Any

import numpy as np


def dynamic_viscosity(temperature: float, lubricant: dict[str, Any]) -> float:
    """Return the dynamic viscosity (Pa s) of the oil at `temperature` (degC).

    `fixed` gives the value of the configuration; `vogel` the law eta = A exp(B/(T + 95)) (Vogel 1921) through the
    values at 40 and 100 degC.
    """
    hot = lubricant["dynamic_viscosity"]
    if lubricant["viscosity_law"] == "fixed":
        return hot
    steepness = np.log(lubricant["dynamic_viscosity_40"] / hot) / (1 / 135 - 1 / 195)
    return float(hot * np.exp(steepness * (1 / (temperature + 95) - 1 / 195)))
