"""Result files: complete or not at all, described, reproducible, with a lineage of what made them."""

import os
from pathlib import Path
from types import SimpleNamespace

import netCDF4
import numpy as np
import pytest
import xarray as xr

from gearwear.io import store
from gearwear.io.variables import variable_of, variables


class Inputs(SimpleNamespace):
    """Named input files of a job."""

    def items(self):
        return vars(self).items()


def job(output, rule="start_wear", cfg=None, code="aaaa", **inputs):
    params = SimpleNamespace(cfg=cfg or {"b": 1.5, "a": {"d": 2, "c": "x"}}, code=code)
    return SimpleNamespace(rule=rule, input=Inputs(**inputs), output=[output], params=params)


def flanks(depth=0.0):
    return xr.Dataset(
        {"wear_depth": (("gear", "path"), np.full((2, 3), depth)), "running_cycles": 0.0},
        {"path": [1e-3, 2e-3, 3e-3], "gear": ["pinion", "gear"]},
    )


@pytest.fixture
def saved(tmp_path):
    path = tmp_path / "q000.nc"
    store.save(flanks(1e-6), job(path))
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
    store.save(points, job(path))
    found = store.load(path)["motion_class"]
    meanings = dict(zip(found.flag_meanings.split(), found.flag_values.tolist(), strict=True))
    assert (meanings["P1"], meanings["CH"], meanings["not_converged"]) == (1, 101, 0)


def test_saving_leaves_the_dataset_of_the_caller_as_it_was(tmp_path):
    mine = flanks()
    mine["wear_depth"].attrs["note"] = "mine"
    store.save(mine, job(tmp_path / "q000.nc"))
    assert mine.attrs == {}
    assert mine["wear_depth"].attrs == {"note": "mine"}


def test_same_settings_give_the_same_bytes(tmp_path):
    paths = [tmp_path / name for name in ("one.nc", "two.nc")]
    for path in paths:
        store.save(flanks(1e-6), job(path))
    assert paths[0].read_bytes() == paths[1].read_bytes()


def test_no_time_host_or_folder_is_written(saved):
    content = saved.read_bytes()
    assert os.fsencode(saved.parent) not in content
    assert os.uname().nodename.encode() not in content
    attributes = {"Conventions", "title", "source", "stage", "config", "code", "inputs", "lineage"}
    assert set(store.load(saved).attrs) == attributes


def test_a_value_that_is_not_finite_is_not_written(tmp_path):
    path = tmp_path / "q000.nc"
    for bad in (np.nan, np.inf):
        with pytest.raises(ValueError, match="wear_depth: holds values that are not finite"):
            store.save(flanks(bad), job(path))
    assert list(tmp_path.iterdir()) == []


def test_a_missing_value_is_allowed_where_the_table_says_so(tmp_path):
    path = tmp_path / "sweep.nc"
    points = xr.Dataset({"lyapunov_exponent": ("point", [np.nan, 0.1])}, {"ste": ("point", [0.5, 1.0])})
    store.save(points, job(path))
    assert np.isnan(store.load(path)["lyapunov_exponent"].values).tolist() == [True, False]


def test_a_variable_without_an_entry_is_refused(tmp_path):
    with pytest.raises(ValueError, match="depth_of_wear: no entry"):
        store.save(flanks().rename(wear_depth="depth_of_wear"), job(tmp_path / "q000.nc"))


def test_other_dimensions_than_those_of_the_entry_are_refused(tmp_path):
    with pytest.raises(ValueError, match=r"wear_depth: dimensions \('path', 'gear'\)"):
        store.save(flanks().transpose("path", "gear"), job(tmp_path / "q000.nc"))
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
        store.save(flanks(), job(path))
    assert list(tmp_path.iterdir()) == []


def test_a_write_that_fails_leaves_the_file_before_it(saved, monkeypatch):
    before = saved.read_bytes()

    def break_off(self, target, **_):
        Path(target).write_bytes(b"half")
        raise KeyboardInterrupt

    monkeypatch.setattr(xr.Dataset, "to_netcdf", break_off)
    with pytest.raises(KeyboardInterrupt):
        store.save(flanks(2e-6), job(saved))
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


def made(tmp_path, name, cfg=None, **changes):
    path = tmp_path / f"{name}.nc"
    store.save(flanks(), job(path, cfg=cfg, **changes))
    return path


def test_lineage_changes_with_config_code_rule_and_the_lineage_of_an_input(tmp_path):
    source, same, other = (
        made(tmp_path, "source"),
        made(tmp_path, "same"),
        made(tmp_path, "other", cfg={"a": 2}),
    )
    found = [
        store.lineage(path)
        for path in (
            made(tmp_path, "plain", wear=source),
            made(tmp_path, "config", cfg={"a": 1}, wear=source),
            made(tmp_path, "code", code="bbbb", wear=source),
            made(tmp_path, "rule", rule="advance_wear", wear=source),
            made(tmp_path, "input", wear=other),
            made(tmp_path, "role", geometry=source),
            made(tmp_path, "none"),
        )
    ]
    assert len(set(found)) == len(found)
    assert store.lineage(made(tmp_path, "again", wear=same)) == found[0]


def test_lineage_does_not_change_with_place_data_or_order_of_keys(tmp_path):
    source = made(tmp_path, "source")
    turned = {"a": {"c": "x", "d": 2}, "b": 1.5}
    first = made(tmp_path, "first", wear=source)
    assert store.lineage(made(tmp_path, "turned", cfg=turned, wear=source)) == store.lineage(first)
    (tmp_path / "elsewhere").mkdir()
    moved = tmp_path / "elsewhere" / "moved.nc"
    source.rename(moved)
    assert store.lineage(made(tmp_path, "third", wear=moved)) == store.lineage(first)


def test_lineages_of_a_list_of_inputs_count_once_each_in_any_order(tmp_path):
    one, two = made(tmp_path, "one", cfg={"a": 1}), made(tmp_path, "two", cfg={"a": 2})
    first = store.lineage(made(tmp_path, "first", parts=[one, two]))
    assert store.lineage(made(tmp_path, "turned", parts=[two, one])) == first
    assert store.lineage(made(tmp_path, "twice", parts=[one, two, one])) == first
    assert store.lineage(made(tmp_path, "short", parts=[one])) != first


def test_lineage_of_the_inputs_is_written_beside_the_own(tmp_path):
    source = made(tmp_path, "source")
    found = store.load(made(tmp_path, "next", wear=source))
    assert found.attrs["inputs"] == f'{{"wear": "{store.lineage(source)}"}}'
    assert (found.attrs["code"], found.attrs["stage"]) == ("aaaa", "start_wear")


@pytest.mark.parametrize(
    ("path", "makers"),
    [
        ("results/geometry.nc", ("build_geometry",)),
        ("results/wear/temperature.nc", ("heat_contact",)),
        ("results/with/wear/q003.nc", ("start_wear", "advance_wear")),
        ("results/with/backlash/q003.nc", ("open_backlash",)),
        ("results/with/sweeps/restart/backlash.nc", ("join_sweep",)),
        ("results/with/sweeps/up/backlash.nc", ("carry_sweep",)),
        ("results/with/sweeps/down/temperature.nc", ("carry_sweep",)),
        ("results/with/portraits/backlash.nc", ("trace_portraits",)),
        ("results/with/branches/backlash.nc", ("continue_orbits",)),
        ("results/with/motions/up/backlash.nc", ("trace_motions",)),
        ("results/with/handover/handover.nc", ("gather_handover",)),
        ("results/with/sweeps/parts/backlash/1-of-4.nc", ("sweep_part",)),
        ("results/with/basins/backlash.nc", ("map_basins",)),
        ("results/with/maps/tiles/ste/1-of-4.nc", ("map_tile", "map_temperature")),
        ("results/studies/chains/with_0123456789ab.nc", ("run_chain",)),
        ("results/studies/heat/t120/outcome.nc", ("measure_outcome",)),
        ("results/studies/heat/study.nc", ("gather_study",)),
        ("results/studies/onsets/box_001/member_onsets.nc", ("measure_onsets",)),
        ("results/with/maps/wear.nc", ("join_map",)),
        ("results/studies/heat/t120/geometry.nc", ("build_geometry",)),
        ("results/studies/heat/t120/with/wear/q003.nc", ("start_wear", "advance_wear")),
        ("results/studies/parts/sweeps/geometry.nc", ("build_geometry",)),
        ("results/studies/sweeps/parts/with/temperature.nc", ("heat_contact",)),
        ("results/parts/wear/q000.nc", ("start_wear", "advance_wear")),
        ("results/onset_shifts.nc", ("compare_onsets",)),
        ("results/with/onsets.nc", ("locate_onsets",)),
        ("results/studies/onsets/box_001/with/onsets.nc", ("locate_onsets",)),
        ("results/with/onset_variants.nc", ("vary_onsets",)),
        ("results/studies/branches/portraits/geometry.nc", ("build_geometry",)),
        ("somewhere/else.nc", ()),
    ],
)
def test_makers_of_a_result_follow_from_its_place(path, makers):
    assert store._makers(Path(path)) == makers


def test_a_result_of_another_stage_is_named(tmp_path):
    path = tmp_path / "mesh_stiffness" / "q001.nc"
    path.parent.mkdir()
    store.save(flanks(), job(path))
    with pytest.raises(ValueError, match="q001.nc: a result of start_wear, not of build_stiffness; delete it"):
        store.load(path)
