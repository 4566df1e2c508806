"""The data of the interactive page hold what the sweeps hold."""

import base64
import re
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from gearwear.figures import motion_classes, page

ROOT = Path(__file__).resolve().parents[3]

STEPS, LONGEST, SAMPLES, TEETH = 128, 10, 30, 20
STATE = {"case": "with", "cycle": 21, "bulk_temperature": 100.0, "running_cycles": 2.1e9, "flash": True}
PANEL = {"sweep": "mesh_frequency", "swept": {"first": 0.5, "last": 1.5}, "state": STATE}
PERIODS = np.array([2, 1, 0, 0])


@pytest.fixture(scope="module")
def sweep():
    """A sweep in falling order: period 2, period 1, chaos, and a motion that was lost."""
    rng = np.random.default_rng(1)
    section = rng.normal(size=(2, 4, SAMPLES))
    section[:, 3] = np.nan
    numbers = {
        "lyapunov_exponent": [-0.1, -0.2, 0.05, np.nan],
        "contact_loss_share": [0.25, 0.0, 0.5, np.nan],
        "force_max": [2.0, 1.5, 3.0, np.nan],
    }
    table = {name: ("point", np.array(values)) for name, values in numbers.items()}
    table |= {"motion_class": ("point", np.array([2, 1, 101, 0])), "period": ("point", PERIODS)}
    for name, values in zip(("displacement", "velocity"), section, strict=True):
        table[f"section_{name}"] = (("point", "sample"), values)
    return xr.Dataset(table, {"mesh_frequency": ("point", [1.4, 1.2, 1.0, 0.6])})


@pytest.fixture(scope="module")
def motions(sweep):
    """Orbits whose force is 1 + 0.5 cos of the mesh phase, with half an order for period 2 and for chaos."""
    time = np.arange(LONGEST * STEPS + 1) / STEPS
    force = np.full((4, time.size), np.nan)
    for i, periods in enumerate((2, 1, LONGEST)):
        own = time[: periods * STEPS + 1]
        force[i, : own.size] = 1 + 0.5 * np.cos(2 * np.pi * own) + 0.01 * (periods > 1) * np.cos(np.pi * own)
    table = {f"orbit_{name}": (("point", "time"), factor * force) for name, factor in FACTORS.items()}
    return xr.Dataset(
        table | {"natural_frequency": 1000.0},
        {"mesh_frequency": sweep["mesh_frequency"], "orbit_period": ("time", time)},
    )


FACTORS = {"displacement": 2.0, "velocity": -3.0, "force": 1.0}


@pytest.fixture(scope="module")
def record(sweep, motions):
    return page.record(PANEL, sweep, motions, TEETH)


def unpacked(packed):
    numbers = np.frombuffer(base64.b64decode(packed["data"]), "<u2")
    return packed["low"] + packed["step"] * numbers


def test_points_ascend_and_keep_their_numbers(record):
    assert record["value"] == [0.6, 1.0, 1.2, 1.4]
    assert record["class"] == ["not_converged", "CH", "P1", "P2"]
    assert record["exponent"] == [None, 0.05, -0.2, -0.1]
    assert record["rpm"][1] == pytest.approx(1.0 * 1000 / TEETH * 60 / (2 * np.pi), rel=1e-6)


def test_sections_and_orbits_are_those_of_the_sweep_to_16_bits(record, sweep, motions):
    assert record["dots"] == [0, SAMPLES, 1, 2]
    assert record["samples"] == [0, LONGEST * STEPS + 1, STEPS + 1, 2 * STEPS + 1]
    for packed, name in zip(record["section"], ("displacement", "velocity"), strict=True):
        values = sweep[f"section_{name}"].values
        expected = np.concatenate([values[2], values[1, :1], values[0, :2]])
        np.testing.assert_allclose(unpacked(packed), expected, atol=np.ptp(expected) / 65000)
    for packed, name in zip(record["orbit"], FACTORS, strict=True):
        values = motions[f"orbit_{name}"].values[::-1]
        expected = values[np.isfinite(values)]
        np.testing.assert_allclose(unpacked(packed), expected, atol=np.ptp(expected) / 65000)


def test_spectrum_has_the_lines_of_the_force(record):
    assert record["lines"] == [0, 10 * LONGEST, 10, 20]
    lines = np.frombuffer(base64.b64decode(record["spectrum"]), "<f4")
    chaos, one, two = np.split(lines, [10 * LONGEST, 10 * LONGEST + 10])
    np.testing.assert_allclose(one, [0.5, *[0.0] * 9], atol=1e-12)
    np.testing.assert_allclose(two, [0.01, 0.5, *[0.0] * 18], atol=1e-7)
    assert chaos[LONGEST - 1] == pytest.approx(0.5) and chaos[LONGEST // 2 - 1] == pytest.approx(0.01)


def test_the_page_needs_no_other_file_and_has_the_colours_of_the_figures(record):
    report = ROOT / "workflow" / "report"
    text = page.page(*((report / name).read_text() for name in ("page.html.j2", "page.js")), [record])
    assert not re.search(r"https?:|//[a-z]+\.[a-z]|\bimport\b|fetch\(|<link (?!rel=\"icon\" href=\"data:)", text)
    for name in ("P1", "P2", "CH"):
        assert f'<i style="background:{motion_classes.colour(name)}"></i>{name}<' in text
    assert text == page.page(*((report / name).read_text() for name in ("page.html.j2", "page.js")), [record])
