"""The map whose fixed points are periodic orbits: the oscillator seen once every so many mesh periods.

The restoring force is continuous, so the map has a continuous derivative, also where a motion grazes an end of the
backlash: there the monodromy matrix changes as the square root of the distance. Newton's method therefore converges
everywhere, near a grazing orbit with order 3/2 instead of 2, and test functions made of the matrix stay continuous.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from gearwear.integrate.status import MAPS
from gearwear.integrate.strobe import AUTOMATIC, check_request, integrator, vector
from gearwear.oscillator.oscillator import Oscillator

COARSEST = 1e-10  # tolerance of the integrator; a coarser map is too rough for derivatives and Newton steps
LOST = "the motion blows up or needs too many steps"


class Passage(NamedTuple):
    """One run through the map.

    section : (period + 1, size) states at mesh phase 0, displacement and velocity first, the start first
    matrix : (size, size) derivative of the last state by the first
    """

    section: np.ndarray
    matrix: np.ndarray


ReturnMap = Callable[[np.ndarray], Passage]
Family = Callable[[float, int], ReturnMap]


def return_maps(
    oscillator_at: Callable[[float], Oscillator], tolerance: float = 1e-10, backend: str = AUTOMATIC
) -> Family:
    """Return the function (value of a parameter, period) -> map over that many mesh periods.

    Parameters
    ----------
    oscillator_at : oscillator at a value of the parameter, whichever that is.
    tolerance, backend : of the integrator, as in strobe.strobe.

    Raises
    ------
    ValueError
        For a tolerance or a backend outside its range. By the function returned: for a value the oscillator refuses,
        for a period that is not a whole number of at least 1, and where the torque fluctuates with a second frequency
        that does not repeat after the period.
    """

    check_request((1.0, 0.0), 1, 0, tolerance, MAPS, backend)
    latest: list[Any] = [None, None]  # maps of several periods are asked for of one oscillator

    def return_map(value: float, period: int) -> ReturnMap:
        if int(period) != period or period < 1:
            raise ValueError(f"period: {period} (mesh periods) must be a whole number, 1 or more")
        oscillator = oscillator_at(value)
        if not oscillator.torque.repeats_after(period):
            raise ValueError(
                f"period: {period} (mesh periods) is no whole number of periods of the external torque, whose "
                f"frequency is {oscillator.torque.frequency_ratio} times the mesh frequency; no orbit repeats after it"
            )

        if oscillator is not latest[0]:
            latest[:] = oscillator, integrator(oscillator, tolerance, backend)
        integrate, tangent = latest[1], np.eye(oscillator.size)[0]

        def run(state: np.ndarray) -> Passage:
            start = vector(state, "state", oscillator.size)
            section, maps, *_ = integrate(start, tangent, 0, int(period), MAPS, False)
            matrix = np.eye(oscillator.size)
            for tangent_map in maps:
                matrix = tangent_map @ matrix
            return Passage(section, matrix)

        return run

    return return_map
