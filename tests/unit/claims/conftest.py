"""A small synthetic run in which every qualitative claim and the claims on sweeps used here hold."""

import numpy as np
import pytest
import xarray as xr

from gearwear.claims.study import Study

DIAGONAL = (("without", 0), ("middle", 1), ("with", 2))
BULK = {"without": 20.0, "middle": 60.0, "with": 100.0, "temperature_only": 100.0, "wear_only": 20.0}
START, PITCH, END, BASE_PITCH = 2e-3, 8e-3, 16e-3, 8.5e-3
LPSTC, HPSTC = END - BASE_PITCH, START + BASE_PITCH
RATIO = (END - START) / BASE_PITCH


def contact_path() -> tuple[np.ndarray, np.ndarray]:
    """Return the path nodes, doubled at the zone changes, and which of them are in double contact."""
    zones = [
        np.linspace(START, LPSTC, 161),
        np.union1d(np.linspace(LPSTC, HPSTC, 169), [PITCH]),
        np.linspace(HPSTC, END, 161),
    ]
    double = np.repeat([True, False, True], [zone.size for zone in zones])
    return np.concatenate(zones), double


def state(case: str, cycle: int) -> dict:
    """Return the datasets of one case and wear cycle."""
    path, double = contact_path()
    heat = (BULK[case] - 20) / 80
    wear_of_cycle = 1e-6 * cycle * np.abs(path - PITCH) / PITCH * np.where(double, 0.6, 1.0)
    fall = np.linspace(5e-6, 2e-6, path.size)
    phase = (np.arange(40) + 0.5) / 40
    two_pairs = phase < RATIO - 1
    pair_share = np.where(two_pairs, 2.0, 1.0)
    loss = 1 - 0.02 * heat - 1e-4 * cycle * pair_share
    rise = (0.3e-6 * heat + 0.2e-6 * cycle) * pair_share
    wear = np.array([wear_of_cycle * np.where(path < PITCH, 1.0, 0.2), 0.5 * wear_of_cycle])
    wear[1] *= np.where(path < PITCH, 1.0, 0.2)
    growth = heat * np.array([fall, fall[::-1]])
    deflection = np.where(double, 4e-6, 8e-6)
    bowl = heat * 0.02 * (path - PITCH) ** 2
    on_path = {"path": path}
    of_gears = {"gear": ["pinion", "gear"], "path": path}
    flash = np.abs(path - PITCH) * 1e3 * heat
    return {
        ("temperature", case): xr.Dataset(
            {
                "contact_temperature": ("path", BULK[case] + flash),
                "flash_sensitivity": ("influence", [1.1, 1.04, 1.08]),
            },
            {**on_path, "influence": ["friction", "speed", "load"]},
        ),
        ("deformation", case): xr.Dataset({"thermal_growth": (("gear", "path"), growth)}, of_gears),
        ("flash_growth", case): xr.Dataset({"thermal_growth_flash": (("gear", "path"), growth / 5)}, of_gears),
        ("wear", case, cycle): xr.Dataset({"wear_depth": (("gear", "path"), wear)}, of_gears),
        ("mesh_stiffness", case, cycle): xr.Dataset(
            {"mesh_stiffness": ("mesh_phase", 2e8 * pair_share * loss)}, {"mesh_phase": phase}
        ),
        ("transmission_error", case, cycle): xr.Dataset(
            {
                "transmission_error": ("mesh_phase", 1e-5 / pair_share + rise),
                "elastic_deflection": ("path", deflection),
            },
            {"mesh_phase": phase, **on_path},
        ),
        ("backlash", case, cycle): xr.Dataset({"backlash_path": ("path", 65e-6 + deflection + bowl)}, on_path),
    }


def sweep(name: str, swept, motion_class, displacement=None) -> xr.Dataset:
    """Return a sweep with a section of two samples."""
    swept = np.asarray(swept, dtype=float)
    section = np.zeros(swept.size) if displacement is None else np.asarray(displacement, dtype=float)
    return xr.Dataset(
        {
            "motion_class": ("point", np.asarray(motion_class)),
            "section_displacement": (("point", "sample"), np.stack([section, section], axis=1)),
            "section_velocity": (("point", "sample"), np.zeros((swept.size, 2))),
        },
        {name: ("point", swept)},
    )


@pytest.fixture
def results() -> dict:
    """Return the datasets of the synthetic run; a test may spoil its own copy."""
    datasets = {
        "geometry": xr.Dataset(
            {
                "pitch_point": PITCH,
                "lowest_single_contact": LPSTC,
                "highest_single_contact": HPSTC,
                "base_pitch": BASE_PITCH,
                "contact_ratio": RATIO,
            }
        )
    }
    for case, last in (("without", 0), ("middle", 1), ("with", 2), ("temperature_only", 0), ("wear_only", 2)):
        for cycle in range(last + 1):
            datasets.update(state(case, cycle))
    swept = np.linspace(0.1, 1.7, 161)
    for case, onset in (("without", 1.27), ("with", 1.23)):
        motion_class = np.select([swept < 1.045, swept < 1.185, swept < onset], [1, 2, 4], 101)
        datasets["sweep", case, "mesh_frequency"] = sweep(
            "mesh_frequency", swept, motion_class, np.where(swept < 0.595, 1.2, 0.7)
        )
    return datasets


@pytest.fixture
def study(results) -> Study:
    """Return the synthetic run as a study; it sees what a test changes in `results`."""
    return Study(results, DIAGONAL)


@pytest.fixture
def make_sweep():
    """Return the builder of synthetic sweeps."""
    return sweep


@pytest.fixture
def change():
    """Return a function that replaces a variable of one dataset by a function of itself."""

    def replace(results: dict, key, name: str, function) -> None:
        dataset = results[key].copy(deep=True)
        dataset[name] = function(dataset[name])
        results[key] = dataset

    return replace
