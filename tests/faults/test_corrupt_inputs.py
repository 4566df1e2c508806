"""A spoiled file in place of an intermediate result is named, with what to do, and nothing is computed from it."""

import json
import shutil
from pathlib import Path
from types import SimpleNamespace

import netCDF4
import numpy as np
import pytest
import xarray as xr

from gearwear.errors import BadFile
from gearwear.io import store
from gearwear.io.variables import variable_of
from gearwear.run import stage

REMEDY = "run the workflow again"


def truncated(path):
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])


def empty(path):
    path.write_bytes(b"")


def text(path):
    path.write_text("time,value\n0,1\n")


def folder(path):
    path.unlink()
    path.mkdir()


def missing(path):
    path.unlink()


def foreign(path):
    path.unlink()
    xr.Dataset({"temperature": ("time", [280.0, 281.0])}).to_netcdf(path)


def another_result(path):
    with netCDF4.Dataset(path, "a") as file:
        file.result = "geometry.nc" if file.result != "geometry.nc" else "with/temperature.nc"


def of_an_older_layout(path):
    with netCDF4.Dataset(path, "a") as file:
        file.delncattr("result")


def not_finite(path):
    with netCDF4.Dataset(path, "a") as file:
        for name, variable in file.variables.items():
            kind = variable.dtype if variable.dtype is str else variable.dtype.kind
            if kind == "f" and not variable_of(name, variable.dimensions).may_be_missing:
                variable[...] = np.nan
                return


def of_other_settings(path):
    """A file of another configuration has the same variables: its settings tell."""
    with netCDF4.Dataset(path, "a") as file:
        settings = json.loads(file.config)
        group = settings
        while isinstance(next(iter(group.values())), dict):
            group = next(iter(group.values()))
        group[next(iter(group))] = 12345
        file.config = json.dumps(settings)


def of_other_files(path):
    """A file made of another geometry, other wear and so on, with the same settings of its own."""
    with netCDF4.Dataset(path, "a") as file:
        file.inputs = json.dumps(dict.fromkeys(json.loads(file.inputs), "0" * 16))
        file.lineage = "0" * 16


def on_another_grid(path):
    with xr.open_dataset(path, decode_times=False) as lazy:
        whole = lazy.load()
    path.unlink()
    whole.isel(path=slice(None, -1)).to_netcdf(path)


UNREADABLE = (truncated, empty, text, folder)
DEFECTS = (
    *UNREADABLE,
    missing,
    foreign,
    another_result,
    of_an_older_layout,
    not_finite,
    of_other_settings,
    of_other_files,
    on_another_grid,
)
# Seen where the geometry is read beside the file, for the files of a state of the flanks.
COMPARED = (of_other_files, on_another_grid)
POINTS = {"sweep", "branches", "portraits", "basins"}
UNSEEN = {
    of_other_settings: {"unworn"},  # which has no settings
    of_other_files: POINTS,
    on_another_grid: POINTS,
}


def kinds(jobs, spoil, whole):
    """Return a job and one of the files that it reads, for every kind of file, or for every kind and reader of it."""
    found = {}
    for rule, one in jobs.items():
        if spoil in COMPARED and not ("geometry" in dict(one.files) and len(one.files) > 1):
            continue
        for _, path in one.files:
            with netCDF4.Dataset(one.file.parents[2] / path) as file:
                kind = (file.stage, Path(path).parent.name, rule if whole else "")
                if file.stage not in UNSEEN.get(spoil, ()):
                    found.setdefault(kind, (one.job, path))
    return list(found.values())


@pytest.mark.parametrize("spoil", DEFECTS, ids=lambda spoil: spoil.__name__)
def test_spoiled_file_is_named(jobs, copied, long, tell, monkeypatch, spoil):
    monkeypatch.chdir(copied)
    missed = []
    tried = kinds(jobs, spoil, long)
    assert len(tried) > 8
    for job, path in tried if long else tried[DEFECTS.index(spoil) % 3 :: 3]:
        spoiled, outputs = copied / path, [copied / output for output in job.output]
        kept = copied / "kept.nc"
        shutil.copy2(spoiled, kept)
        before = [output.read_bytes() for output in outputs]
        try:
            spoil(spoiled)
            told = tell(job)
        finally:
            shutil.rmtree(spoiled) if spoiled.is_dir() else spoiled.unlink(missing_ok=True)
            kept.rename(spoiled)
        clear = "failed: " in told and path in told and REMEDY in told and "Traceback" not in told
        unread = spoil is not_finite and not told  # the values of a file that no claim asks for
        if not (clear or unread) or [output.read_bytes() for output in outputs] != before:
            missed.append(f"{job.rule} reads {path}: {told}")
    assert not missed, "\n".join(missed)


OTHERS = (
    "with/maps/tiles/ste/1-of-16.nc",
    "with/maps/ste.nc",
    "with/onsets.nc",
    "with/onset_variants.nc",
    "onset_shifts.nc",
    "sensitivity.nc",
    "studies/sensitivity/study/measures.nc",
    "studies/chains/q000.nc",
    "studies/life/t020/outcome.nc",
    "studies/life/study.nc",
    "calibration/searches/1.nc",
)


@pytest.mark.parametrize("place", OTHERS)
@pytest.mark.parametrize(
    "spoil",
    [*UNREADABLE, missing, foreign, another_result, of_an_older_layout, not_finite],
    ids=lambda spoil: spoil.__name__,
)
def test_spoiled_file_of_a_target_beside_all_is_named(tmp_path, monkeypatch, place, spoil):
    monkeypatch.chdir(tmp_path)
    path = Path("results", place)
    path.parent.mkdir(parents=True)
    store.save(xr.Dataset({"running_cycles": 0.0}), path, store.Origin("a_stage", {}, "0" * 16))
    job = SimpleNamespace(input={"it": str(path)}, config={})
    assert stage.load(job, {})["it"]["running_cycles"] == 0.0
    spoil(path)
    with pytest.raises(BadFile, match=f"{path}: .*{REMEDY}"):
        stage.load(job, {})
