"""States of the pair, from new to worn: their colours, line styles and names."""

from __future__ import annotations

from typing import Any

# Okabe and Ito (2008), safe for colour-blind readers; the line styles tell the states apart in grey.
_COLOURS = ("#000000", "#0072B2", "#009E73", "#D55E00", "#CC79A7", "#E69F00")
_DASHES = ((), (5, 1.4), (5, 1.4, 1, 1.4), (1.6, 1.2), (8, 1.4), (8, 1.4, 1, 1.4, 1, 1.4))


def colour(position: int) -> str:
    """Return the colour of the state at this place in the list."""
    return _COLOURS[position % len(_COLOURS)]


def line(position: int, state: dict[str, Any]) -> dict[str, Any]:
    """Return colour, dashes and label of the line of a state."""
    return {"color": colour(position), "dashes": _DASHES[position % len(_DASHES)], "label": name(state)}


def name(state: dict[str, Any]) -> str:
    """Return bulk temperature and running cycles as a legend names them; plain text, so that it stays text in SVG."""
    return f"{temperature(state)}, {cycles(state)}"


def in_words(state: dict[str, Any]) -> str:
    """Return the case and its bulk temperature, for histories, whose abscissa holds the cycles."""
    return f"{state['case']}, {temperature(state)}"


def case(state: dict[str, Any]) -> str:
    """Return a title that names the case and its state."""
    return f"Case “{state['case']}”: {name(state) if 'bulk_temperature' in state else 'given by its equation'}"


def temperature(state: dict[str, Any]) -> str:
    """Return the bulk temperature as a label."""
    return f"{state['bulk_temperature']:g} °C"


def cycles(state: dict[str, Any]) -> str:
    """Return the running cycles of the pinion as a label."""
    count = state["running_cycles"]
    return f"{count / 1e9:g} × 10⁹ cycles" if count else "unworn"
