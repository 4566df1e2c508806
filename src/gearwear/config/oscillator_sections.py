"""Section of the configuration that gives oscillators by their equation."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any

from pydantic import Field, Strict

from gearwear.config.key_types import Number, ReadNumber, Section, quantity

_Amplitude = Annotated[float, Field(ge=-5.0, le=5.0), ReadNumber]
_Phase = Annotated[float, Field(ge=-6.2832, le=6.2832), ReadNumber]
_Amplitudes = Annotated[list[_Amplitude], Strict()]
_Phases = Annotated[list[_Phase], Strict()]


def _amplitudes(of: str) -> Any:
    return quantity("1", f"Amplitudes of the harmonics 1, 2, ... of {of}; an empty list = none.", max_length=64)


def _phases() -> Any:
    return quantity("rad", "Their phases at mesh phase 0, one for every amplitude.", max_length=64)


class StiffnessWaves(Section):
    """Harmonics of the stiffness."""

    amplitudes: _Amplitudes = _amplitudes("the stiffness over its mean")
    phases: _Phases = _phases()


class ErrorWaves(Section):
    """Harmonics of the static transmission error."""

    amplitudes: _Amplitudes = _amplitudes("the transmission error over the half backlash")
    phases: _Phases = _phases()


class GivenOscillator(Section):
    """Oscillators given by their dimensionless equation; where there is one, the study is of them alone."""

    mean_force: Number = quantity("1", "Mean force over mean stiffness times half backlash.", ge=-100.0, le=100.0)
    stiffness: StiffnessWaves
    error: ErrorWaves


def unlike_waves(oscillator: dict[str, Any]) -> Iterator[tuple[tuple[str, ...], str]]:
    """Yield path and message of lists of harmonics of an oscillator that do not go together; absent ones are passed."""
    for wave in ("stiffness", "error"):
        lists = [oscillator.get(wave, {}).get(part) for part in ("amplitudes", "phases")]
        if None not in lists and len(lists[0]) != len(lists[1]):
            words = f"{len(lists[1])} phases for {len(lists[0])} amplitudes; give one phase for every amplitude"
            yield (wave, "phases"), words
    amplitudes = oscillator.get("error", {}).get("amplitudes")
    if amplitudes and not amplitudes[0] and any(amplitudes):
        words = "the first is 0 and another is not; all are scaled by the first, so give it a value, however small"
        yield ("error", "amplitudes"), words
