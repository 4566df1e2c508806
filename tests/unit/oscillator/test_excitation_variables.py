"""What the file of an excitation holds, and that it comes back to the last bit."""

import numpy as np
import pytest
import xarray as xr

from gearwear.io import store
from gearwear.oscillator.excitation import Excitation
from gearwear.oscillator.excitation_variables import columns, recorded
from gearwear.oscillator.periodic import Harmonics, PeriodicTable
from gearwear.oscillator.translational import Bearing

RANDOM = np.random.default_rng(1991)
BEARINGS = {
    "pressure_angle": 0.35,
    "pinion": Bearing(*RANDOM.uniform(size=1), tuple(RANDOM.uniform(size=2).tolist()), 0.02),
    "gear": Bearing(*RANDOM.uniform(size=1), tuple(RANDOM.uniform(size=2).tolist()), 0.03),
}


def harmonics(mean, count):
    return Harmonics(mean, tuple(RANDOM.normal(size=count)), tuple(RANDOM.uniform(-np.pi, np.pi, count)))


def tables(cells=7):
    breaks = (0.0, *np.sort(RANDOM.uniform(size=cells - 1)), 1.0)
    return [PeriodicTable(breaks, *(tuple(RANDOM.uniform(0.5, 1.5, cells)) for _ in range(2))) for _ in range(2)]


def made(stiffness, shape, clearance, ratio=1.1):
    scalars = RANDOM.uniform(size=8).tolist()
    return Excitation(*scalars[:5], stiffness, shape, *scalars[5:7], ratio, clearance, scalars[7])


@pytest.mark.parametrize(
    "source",
    [
        made(harmonics(1.0, 1), harmonics(0.0, 1), Harmonics(1.07)),
        made(harmonics(1.0, 5), harmonics(0.0, 5), harmonics(0.97, 5), ratio=np.nan),
        made(*tables(), harmonics(1.0, 16)),
        made(*tables(), Harmonics(1.0)),
        made(Harmonics(1.0), Harmonics(0.0), Harmonics(1.0)),
        made(harmonics(1.0, 1), harmonics(0.0, 1), Harmonics(1.0))._replace(bearings=BEARINGS),
    ],
    ids=["first harmonic", "five harmonics", "tables", "tables and constant clearance", "no waves", "on bearings"],
)
def test_an_excitation_comes_back_from_its_file_to_the_last_bit(source, tmp_path):
    path = tmp_path / "excitation.nc"
    store.save(xr.Dataset(columns(source)), path, store.Origin("excitation", {}, "0" * 16))
    assert repr(recorded(store.load(path))) == repr(source)  # nan is not equal to itself, its text is
