"""The curves of figures 6 to 12 of two runs, one over the other."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import matplotlib
import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from gearwear.compare import results_folder
from gearwear.errors import BadFile
from gearwear.figures import contact_axes, labels, sections
from gearwear.figures.sheet import DOUBLE, MILLIMETRE, SINGLE
from gearwear.io.atomic import atomic

_STYLE: dict[Any, Any] = {
    "font.size": 7,
    "axes.titlesize": 7,
    "axes.linewidth": 0.6,
    "lines.linewidth": 1.0,
    "legend.frameon": False,
    "savefig.dpi": 200,
    "svg.fonttype": "none",
    "svg.hashsalt": "gearwear",
}
# Okabe and Ito (2008), safe for colour-blind readers; the second run is dashed, so that the first shows below it.
_RUNS: tuple[dict[str, Any], ...] = ({"color": "#0072B2"}, {"color": "#D55E00", "dashes": (3, 1.5)})
# Places, mm.
_ROW, _HEAD, _FOOT, _BETWEEN_ROWS = 40.0, 14.0, 9.0, 9.0
_LEFT, _RIGHT, _BETWEEN_COLUMNS, _LABEL = 15.0, 3.0, 17.0, 12.0
_NOTHING = 1e-3  # um; below, a curve is round-off

Draw = Callable[[Axes, xr.Dataset, xr.Dataset, dict[str, Any]], None]


class Curve(NamedTuple):
    """Label of the ordinate, result file of a case (the last of its wear cycles), and how it is drawn."""

    label: str
    file: str
    draw: Draw


def overlay(a: str | Path, b: str | Path, folder: str | Path) -> list[Path]:
    """Draw the curves of figures 6 to 12 of two results folders, a row for every case that both have.

    Parameters
    ----------
    a, b : results folders, or the folders that hold them.
    folder : where the figures are written, as ``fig06.png``, ``fig06.svg``, ...; made if there is none.

    Returns
    -------
    list of Path
        The files written; a figure is left out if no case has its results in both runs.

    Raises
    ------
    BadFile : the runs have no case in common, or the folder cannot be written.
    """
    runs = [results_folder(a), results_folder(b)]
    geometries = [run / "geometry.nc" for run in runs]
    if not all(path.exists() for path in geometries):
        raise BadFile(f"figures: {a} and {b} must be two results folders with geometry.nc")
    pairs = [xr.load_dataset(path) for path in geometries]
    folder = Path(folder)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise BadFile(f"{folder}: cannot be made ({error.strerror})") from None
    written: list[Path] = []
    with matplotlib.rc_context(_STYLE):
        for name, curves in _FIGURES.items():
            rows = list(_rows(runs, curves))
            if rows:
                written += _write(_figure(rows, curves, pairs, (str(a), str(b))), folder / name)
    if not written:
        raise BadFile(f"figures: {a} and {b} have no case in common")
    return written


def _rows(runs: Sequence[Path], curves: Sequence[Curve]) -> Iterator[tuple[str, list[list[xr.Dataset]]]]:
    """Yield every case of both runs, with its datasets by curve and run."""
    cases = sorted({path.name for path in runs[0].iterdir()} & {path.name for path in runs[1].iterdir()})
    for case in cases:
        files = [[path for run in runs for path in _last(run / case, curve.file)] for curve in curves]
        if all(len(both) == len(runs) for both in files):
            yield case, [[xr.load_dataset(path) for path in both] for both in files]


def _last(case: Path, file: str) -> list[Path]:
    """Return the last file of a series, such as that of the wear cycles, in a list; an empty one if there is none."""
    return sorted(case.glob(file), key=lambda path: (len(path.name), path.name))[-1:]


def _figure(
    rows: Sequence[tuple[str, list[list[xr.Dataset]]]],
    curves: Sequence[Curve],
    pairs: Sequence[xr.Dataset],
    names: tuple[str, str],
) -> Figure:
    width = DOUBLE if len(curves) > 1 else SINGLE
    height = _HEAD + _FOOT + _ROW * len(rows) - _BETWEEN_ROWS
    figure = Figure(figsize=(width * MILLIMETRE, height * MILLIMETRE))
    panel = (width - _LEFT - _RIGHT - _BETWEEN_COLUMNS * (len(curves) - 1)) / len(curves)
    figure.subplots_adjust(
        left=_LEFT / width,
        right=1 - _RIGHT / width,
        bottom=_FOOT / height,
        top=1 - _HEAD / height,
        wspace=_BETWEEN_COLUMNS / panel,
        hspace=_BETWEEN_ROWS / (_ROW - _BETWEEN_ROWS),
    )
    panels = figure.subplots(len(rows), len(curves), sharex="col", squeeze=False)
    for row, (case, datasets) in enumerate(rows):
        for column, (curve, both) in enumerate(zip(curves, datasets, strict=True)):
            axes = panels[row, column]
            for dataset, pair, line in zip(both, pairs, _RUNS, strict=True):
                curve.draw(axes, pair, dataset, line)
            axes.set_title(case, loc="left")
            axes.set_ylabel(curve.label)
            axes.yaxis.set_label_coords(-_LABEL / panel, 0.5)
            if row + 1 < len(rows):
                axes.set_xlabel("")
    keys = [Line2D([], [], label=f"{run}: {name}", **line) for run, name, line in zip("AB", names, _RUNS, strict=True)]
    figure.legend(handles=keys, loc="upper center", ncols=2 if width == DOUBLE else 1)
    return figure


def _write(figure: Figure, path: Path) -> Iterator[Path]:
    for suffix, metadata in ((".png", {"Software": None}), (".svg", {"Date": None, "Creator": None})):
        with atomic(path.with_suffix(suffix)) as temporary:
            figure.savefig(temporary, format=suffix[1:], metadata=metadata)
        yield path.with_suffix(suffix)


def _on_path(field: Callable[[xr.Dataset], xr.DataArray]) -> Draw:
    def draw(axes: Axes, pair: xr.Dataset, dataset: xr.Dataset, line: dict[str, Any]) -> None:
        contact_axes.draw_along_path(axes, field(dataset), 1e6, **line)
        if np.abs(axes.dataLim.intervaly).max() < _NOTHING:
            axes.set_ylim(-0.05, 0.05)
        else:
            axes.set_ylim(auto=True)
        contact_axes.mark_path(axes, pair)

    return draw


def _over_the_mesh(name: str, scale: float) -> Draw:
    def draw(axes: Axes, pair: xr.Dataset, dataset: xr.Dataset, line: dict[str, Any]) -> None:
        contact_axes.draw_over_phase(axes, pair, scale * dataset[name].values, **line)
        contact_axes.mark_phase(axes, pair)

    return draw


def _sections(axes: Axes, _pair: xr.Dataset, sweep: xr.Dataset, line: dict[str, Any]) -> None:
    displacement, dots = sweep["section_displacement"].values, np.logical_or(*sections.chosen(sweep))
    place = np.broadcast_to(sweep["mesh_frequency"].values[:, None], displacement.shape)
    axes.plot(place[dots], displacement[dots], ".", markersize=0.8, color=line["color"], rasterized=True)
    axes.set_xlabel(labels.SWEEPS["mesh_frequency"])


def _exponents(axes: Axes, _pair: xr.Dataset, sweep: xr.Dataset, line: dict[str, Any]) -> None:
    axes.plot(sweep["mesh_frequency"].values, sweep["lyapunov_exponent"].values, **line)
    axes.axhline(0, color="black", linewidth=0.4)
    axes.set_xlabel(labels.SWEEPS["mesh_frequency"])


_WEAR, _GROWTH, _ERROR = "wear/q*.nc", "deformation.nc", "transmission_error/q*.nc"
_SWEEP = "sweeps/restart/mesh_frequency.nc"
_GEARS = ("pinion", "gear")


def _of_gear(name: str, gear: str) -> Draw:
    return _on_path(lambda dataset: dataset[name].sel(gear=gear))


_FIGURES: dict[str, tuple[Curve, ...]] = {
    "fig06": tuple(Curve(f"Wear depth, {gear} (µm)", _WEAR, _of_gear("wear_depth", gear)) for gear in _GEARS),
    "fig07": tuple(Curve(f"Thermal growth, {gear} (µm)", _GROWTH, _of_gear("thermal_growth", gear)) for gear in _GEARS),
    "fig08": (
        Curve("Mesh stiffness (10⁸ N/m)", "mesh_stiffness/q*.nc", _over_the_mesh("mesh_stiffness", 1e-8)),
        Curve("Effective stiffness (10⁸ N/m)", _ERROR, _over_the_mesh("effective_stiffness", 1e-8)),
    ),
    "fig09": (Curve("Transmission error (µm)", _ERROR, _over_the_mesh("transmission_error", 1e6)),),
    "fig10": (
        Curve("Growth, four flanks (µm)", _GROWTH, _on_path(lambda data: 2 * data["thermal_growth"].sum("gear"))),
        Curve("Elastic deflection (µm)", _ERROR, _on_path(lambda data: data["elastic_deflection"])),
        Curve("Wear, both flanks (µm)", _WEAR, _on_path(lambda data: data["wear_depth"].sum("gear"))),
    ),
    "fig11": (Curve("Half backlash (µm)", "backlash/q*.nc", _on_path(lambda data: data["backlash_path"])),),
    "fig12": (
        Curve("Section displacement", _SWEEP, _sections),
        Curve("Lyapunov exponent", _SWEEP, _exponents),
    ),
}
