"""How figures name and mark the states of the pair, from new to worn, and the swept quantities."""

from __future__ import annotations

from typing import Any

# Okabe and Ito (2008), safe for colour-blind readers; the line styles tell the states apart in grey.
_COLOURS = ("#000000", "#0072B2", "#009E73", "#D55E00", "#CC79A7", "#E69F00")
_DASHES = ((), (5, 1.4), (5, 1.4, 1, 1.4), (1.6, 1.2), (8, 1.4), (8, 1.4, 1, 1.4, 1, 1.4))

SWEEPS = {
    "mesh_frequency": "Mesh frequency over natural frequency",
    "ste": "Mean static transmission error over that of the reference case",
    "backlash": "Mean backlash over its initial value",
}
# Of an oscillator that is given, not computed for a gear pair.
_OVER_THE_GIVEN = {"ste": "Transmission error over the one given", "backlash": "Clearance over the one given"}


def colour(position: int) -> str:
    """Return the colour of the state at this place in the list."""
    return _COLOURS[position % len(_COLOURS)]


def line(position: int, state: dict[str, Any]) -> dict[str, Any]:
    """Return colour, dashes and label of the line of a state."""
    return {"color": colour(position), "dashes": _DASHES[position % len(_DASHES)], "label": name(state)}


def name(state: dict[str, Any]) -> str:
    """Return bulk temperature and running cycles as a legend names them; plain text, so that it stays text in SVG."""
    return f"{temperature(state)}, {cycles(state)}"


def temperature(state: dict[str, Any]) -> str:
    """Return the bulk temperature as a label."""
    return f"{state['bulk_temperature']:g} °C"


def cycles(state: dict[str, Any]) -> str:
    """Return the running cycles of the pinion as a label."""
    count = state["running_cycles"]
    return f"{count / 1e9:g} × 10⁹ cycles" if count else "unworn"


def case(state: dict[str, Any]) -> str:
    """Return a title that names the case and its state."""
    return f"Case “{state['case']}”: {name(state) if 'bulk_temperature' in state else 'given by its equation'}"


def title(cfg: dict[str, Any], state: dict[str, Any], separator: str = ", ") -> str:
    """Return a title that names case, state and what the sweep `cfg["sweep"]` with settings `cfg["swept"]` holds."""
    return separator.join(filter(None, [case(state), held(cfg["sweep"], cfg["swept"])]))


def sweep(quantity: str, state: dict[str, Any]) -> str:
    """Return the swept quantity as an axis names it, for a state of the gear pair or a given oscillator."""
    given = {} if "bulk_temperature" in state else _OVER_THE_GIVEN
    return given.get(quantity, SWEEPS[quantity])


def length_unit(quantity: str, settings: dict[str, Any]) -> str:
    """Return in words what a displacement of this sweep is divided by."""
    rescaled = quantity == "backlash" and settings["reading"] == "rescale"
    return "swept half backlash" if rescaled else "initial half backlash"


def held(quantity: str, settings: dict[str, Any]) -> str:
    """Return what the sweep holds constant, or nothing."""
    if quantity == "mesh_frequency":
        return ""
    return f"mesh frequency / natural frequency = {settings['mesh_frequency']:g}"
