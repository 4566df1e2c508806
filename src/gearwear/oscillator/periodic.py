"""Functions of the mesh phase: sums of harmonics, and piecewise linear tables with jumps."""

from dataclasses import dataclass, replace
from functools import cached_property
from math import isfinite
from typing import Any

import numpy as np

from gearwear.errors import Infeasible


def finite_floats(values: Any, quantity: str) -> tuple[float, ...]:
    """The values as a tuple of floats; ValueError if one of them is not finite."""
    numbers = tuple(map(float, values))
    for number in numbers:
        if not isfinite(number):
            raise Infeasible(f"{quantity}: {number} is not finite; every value must be a finite number")
    return numbers


@dataclass(frozen=True)
class Harmonics:
    """mean + sum over j = 1, 2, ... of amplitudes[j-1] cos(2 pi j phase + phases[j-1]).

    Parameters
    ----------
    mean : float
    amplitudes, phases : sequences of equal length
        Amplitude (unit of the quantity) and phase (rad) of the harmonics 1, 2, ...

    Raises
    ------
    Infeasible
        For a number that is not finite or for lists of unequal length.
    """

    mean: float = 0.0
    amplitudes: tuple[float, ...] = ()
    phases: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "mean", finite_floats((self.mean,), "harmonics mean")[0])
        object.__setattr__(self, "amplitudes", finite_floats(self.amplitudes, "harmonics amplitudes"))
        object.__setattr__(self, "phases", finite_floats(self.phases, "harmonics phases"))
        if len(self.amplitudes) != len(self.phases):
            raise Infeasible(
                f"harmonics: {len(self.amplitudes)} amplitudes but {len(self.phases)} phases; give one phase (rad) "
                "for every amplitude"
            )

    def at(self, phase: np.ndarray) -> np.ndarray:
        """Values at mesh phases (periods, any shape)."""
        return self._derivative(np.asarray(phase, dtype=float), 0)

    def _derivative(self, phase: np.ndarray, order: int) -> np.ndarray:
        value = np.full(phase.shape, self.mean if order == 0 else 0.0)
        for j, (amplitude, shift) in enumerate(zip(self.amplitudes, self.phases, strict=True), start=1):
            angle = 2 * np.pi * j * phase + shift + order * np.pi / 2
            value = value + amplitude * (2 * np.pi * j) ** order * np.cos(angle)
        return value

    def jump(self, phase: np.ndarray) -> np.ndarray:
        """Jump of the function at mesh phases: none."""
        return np.zeros(np.shape(phase))

    @cached_property
    def minimum(self) -> float:
        """Least value over the period: the lowest of 64 samples per shortest wave, polished by Newton steps."""
        if not any(self.amplitudes[1:]):
            return self.mean - sum(map(abs, self.amplitudes))
        count = 64 * len(self.amplitudes)
        phase = np.arange(count) / count
        values = self.at(phase)
        phase = phase[(values <= np.roll(values, 1)) & (values <= np.roll(values, -1))]
        for _ in range(4):
            curvature = self._derivative(phase, 2)
            step = np.where(curvature > 0, -self._derivative(phase, 1) / np.where(curvature > 0, curvature, 1), 0)
            phase = phase + np.clip(step, -1 / count, 1 / count)
        return float(min(values.min(), self.at(phase).min()))

    def seen_from(self, phase: float) -> "Harmonics":
        """The same function of time with its zero of phase moved to `phase`."""
        turns = 2 * np.pi * phase * np.arange(1, len(self.phases) + 1)
        return replace(self, phases=tuple(np.add(self.phases, turns)))

    def scaled(self, factor: float) -> "Harmonics":
        """All values multiplied by a factor."""
        return Harmonics(factor * self.mean, tuple(factor * a for a in self.amplitudes), self.phases)


@dataclass(frozen=True)
class PeriodicTable:
    """Piecewise linear function of the mesh phase, with jumps allowed at the breaks.

    Parameters
    ----------
    breaks : (n+1,) sequence
        Strictly increasing mesh phases, the first 0 and the last 1.
    start, end : (n,) sequences
        Value at the beginning and at the end of every cell.

    Raises
    ------
    Infeasible
        For breaks that do not increase from 0 to 1, lists of the wrong length or numbers that are not finite.
    """

    breaks: tuple[float, ...]
    start: tuple[float, ...]
    end: tuple[float, ...]

    def __post_init__(self) -> None:
        for name in ("breaks", "start", "end"):
            object.__setattr__(self, name, finite_floats(getattr(self, name), f"table {name}"))
        if len(self.breaks) < 2 or self.breaks[0] != 0.0 or self.breaks[-1] != 1.0:
            raise Infeasible(
                f"table breaks: run from {self.breaks[:1]} to {self.breaks[-1:]} (mesh phase); "
                "they must run from 0 to 1"
            )
        if min(np.diff(self.breaks)) <= 0.0:
            raise Infeasible(f"table breaks: least step {min(np.diff(self.breaks))}; they must increase strictly")
        cells = len(self.breaks) - 1
        for name in ("start", "end"):
            if len(getattr(self, name)) != cells:
                raise Infeasible(f"table {name}: {len(getattr(self, name))} values for {cells} cells; give one a cell")

    def at(self, phase: np.ndarray) -> np.ndarray:
        """Values at mesh phases in [0, 1); at a break the value of the cell that begins there."""
        breaks, phase = np.array(self.breaks), np.asarray(phase, dtype=float)
        cell = np.clip(np.searchsorted(breaks, phase, side="right") - 1, 0, len(breaks) - 2)
        share = (phase - breaks[cell]) / (breaks[cell + 1] - breaks[cell])
        return (1 - share) * np.array(self.start)[cell] + share * np.array(self.end)[cell]

    def jump(self, phase: np.ndarray) -> np.ndarray:
        """Jump of the function at mesh phases in [0, 1]: value after less value before, zero between the breaks."""
        breaks, phase = np.array(self.breaks), np.asarray(phase, dtype=float)
        cell = np.clip(np.searchsorted(breaks, phase), 0, len(breaks) - 1)
        step = np.roll(self.end, 1)
        step = np.append(np.array(self.start) - step, self.start[0] - self.end[-1])
        return np.where(breaks[cell] == phase, step[cell], 0.0)

    def slopes(self) -> np.ndarray:
        """Slope in every cell, per mesh period."""
        return (np.array(self.end) - np.array(self.start)) / np.diff(self.breaks)

    @cached_property
    def minimum(self) -> float:
        """Least value over the period."""
        return min(self.start + self.end)

    def seen_from(self, phase: float) -> "PeriodicTable":
        """The same function of time with its zero of phase moved to `phase`; the cell that holds it is cut in two."""
        if not 0.0 < phase < 1.0:
            return self
        breaks = np.union1d(self.breaks, [phase])
        cell = np.searchsorted(self.breaks, breaks[:-1], side="right") - 1
        left, slope = np.array(self.breaks)[cell], self.slopes()[cell]
        start = np.array(self.start)[cell] + slope * (breaks[:-1] - left)
        end = np.array(self.start)[cell] + slope * (breaks[1:] - left)
        first = int(np.searchsorted(breaks, phase))
        turned = np.concatenate([breaks[first:-1] - phase, breaks[:first] + (1.0 - phase), [1.0]])
        turned[0] = 0.0
        return PeriodicTable(tuple(turned), tuple(np.roll(start, -first)), tuple(np.roll(end, -first)))

    def scaled(self, factor: float) -> "PeriodicTable":
        """All values multiplied by a factor."""
        return replace(self, start=tuple(factor * v for v in self.start), end=tuple(factor * v for v in self.end))


def sum_of_harmonics(function: Harmonics | PeriodicTable) -> Harmonics:
    """The function if it is a sum of harmonics; ValueError for a table."""
    if isinstance(function, PeriodicTable):
        raise Infeasible("stiffness or error is a table, which has no amplitudes; give a number for dynamics.harmonics")
    return function
