"""The same configuration gives the same bytes; only another kind of processor may change the last digits."""

import os
import shutil
import subprocess
import sys

import numpy as np
import pytest
import xarray as xr

from gearwear.io import store
from gearwear.stages.motion import sweep, sweep_part

# Runs the jobs of stages one after another in one process; Snakemake starts a process for each.
RUNNER = """
import sys
from gearwear.run import stage
for file in sys.argv[1:]:
    given = {"__file__": file}
    exec(open(file).read().splitlines()[1], given)
    stage.run(given["snakemake"])
"""
# A processor without AVX and FMA, as numba, numpy, OpenBLAS and the mathematical library of the system see it.
PLAIN_PROCESSOR = {
    "NUMBA_CPU_NAME": "generic",
    "NUMBA_CPU_FEATURES": "",
    "NPY_DISABLE_CPU_FEATURES": "X86_V3 X86_V4",
    "OPENBLAS_CORETYPE": "Prescott",
    "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4,-AVX512F,-AVX512VL",
}
STATIC = (
    "results/geometry.nc",
    *(
        f"results/{case}/{name}.nc"
        for case in ("without", "with")
        for name in (
            "temperature",
            "deformation",
            "flash_growth",
            "wear/q000",
            "mesh_stiffness/q000",
            "transmission_error/q000",
            "backlash/q000",
        )
    ),
)
SWEEPS = tuple(f"results/without/sweeps/{order}/mesh_frequency.nc" for order in ("up", "down"))


def run(names, every_job, folder, **variables):
    """Run jobs of the smoke run anew on the results in a folder."""
    for name in names:
        (folder / name).unlink()
    files = dict.fromkeys(str(every_job[name].file) for name in names)
    command = [sys.executable, "-c", RUNNER, *files]
    done = subprocess.run(command, cwd=folder, env=os.environ | variables, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_another_folder_one_job_at_a_time_and_a_sweep_in_parts_give_the_same(smoke_run, tmp_path):
    targets = ["results/with/response/q001.nc", "results/figures/fig07.svg"]
    sweeps = [f"results/without/sweeps/{way}/mesh_frequency.nc" for way in ("restart", "up", "down")]
    configs = [str(smoke_run.folder / "config" / name) for name in ("config.yaml", "smoke.yaml")]
    arguments = ("-j1", "--directory", str(tmp_path), "--set-scatter", "sweep=4", "--configfile", *configs)
    again = smoke_run.snakemake(*arguments, "--", *targets, *sweeps)
    assert again.returncode == 0 and again.stdout.count("part 4-of-4") == 1, again.stdout
    for target in targets:
        assert (tmp_path / target).read_bytes() == (smoke_run.folder / target).read_bytes(), target
    for name in sweeps:  # which tell in their attributes that they were made of parts
        one, other = (xr.load_dataset(folder / name) for folder in (smoke_run.folder, tmp_path))
        assert one.identical(other.assign_attrs(one.attrs)), name


@pytest.mark.parametrize("count", [1, 2, 7])
def test_any_number_of_parts_gives_the_same_sweep(every_job, smoke_run, count):
    job = every_job["results/without/sweeps/restart/mesh_frequency.nc"].job
    cfg, excitation = job.params.cfg, store.load(smoke_run.folder / job.input.excitation)
    parts = [sweep_part(cfg, excitation, "mesh_frequency", slice(n, None, count)) for n in range(count)]
    assert [part.sizes["point"] for part in parts] == [len(range(n, 17, count)) for n in range(count)]
    joined = sweep(cfg, excitation, parts, "mesh_frequency")["restart"]
    whole = store.load(smoke_run.folder / job.output.restart)
    assert joined.drop_attrs().identical(whole.drop_attrs())


def test_the_number_of_threads_changes_nothing(every_job, copied, smoke_run):
    names = ("results/with/mesh_stiffness/q001.nc", "results/with/response/q001.nc", SWEEPS[0])
    for count in ("1", "2"):
        run(names, every_job, copied, OMP_NUM_THREADS=count, OPENBLAS_NUM_THREADS=count, NUMBA_NUM_THREADS=count)
        for name in names:
            assert (copied / name).read_bytes() == (smoke_run.folder / name).read_bytes(), (name, count)


@pytest.fixture
def cold_cache(long, tmp_path):
    """An empty folder for machine code."""
    if not long:
        pytest.skip("compiling all kernels takes long; asked for by --long")
    return str(tmp_path / "cache")


def test_a_cold_cache_changes_nothing(every_job, copied, smoke_run, cold_cache):
    names = ("results/with/response/q001.nc", *SWEEPS, "results/without/branches/mesh_frequency.nc")
    for _ in ("cold", "warm"):
        run(names, every_job, copied, GEARWEAR_CACHE=cold_cache)
        for name in names:
            assert (copied / name).read_bytes() == (smoke_run.folder / name).read_bytes(), name


def difference(here, there, name) -> tuple[float, str]:
    """Return the largest difference of a variable between two files, over its largest value, and its name.

    Growth, and with it every length, is a difference of arcs on the base circles, with the round-off of their radius.
    The effective stiffness is a force over such a length, the deflection.
    """
    radius = float(xr.load_dataset(here / "results/geometry.nc", decode_times=False)["base_radius"].max())
    one, other = (xr.load_dataset(folder / name, decode_times=False) for folder in (here, there))
    apart = [(0.0, "")]
    for variable in one.variables:
        a, b = one[variable].values, other[variable].values
        if a.dtype.kind == "f":
            largest = np.nanmax(abs(a), initial=radius if one[variable].attrs.get("units") == "m" else 0.0)
            if variable == "effective_stiffness":
                largest *= radius / float(one["elastic_deflection"].max())
            apart.append((np.nanmax(abs(a - b), initial=0.0) / (largest or 1.0), f"{name}: {variable}"))
        else:
            assert np.array_equal(a, b), (name, variable)
    return max(apart)


def test_another_kind_of_processor_changes_the_last_digits(every_job, smoke_run, tmp_path):
    shutil.copytree(smoke_run.folder / "results", tmp_path / "results")
    run(STATIC, every_job, tmp_path, **PLAIN_PROCESSOR)
    apart = max(difference(smoke_run.folder, tmp_path, name) for name in STATIC)
    print(apart)
    assert apart[0] < 4e-15  # measured: 4.6e-16
