"""The motions along sweeps as one interactive page: its data, and the page around them."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray as xr

from gearwear.figures import labels, motion_classes, sections
from gearwear.io.tables import render
from gearwear.oscillator.spectrum import spectrum

HIGHEST = 10  # order of the mesh frequency
_MOST_DOTS = 60  # of the section of a motion that does not repeat, in the diagram
_STEP_COUNT = 65534  # of the numbers of a packed array


def record(panel: dict[str, Any], sweep: xr.Dataset, motions: xr.Dataset, teeth: int | None) -> dict[str, Any]:
    """Return what the page shows of one sweep, as plain values.

    Numbers a point are given as they are, but the many of sections and orbits on a scale of 16 bits over their range,
    spectra as single floats. A point without a motion has none of these.

    Parameters
    ----------
    panel : `sweep`, its settings `swept` and the `state`.
    sweep : sections, classes and exponents.
    motions : orbits and mesh force at the same points, with the natural frequency.
    teeth : of the pinion; None for an oscillator without a pair, which has no speed.
    """
    name = panel["sweep"]
    order = np.argsort(sweep[name].values, kind="stable")
    sweep, motions = sweep.isel(point=order), motions.isel(point=order)
    values = sweep[name].values
    ratio = values if name == "mesh_frequency" else np.full(len(values), panel["swept"]["mesh_frequency"])
    rpm = np.full(len(values), np.nan)
    if teeth is not None:
        rpm = ratio * float(motions["natural_frequency"]) / teeth * 60 / (2 * np.pi)
    repeats, endless = sections.chosen(sweep)
    dots = repeats | endless
    orbits = [motions[f"orbit_{which}"].values for which in ("displacement", "velocity", "force")]
    there = np.isfinite(orbits[0])
    steps = round(1 / float(motions["orbit_period"][1]))
    lines = [_lines(force[inside], steps) for force, inside in zip(orbits[2], there, strict=True)]
    return {
        "case": panel["state"]["case"],
        "sweep": name,
        "title": labels.case(panel["state"]),
        "condition": labels.held(name, panel["swept"]),
        "label": labels.sweep(name, panel["state"]),
        "unit": labels.length_unit(name, panel["swept"]),
        "steps": steps,
        "longest": round(float(motions["orbit_period"][-1])),
        "most_dots": _MOST_DOTS,
        "value": _numbers(values),
        "rpm": _numbers(rpm),
        "class": [motion_classes.name_of(code) for code in sweep["motion_class"].values],
        "period": [int(period) for period in sweep["period"].values],
        "exponent": _numbers(sweep["lyapunov_exponent"].values),
        "loss": _numbers(sweep["contact_loss_share"].values),
        "peak": _numbers(sweep["force_max"].values),
        "dots": dots.sum(axis=1).tolist(),
        "section": [_packed(sweep[f"section_{which}"].values[dots]) for which in ("displacement", "velocity")],
        "samples": there.sum(axis=1).tolist(),
        "orbit": [_packed(orbit[there]) for orbit in orbits],
        "lines": [len(amplitudes) for amplitudes in lines],
        "spectrum": _text(np.concatenate(lines).astype("<f4")),
    }


def page(template: str, program: str, records: Sequence[dict[str, Any]]) -> str:
    """Return the page as HTML that needs no other file.

    Parameters
    ----------
    template : of the page, Jinja.
    program : its JavaScript.
    records : as `record` gives them.
    """
    names = sorted({name for one in records for name in one["class"]}, key=motion_classes.rank)
    colour = {name: motion_classes.colour(name) for name in names}
    key: dict[str, str] = {}
    for name, tint in colour.items():
        key[tint] = "other period" if tint in key else name.replace("not_converged", "not decided")
    data = {"colour": colour, "highest": HIGHEST, "sweeps": list(records)}
    shown = {"data": data, "program": program, "records": records, "key": key, "longest": records[0]["longest"]}
    return render(template, **shown)


def _lines(force: np.ndarray, steps: int) -> np.ndarray:
    """Return the amplitudes of the force at multiples of 1/periods of the mesh frequency; its last sample closes it."""
    if not force.size:
        return np.zeros(0)
    history = force[:-1].reshape(-1, steps)
    return spectrum(history, np.arange(steps) / steps, np.full(steps, 1 / steps), HIGHEST)[1]


def _numbers(values: np.ndarray) -> list[float | None]:
    return [float(f"{value:.7g}") if np.isfinite(value) else None for value in values]


def _packed(values: np.ndarray) -> dict[str, Any]:
    """Return the values as whole numbers of 16 bits on a scale from the least to the greatest."""
    low, high = (float(values.min()), float(values.max())) if values.size else (0.0, 0.0)
    step = (high - low) / _STEP_COUNT or 1.0
    return {"low": low, "step": step, "data": _text(np.round((values - low) / step).astype("<u2"))}


def _text(values: np.ndarray) -> str:
    return base64.b64encode(values.tobytes()).decode("ascii")
