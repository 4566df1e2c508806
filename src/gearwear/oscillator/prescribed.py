"""The excitation of an oscillator that is given by its dimensionless equation, without a gear pair behind it."""

from __future__ import annotations

from itertools import zip_longest
from typing import Any

import numpy as np

from gearwear.oscillator.excitation import Excitation
from gearwear.oscillator.periodic import Harmonics

_NONE = float("nan")  # a length, mass or time that the equation does not have


def given_excitation(oscillator: dict[str, Any]) -> Excitation:
    """Return the excitation of X'' + 2 zeta X' + k(tau) f(X; 1) = F - e''.

    Parameters
    ----------
    oscillator : `mean_force` F; `stiffness` and `error`, each with `amplitudes` and `phases` (rad) of its harmonics
        1, 2, ...; k has the mean 1, and the first harmonic of e is not 0 where another is not.

    Notes
    -----
    The error itself is that of a relative mean error of 1, so that a sweep over it multiplies its amplitudes.
    """
    stiffness, error = oscillator["stiffness"], oscillator["error"]
    amplitude = error["amplitudes"][0] if error["amplitudes"] else 0.0
    shape = [one / amplitude if amplitude else 0.0 for one in error["amplitudes"]]
    waves = zip_longest(stiffness["amplitudes"], stiffness["phases"], shape, error["phases"], fillvalue=0.0)
    k, k_phase, e, e_phase = zip(*waves, strict=True) if stiffness["amplitudes"] or shape else ((),) * 4
    relative = Harmonics(1.0, k, k_phase)
    return Excitation(
        length=_NONE,
        mean_stiffness=_NONE,
        natural_frequency=_NONE,
        mean_force=_NONE,
        force_parameter=oscillator["mean_force"],
        stiffness=relative,
        shape=Harmonics(0.0, e, e_phase),
        error_amplitude=amplitude,
        reference_amplitude=amplitude,
        relative_mean_error=1.0,
        clearance=Harmonics(1.0),
        stiffest_phase=_stiffest(relative),
    )


def _stiffest(stiffness: Harmonics) -> float:
    """Return the mesh phase at which the first harmonic is largest."""
    if not stiffness.amplitudes:
        return 0.0
    shift = 0.5 if stiffness.amplitudes[0] < 0 else 0.0
    return float((shift - stiffness.phases[0] / (2 * np.pi)) % 1.0)
