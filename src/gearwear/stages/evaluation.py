"""Stages that tell what a run used and found: parameters, versions, warnings, claims, the interactive page."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import xarray as xr
import yaml

from gearwear.claims import scorecard
from gearwear.config import origins
from gearwear.figures import page
from gearwear.figures import scorecard as scorecard_page
from gearwear.io.tables import Table, page_of
from gearwear.run.stage import log, report
from gearwear.validity import ranges


def parameters(cfg: dict[str, Any], files: list[Path], template: Path) -> dict[str, Any]:
    """Return every value of the configuration with unit, origin and meaning, as `csv` and `html`.

    Parameters
    ----------
    cfg : `configuration`, checked, and `command_line`, the values given there.
    files : of the configuration, each over the ones before it.
    """
    layers = [origins.file_layer(file.name, file.read_text(encoding="utf-8")) for file in files]
    layers.append(origins.command_line_layer(cfg["command_line"]))
    table = Table(origins.COLUMNS, list(origins.rows(cfg["configuration"], layers)))
    return {"csv": table, "html": page_of(table, template, "parameters")}


def versions(cfg: dict[str, str], template: Path) -> dict[str, Any]:
    """Return the versions of the packages, as `csv` and `html`."""
    table = Table(("package", "version"), sorted(cfg.items()))
    return {"csv": table, "html": page_of(table, template, "versions")}


def warnings(
    cfg: dict[str, Any],
    geometry: xr.Dataset,
    temperature: list[xr.Dataset],
    transmission_error: list[xr.Dataset],
    wear: list[xr.Dataset],
    response: list[xr.Dataset],
    template: Path,
) -> dict[str, Any]:
    """Return where the run leaves the range in which a law was fitted or tested, as `csv` and `html`.

    Parameters
    ----------
    cfg : the slice `warnings`; `cases`, the number of wear cycles of every case.
    temperature : of every case; transmission_error, wear, response : of every cycle of every case.
    """
    found = ranges.rows(_measured(cfg, geometry, *map(iter, (temperature, transmission_error, wear, response))))
    for row in found:
        report(ranges.sentence(row))
    table = Table(ranges.COLUMNS, found)
    return {"csv": table, "html": page_of(table, template, "warnings")}


def _measured(
    cfg: dict[str, Any], geometry: xr.Dataset, temperature: Any, transmission_error: Any, wear: Any, response: Any
) -> Iterator[ranges.Measured]:
    yield from ranges.of_pair(geometry)
    for case, cycles in cfg["cases"].items():
        yield from ranges.of_contact(case, geometry, next(temperature), cfg)
        steps = [(next(transmission_error), next(wear)) for _ in range(cycles)]
        yield from ranges.of_chain(case, steps, [int(next(response)["motion_class"]) for _ in range(cycles + 1)])


def claims(cfg: dict[str, Any], statements: Path, results: list[xr.Dataset]) -> Table:
    """Return the scorecard: how the results agree with the statements of the paper.

    Parameters
    ----------
    cfg : `states`, those of figures 6 to 11.
    results : all that the statements speak of.
    """
    diagonal = [(state["case"], state["cycle"]) for state in cfg["states"]]
    known = {_key_of(one.attrs["result"]): one for one in results}
    rows = scorecard.evaluate(yaml.safe_load(statements.read_text(encoding="utf-8")), known, diagonal)
    report(f"Claims of the paper: {scorecard.summary(rows)}.")
    return Table.of(rows)


def _key_of(result: str) -> Any:
    """Return the key of a result: CASE/STAGE/qNNN.nc, CASE/sweeps/restart/NAME.nc, CASE/STAGE.nc, STAGE.nc."""
    *above, name = Path(result).with_suffix("").parts
    if above[1:2] == ["sweeps"]:
        return "sweep", above[0], name
    if name.startswith("q") and name[1:].isdigit():
        return above[1], above[0], int(name[1:])
    return (name, *above) if above else name


def claims_page(statements: Path, scorecard: Path, sweeps: list[xr.Dataset], template: Path) -> str:
    """Return the scorecard as a page."""
    with open(scorecard, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    listed = yaml.safe_load(statements.read_text(encoding="utf-8"))["claims"]
    by_name = {_key_of(one.attrs["result"])[1:]: one for one in sweeps}
    return scorecard_page.page(template.read_text(encoding="utf-8"), rows, listed, by_name)


def motion_page(
    cfg: dict[str, Any],
    geometry: xr.Dataset | list[xr.Dataset],
    sweeps: list[xr.Dataset],
    motions: list[xr.Dataset],
    template: Path,
    program: Path,
) -> str:
    """Return the interactive page of all sweeps.

    Parameters
    ----------
    cfg : `panels`, a sweep each.
    geometry : empty for a prescribed oscillator.
    """
    teeth = int(geometry["teeth"][0]) if isinstance(geometry, xr.Dataset) else None
    panels = zip(cfg["panels"], sweeps, motions, strict=True)
    records = [page.record(panel, sweep, motion, teeth) for panel, sweep, motion in panels]
    text = page.page(template.read_text(encoding="utf-8"), program.read_text(encoding="utf-8"), records)
    log.info("%d sweeps, %.1f MB", len(records), len(text.encode()) / 1e6)
    return text
