"""Maps over two parameters, tile by tile."""

import numpy as np
import pytest
import xarray as xr

from gearwear.codes.motion_class import CHAOTIC

SCATTERED = ("--set-scatter", "map=2", "--")
MAPS = ("results/with/maps/wear.nc", "results/figures/map_ste.svg")


@pytest.fixture(scope="module")
def mapped(smoke_run):
    run = smoke_run.snakemake("-j2", *smoke_run.smoke(), *SCATTERED, *MAPS)
    assert run.returncode == 0, run.stdout[-5000:]
    return smoke_run


def opened(project, place):
    return xr.open_dataset(project.folder / "results" / place)


def test_the_last_wear_cycle_is_a_row_like_the_sweep(mapped):
    found, sweep = opened(mapped, "with/maps/wear.nc"), opened(mapped, "with/sweeps/restart/mesh_frequency.nc")
    assert found["running_cycles"].values.tolist() == [0.0, 1e8, 2e8, 3e8]
    np.testing.assert_array_equal(found["mesh_frequency"], sweep["mesh_frequency"])
    for name in found.data_vars:
        np.testing.assert_array_equal(found[name][-1], sweep[name])
    assert (found["lyapunov_exponent"][0].values != found["lyapunov_exponent"][-1].values).all()


def test_a_row_of_the_transmission_error_is_what_the_sweep_says_there(mapped):
    found, sweep = opened(mapped, "with/maps/ste.nc"), opened(mapped, "with/sweeps/restart/ste.nc")
    column = int(np.argmin(abs(found["mesh_frequency"].values - 1.0)))
    np.testing.assert_allclose(found["mesh_frequency"][column], 1.0, rtol=1e-12)
    for row, point in ((0, 0), (-1, -1)):
        assert found["ste"][row] == sweep["ste"][point]
        assert found["motion_class"][row, column] == sweep["motion_class"][point]
        if sweep["motion_class"][point] != CHAOTIC:  # the last bit of the frequency differs, and chaos makes it grow
            np.testing.assert_allclose(
                found["lyapunov_exponent"][row, column], sweep["lyapunov_exponent"][point], atol=1e-6
            )


def test_only_a_lost_tile_is_made_anew(mapped):
    lost = mapped.folder / "results/with/maps/tiles/ste/2-of-2.nc"
    kept = mapped.folder / "results/with/maps/tiles/ste/1-of-2.nc"
    made = kept.stat().st_mtime_ns
    lost.unlink()
    (mapped.folder / "results/with/maps/ste.nc").unlink()
    run = mapped.snakemake("-j2", *mapped.smoke(), *SCATTERED, "results/with/maps/ste.nc")
    assert run.returncode == 0, run.stdout[-5000:]
    assert "tile 2-of-2" in run.stdout and "tile 1-of-2" not in run.stdout
    assert kept.stat().st_mtime_ns == made


def test_many_points_make_many_tiles_but_no_empty_ones(mapped):
    axes = {"mesh_frequency": {"points": 1000}, "ste": {"points": 1000}, "backlash": {"points": 20}}
    counts = {"ste": 200, "backlash": 4, "wear": 2}
    targets = [f"results/with/maps/{name}.nc" for name in counts]
    files = mapped.summary(*mapped.smoke({"maps": axes}), *SCATTERED, *targets)
    for name, count in counts.items():
        assert sum(file.startswith(f"results/with/maps/tiles/{name}/") for file in files) == count, name


def test_every_row_of_the_temperature_map_has_the_state_of_its_own_chain(mapped):
    run = mapped.snakemake("-j2", *mapped.smoke(), *SCATTERED, "results/with/maps/temperature.nc")
    assert run.returncode == 0, run.stdout[-5000:]
    assert len(list((mapped.folder / "results/studies/chains").glob("with_*.nc"))) == 2
    found, wear = (opened(mapped, f"with/maps/{name}.nc") for name in ("temperature", "wear"))
    assert found["bulk_temperature"].values.tolist() == [60.0, 100.0]
    for name in found.data_vars:
        np.testing.assert_array_equal(found[name][-1], wear[name][-1])  # 100 degC is the state of case `with`
    assert (found["lyapunov_exponent"][0].values != found["lyapunov_exponent"][-1].values).any()
