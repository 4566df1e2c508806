"""Result files: complete or not at all, described, reproducible, with a lineage of what made them."""

import json
import os
from pathlib import Path

import netCDF4
import numpy as np
import pytest
import xarray as xr

from gearwear import __version__
from gearwear.errors import BadFile
from gearwear.io import store
from gearwear.io.variables import variable_of, variables

SETTINGS = {"b": 1.5, "a": {"d": 2, "c": "x"}}


def origin(stage="unworn", config=SETTINGS, code="aaaa", **inputs):
    """Return what makes a result of these datasets."""
    return store.Origin(stage, config, code, store.lineages(inputs))


def flanks(depth=0.0):
    return xr.Dataset(
        {"wear_depth": (("gear", "path"), np.full((2, 3), depth)), "running_cycles": 0.0},
        {"path": [1e-3, 2e-3, 3e-3], "gear": ["pinion", "gear"]},
    )


@pytest.fixture
def saved(tmp_path):
    path = tmp_path / "q000.nc"
    store.save(flanks(1e-6), path, origin())
    return path


def test_what_is_saved_is_loaded(saved):
    found = store.load(saved)
    xr.testing.assert_equal(found, flanks(1e-6))
    assert found["gear"].values.tolist() == ["pinion", "gear"]


def test_every_variable_carries_its_unit_and_name(saved):
    with netCDF4.Dataset(saved) as file:
        for name, variable in file.variables.items():
            assert variable.long_name == variables()[name].long_name
            assert getattr(variable, "units", "") == variables()[name].units
        assert file["wear_depth"].units == "m"
        assert file["running_cycles"].units == "1"
        assert "_FillValue" not in file["wear_depth"].ncattrs()


def test_every_field_has_a_unit_unless_it_is_a_label_or_an_index():
    without = {name for name, field in variables().items() if not field.units}
    integers_and_words = {
        "gear",
        "pair",
        "influence",
        "partner",
        "entering",
        "leaving",
        "motion_class",
        "reason",
        "conflict",
        "basin",
    }
    integers_and_words |= {"branch_index", "branch_parent", "stable", "special_point"}
    integers_and_words |= {f"branch_{side}{rest}" for side in ("start", "end") for rest in ("", "_remark")}
    integers_and_words |= {"event", "variant", "error", "member", "parameter", "onset_how", "onset_remark"}
    integers_and_words |= {f"member_{what}_{case}" for what in ("how", "remark") for case in ("without", "with")}
    integers_and_words |= {"case", "hindrance", "group", "key", "value", "usual_value", "companions"}
    integers_and_words |= {"first_doubling_remark", "chaos_onset_remark"}
    integers_and_words |= {"order", "member_name", "running_class", "bearing_direction"}
    integers_and_words |= {"claim", "sweep", "claim_subject", "candidate_remark"}
    assert without == integers_and_words
    assert all(field.long_name and field.dims for field in variables().values())


def test_flags_are_written_with_their_meanings(tmp_path):
    path = tmp_path / "sweep.nc"
    points = xr.Dataset({"motion_class": ("point", np.array([1, 101], dtype=np.int16))}, {"ste": ("point", [0.5, 1.0])})
    store.save(points, path, origin())
    found = store.load(path)["motion_class"]
    meanings = dict(zip(found.flag_meanings.split(), found.flag_values.tolist(), strict=True))
    assert (meanings["P1"], meanings["CH"], meanings["not_converged"]) == (1, 101, 0)


def test_saving_leaves_the_dataset_of_the_caller_as_it_was(tmp_path):
    mine = flanks()
    mine["wear_depth"].attrs["note"] = "mine"
    store.save(mine, tmp_path / "q000.nc", origin())
    assert mine.attrs == {}
    assert mine["wear_depth"].attrs == {"note": "mine"}


def test_same_settings_give_the_same_bytes(tmp_path):
    paths = [tmp_path / name / "q000.nc" for name in ("one", "two")]
    for path in paths:
        path.parent.mkdir()
        store.save(flanks(1e-6), path, origin())
    assert paths[0].read_bytes() == paths[1].read_bytes()


def test_no_time_host_or_folder_is_written(saved):
    content = saved.read_bytes()
    assert os.fsencode(saved.parent) not in content
    assert os.uname().nodename.encode() not in content
    attributes = {"Conventions", "title", "source", "version", "result"}
    assert set(store.load(saved).attrs) == attributes | {"stage", "config", "code", "inputs", "lineage"}


def test_a_file_tells_its_program_its_stage_and_its_settings(saved):
    found = store.load(saved)
    assert (found.attrs["source"], found.attrs["version"]) == ("gearwear", __version__)
    assert found.attrs["title"] == "unworn of a worn, hot spur gear pair"
    assert (found.attrs["stage"], found.attrs["code"]) == ("unworn", "aaaa")
    assert json.loads(found.attrs["config"]) == SETTINGS
    assert store.origin_of(found) == origin()
    assert found.attrs["lineage"] == origin().lineage


@pytest.mark.parametrize(
    ("path", "result"),
    [
        ("results/geometry.nc", "geometry.nc"),
        ("results/with/wear/q003.nc", "with/wear/q003.nc"),
        ("somewhere/results/studies/heat/t120/with/wear/q003.nc", "studies/heat/t120/with/wear/q003.nc"),
        ("made/elsewhere/q003.nc", "q003.nc"),
    ],
)
def test_a_file_tells_its_place_below_the_results(tmp_path, path, result):
    file = tmp_path / path
    file.parent.mkdir(parents=True)
    store.save(flanks(), file, origin())
    assert store.load(file).attrs["result"] == store.result_of(path) == result


def test_variables_are_read_alone_with_the_attributes_of_the_file(saved):
    found, whole = store.load(saved, ["running_cycles"]), store.load(saved)
    assert set(found.variables) == {"running_cycles"} and found["running_cycles"].item() == 0.0
    assert found.attrs == whole.attrs
    depth = store.load(saved, ["wear_depth"])["wear_depth"]
    assert depth.dims == ("gear", "path") and np.array_equal(depth, whole["wear_depth"])


def test_a_single_variable_that_is_not_finite_is_named_and_a_missing_one_too(saved):
    with netCDF4.Dataset(saved, "a") as file:
        file["wear_depth"][0, 1] = np.nan
    assert store.load(saved, ["running_cycles"])
    with pytest.raises(BadFile, match=r"q000\.nc: wear_depth holds values that are not finite; delete it"):
        store.load(saved, ["wear_depth"])
    with pytest.raises(BadFile, match=r"q000\.nc: not a readable netCDF file .*wear_per_revolution"):
        store.load(saved, ["wear_per_revolution"])


def test_a_value_that_is_not_finite_is_not_written(tmp_path):
    path = tmp_path / "q000.nc"
    for bad in (np.nan, np.inf):
        with pytest.raises(ValueError, match="wear_depth: holds values that are not finite"):
            store.save(flanks(bad), path, origin())
    assert list(tmp_path.iterdir()) == []


def test_a_missing_value_is_allowed_where_the_table_says_so(tmp_path):
    path = tmp_path / "sweep.nc"
    points = xr.Dataset({"lyapunov_exponent": ("point", [np.nan, 0.1])}, {"ste": ("point", [0.5, 1.0])})
    store.save(points, path, origin())
    assert np.isnan(store.load(path)["lyapunov_exponent"].values).tolist() == [True, False]


def test_a_variable_without_an_entry_is_refused(tmp_path):
    with pytest.raises(ValueError, match="depth_of_wear: no such variable in the table of variables"):
        store.save(flanks().rename(wear_depth="depth_of_wear"), tmp_path / "q000.nc", origin())


def test_other_dimensions_than_those_of_the_entry_are_refused(tmp_path):
    with pytest.raises(ValueError, match=r"wear_depth: dimensions \('path', 'gear'\)"):
        store.save(flanks().transpose("path", "gear"), tmp_path / "q000.nc", origin())
    assert list(tmp_path.iterdir()) == []


def test_a_swept_quantity_shares_its_name_with_that_of_the_mesh():
    assert variable_of("backlash", ("point",)).units == "1"
    assert variable_of("backlash", ("mesh_phase",)).units == "m"


def test_a_write_that_fails_leaves_nothing(tmp_path, monkeypatch):
    path = tmp_path / "q000.nc"

    def break_off(self, target, **_):
        Path(target).write_bytes(b"half")
        raise OSError("disk full")

    monkeypatch.setattr(xr.Dataset, "to_netcdf", break_off)
    with pytest.raises(OSError, match="disk full"):
        store.save(flanks(), path, origin())
    assert list(tmp_path.iterdir()) == []


def test_a_write_that_fails_leaves_the_file_before_it(saved, monkeypatch):
    before = saved.read_bytes()

    def break_off(self, target, **_):
        Path(target).write_bytes(b"half")
        raise KeyboardInterrupt

    monkeypatch.setattr(xr.Dataset, "to_netcdf", break_off)
    with pytest.raises(KeyboardInterrupt):
        store.save(flanks(2e-6), saved, origin())
    assert saved.read_bytes() == before
    assert [path.name for path in saved.parent.iterdir()] == [saved.name]


def test_the_name_appears_only_when_the_file_is_complete(tmp_path):
    path = tmp_path / "q000.nc"
    with store.atomic(path) as temporary:
        Path(temporary).write_text("all of it")
        assert not path.exists()
        assert Path(temporary).parent == tmp_path
    assert path.read_text() == "all of it"
    assert list(tmp_path.iterdir()) == [path]


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(ValueError, match=r"q007\.nc: no such file; run the workflow again"):
        store.load(tmp_path / "q007.nc")


@pytest.mark.parametrize("kept", [0, 100, 3000, -1000])
def test_a_truncated_file_is_named(saved, kept):
    saved.write_bytes(saved.read_bytes()[:kept])
    with pytest.raises(ValueError, match=r"q000\.nc: not a readable netCDF file .* delete it and run"):
        store.load(saved)


def test_a_file_that_is_no_netcdf_is_named(tmp_path):
    path = tmp_path / "q000.nc"
    path.write_text("wear")
    with pytest.raises(ValueError, match=r"q000\.nc: not a readable netCDF file"):
        store.load(path)


def test_a_foreign_file_is_named(tmp_path):
    path = tmp_path / "q000.nc"
    flanks().to_netcdf(path)
    with pytest.raises(ValueError, match=r"q000\.nc: not a result of this workflow \(no lineage\)"):
        store.load(path)


def test_a_file_whose_values_are_not_finite_is_named_with_the_variable(saved):
    with netCDF4.Dataset(saved, "a") as file:
        file["wear_depth"][0, 1] = np.nan
    with pytest.raises(ValueError, match=r"q000\.nc: wear_depth holds values that are not finite; delete it"):
        store.load(saved)


def with_lineage(code=""):
    """Return a dataset as it is loaded, of a lineage that changes with the code."""
    return xr.Dataset(attrs=store.Origin("geometry", {}, code).attributes())


def test_lineage_changes_with_config_code_stage_and_the_lineage_of_an_input():
    source, other = with_lineage(), with_lineage("other")
    found = [
        one.lineage
        for one in (
            origin(wear=source),
            origin(config={"a": 1}, wear=source),
            origin(code="bbbb", wear=source),
            origin("wear", wear=source),
            origin(wear=other),
            origin(geometry=source),
            origin(),
        )
    ]
    assert len(set(found)) == len(found)
    assert origin(wear=with_lineage()).lineage == found[0]


def test_lineage_does_not_change_with_the_order_of_keys_and_inputs():
    turned = {"a": {"c": "x", "d": 2}, "b": 1.5}
    one, two = with_lineage("one"), with_lineage("two")
    assert origin(config=turned, wear=two, geometry=one).lineage == origin(geometry=one, wear=two).lineage


def test_lineages_of_a_list_of_inputs_count_once_each_in_any_order():
    one, two = with_lineage("one"), with_lineage("two")
    first = store.lineages({"parts": [one, two]})
    assert first == store.lineages({"parts": [two, one]}) == store.lineages({"parts": [one, two, one]})
    assert first["parts"].split() == sorted([one.attrs["lineage"], two.attrs["lineage"]])
    assert store.lineages({"parts": [one]}) != first


def test_inputs_that_are_no_results_have_no_lineage():
    found = store.lineages(
        {"claims": Path("claims.yaml"), "texts": [Path("a.txt")], "wear": with_lineage(), "parts": []}
    )
    assert list(found) == ["wear"]


def test_lineage_of_the_inputs_is_written_beside_the_own(tmp_path, saved):
    store.save(flanks(), tmp_path / "next.nc", origin(wear=store.load(saved)))
    assert store.load(tmp_path / "next.nc").attrs["inputs"] == f'{{"wear": "{origin().lineage}"}}'


def test_parts_of_one_state_are_one_dataset():
    grid = {"path": [1e-3, 2e-3, 3e-3]}
    whole = store.together([flanks(1e-6), xr.Dataset({"elastic_deflection": ("path", [1.0, 2.0, 3.0])}, grid)])
    assert set(whole.data_vars) == {"wear_depth", "running_cycles", "elastic_deflection"} and not whole.attrs
