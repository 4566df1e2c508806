"""Maps over the mesh frequency and a second axis: motion classes beside the largest Lyapunov exponent."""

from __future__ import annotations

from typing import Any

import numpy as np
import xarray as xr
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from gearwear.figures import exponents, labels, motion_classes
from gearwear.figures.sheet import DOUBLE, letter, sheet

# Coordinate of the rows, its label and the factor to the unit of the label.
_ROWS = {
    "ste": ("ste", "Mean static transmission error\nover that of the reference case", 1.0),
    "backlash": ("backlash", labels.SWEEPS["backlash"], 1.0),
    "temperature": ("bulk_temperature", "Bulk temperature, °C", 1.0),
    "wear": ("running_cycles", "Revolutions of the pinion, 10⁹", 1e-9),
}
_COLOURS = "RdBu_r"


@sheet(DOUBLE, 92.0)
def draw(figure: Figure, parameter_map: xr.Dataset, cfg: dict[str, Any]) -> None:
    """Draw classes on the left, exponents on the right.

    Parameters
    ----------
    parameter_map : dataset with `motion_class` and `lyapunov_exponent` (row, column) and both coordinates.
    cfg : `map`, its name, and the `state` that is mapped; a map over a part of the state says so by its rows.
    """
    classes, exponent = figure.subplots(1, 2, sharex=True, sharey=True)
    coordinate, label, factor = _ROWS[cfg["map"]]
    edges = edges_of(parameter_map["mesh_frequency"].values), edges_of(factor * parameter_map[coordinate].values)
    codes, which = np.unique(parameter_map["motion_class"].values, return_inverse=True)
    names = [motion_classes.name_of(code) for code in codes]
    colours = np.array([to_rgb(motion_classes.colour(name)) for name in names])
    classes.pcolormesh(*edges, colours[which.reshape(parameter_map["motion_class"].shape)], rasterized=True)
    values = parameter_map["lyapunov_exponent"].values
    if np.isfinite(values).any():
        drawn = exponent.pcolormesh(*edges, values, norm=exponents.norm(values), cmap=_COLOURS, rasterized=True)
        figure.colorbar(drawn, ax=exponent, extend="min", aspect=30)
    classes.set_ylabel(label)
    for position, (axes, title) in enumerate(((classes, "motion class"), (exponent, "largest Lyapunov exponent"))):
        axes.set_title(f"{letter(position)} {title}", loc="left")
        axes.set_xlabel(labels.SWEEPS["mesh_frequency"])
    state, keys = cfg["state"], motion_classes.keys(names, hatched=False)
    titles = {"temperature": labels.cycles(state), "wear": labels.temperature(state)}
    title = f"Case “{state['case']}”: {titles.get(cfg['map'], labels.name(state))}"
    figure.legend(handles=keys, title=title, title_fontsize=7.5, loc="outside upper center", ncols=len(keys))


def edges_of(centres: np.ndarray) -> np.ndarray:
    """Return the edges of cells around ascending centres: midway between them, the outer cells symmetric."""
    if len(centres) == 1:
        return np.array([centres[0] - 0.5, centres[0] + 0.5])
    middles = (centres[1:] + centres[:-1]) / 2
    return np.concatenate([[2 * centres[0] - middles[0]], middles, [2 * centres[-1] - middles[-1]]])
