"""Two results folders held against each other: every kind of difference, its place, unit and exit status."""

import json

import numpy as np
import pytest
import xarray as xr

from gearwear.cli import DIFFERENT, EQUAL, UNUSABLE, main
from gearwear.compare import Setting, compare, read
from gearwear.errors import BadFile

PATH = np.array([0.005, 0.01, 0.015])
CLASSES = {"flag_values": np.array([0, 1, 2], np.int32), "flag_meanings": "not_converged P1 P2"}


def wear(**changed):
    """A small file of every kind of value: numbers, numbers by coordinate, flags, text, NaN."""
    values = {
        "wear_depth": (("gear", "path"), np.array([[1e-6, 2e-6, np.nan], [3e-6, 4e-6, 5e-6]]), {"units": "m"}),
        "running_cycles": ((), 1e8, {"units": "1"}),
        "motion_class": ("point", np.array([1, 2, 1], np.int32), CLASSES),
        "mesh_frequency": ("point", np.array([0.1, 0.2, 0.3]), {"units": "1"}),
        "branch_end_remark": ("branch", np.array(["at the end of the range", "closed"], dtype=object)),
        "branch_period": ("branch", np.array([1, 2], np.int64)),
    }
    coords = {"gear": np.array(["pinion", "gear"], dtype=object), "path": ("path", PATH, {"units": "m"})}
    config = {"case": {"bulk_temperature": 100.0}, "wear": {"law": "janakiraman"}}
    dataset = xr.Dataset(values, coords, {"config": json.dumps(config), "code": "1", "lineage": "2"})
    return dataset.assign(changed)


@pytest.fixture
def runs(tmp_path):
    """Write a results folder and its twin, changed, and return both."""

    def write(other=None, name="with/wear/q001.nc", **tables):
        folders = tmp_path / "a" / "results", tmp_path / "b" / "results"
        for folder, dataset in zip(folders, (wear(), wear() if other is None else other), strict=True):
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            dataset.to_netcdf(folder / name)
        for folder, text in zip(folders, zip(*tables.values(), strict=True), strict=False):
            for table, content in zip(tables, text, strict=True):
                (folder / f"{table}.csv").write_text(content)
        return folders

    return write


def only(found):
    assert len(found.differences) == 1, found.differences
    return found.differences[0]


def changed(name, index, value):
    dataset = wear()
    values = dataset[name].values.copy()
    values[index] = value
    return dataset.assign({name: dataset[name].copy(data=values)})


def test_equal_folders_are_equal_to_the_bit_whatever_their_provenance(runs):
    found = compare(*runs(wear().assign_attrs(code="3", lineage="4", version="0.3.0", title="another")))
    assert found.equal
    assert found.files == 1
    assert not found.settings


def test_the_largest_absolute_and_relative_difference_have_their_places(runs):
    other = changed("wear_depth", (1, 2), 5.5e-6)
    other["wear_depth"].values[0, 0] = 1.25e-6
    found = only(compare(*runs(other)))
    assert (found.file, found.variable, found.unit) == ("with/wear/q001.nc", "wear_depth", "m")
    assert (found.total, found.differing, found.missing) == (6, 2, 0)
    assert found.absolute == 5.5e-6 - 5e-6
    assert found.place.at == {"gear": ("gear", ""), "path": (0.015, "m")}
    assert (found.place.a, found.place.b) == (5e-6, 5.5e-6)
    assert found.relative == pytest.approx(0.2)
    assert found.relative_place.at == {"gear": ("pinion", ""), "path": (0.005, "m")}


def test_one_bit_is_a_difference_and_a_scalar_has_no_place(runs):
    found = only(compare(*runs(wear(running_cycles=((), np.nextafter(1e8, 2e8), {"units": "1"})))))
    assert found.absolute == np.spacing(1e8)
    assert found.place.at == {}


def test_a_sign_of_zero_is_a_difference_of_size_zero(runs, tmp_path):
    folders = runs(changed("wear_depth", (0, 0), -0.0))
    changed("wear_depth", (0, 0), 0.0).to_netcdf(folders[0] / "with/wear/q001.nc")
    found = only(compare(*folders))
    assert found.differing == 1
    assert found.absolute == found.relative == 0.0
    assert compare(*folders, tolerance=1e-15).equal


def test_a_missing_value_on_one_side_is_counted_apart_from_the_numbers(runs):
    found = only(compare(*runs(changed("wear_depth", (0, 1), np.nan))))
    assert (found.differing, found.missing) == (1, 1)
    assert np.isnan([found.absolute, found.relative]).all()
    assert found.place.at["path"] == (0.01, "m")
    other = changed("wear_depth", (0, 2), 1.0)
    other["wear_depth"].values[1, 0] = 6e-6
    found = only(compare(*runs(other)))
    assert (found.differing, found.missing) == (2, 1)
    assert found.relative == pytest.approx(0.5)


def test_nan_of_another_payload_is_nan(runs):
    payload = np.array([0x7FF8000000000001], np.uint64).view(np.float64)[0]
    assert np.isnan(payload)
    assert compare(*runs(changed("wear_depth", (0, 2), payload))).equal


def test_infinite_numbers_differ_infinitely(runs):
    found = only(compare(*runs(changed("wear_depth", (0, 0), np.inf))))
    assert found.absolute == found.relative == np.inf
    assert found.missing == 0


def test_whole_numbers_differ_by_whole_numbers_at_an_index(runs):
    found = only(compare(*runs(changed("branch_period", 1, 4))))
    assert (found.absolute, *found.place) == (2.0, {"branch": (1, "index")}, 2, 4)
    assert found.relative == 0.5


def test_flags_differ_by_name_where_the_swept_quantity_says(runs):
    found = only(compare(*runs(changed("motion_class", 2, 2))))
    assert found.place == ({"mesh_frequency": (0.3, "1")}, "P1", "P2")
    assert np.isnan(found.absolute)


def test_text_differs_as_text(runs):
    found = only(compare(*runs(changed("branch_end_remark", 0, "stopped"))))
    assert found.place == ({"branch": (0, "index")}, "at the end of the range", "stopped")


def test_a_coordinate_that_differs_is_a_difference(runs):
    moved = wear().assign_coords(path=("path", PATH + [0, 0, 1e-9], {"units": "m"}))
    found = only(compare(*runs(moved)))
    assert (found.variable, found.unit) == ("path", "m")


@pytest.mark.parametrize(
    ("change", "what"),
    [
        ({"running_cycles": ((), np.float32(1e8), {"units": "1"})}, "type float64 in A, float32 in B"),
        ({"branch_period": ("half", np.array([1, 2]))}, "dimensions (branch) in A, (half) in B"),
        ({"branch_period": ("other", np.array([1, 2, 3]))}, "dimensions (branch) in A, (other) in B"),
        ({"running_cycles": ((), 1e8, {"units": "m"})}, "units '1' in A, 'm' in B"),
        (
            {"motion_class": ("point", np.array([1, 2, 1], np.int32), CLASSES | {"flag_meanings": "none P1 P2"})},
            "flag_meanings 'not_converged P1 P2' in A, 'none P1 P2' in B",
        ),
    ],
)
def test_values_of_another_kind_are_told_apart_by_what_they_are(runs, change, what):
    assert only(compare(*runs(wear(**change)))).what == what


def test_arrays_of_another_length_are_not_compared(runs):
    shorter = wear().isel(point=slice(2))
    found = compare(*runs(shorter))
    assert [one.what for one in found.differences] == ["3 values in A, 2 in B"] * 2


def test_a_coordinate_that_is_none_any_more_is_a_difference(runs):
    found = compare(*runs(wear().set_coords("mesh_frequency")))
    assert [(one.variable, one.what) for one in found.differences] == [
        ("motion_class", "coordinates '' in A, 'mesh_frequency' in B")
    ]


def test_variables_and_files_missing_on_either_side_are_named(runs):
    folders = runs(wear().drop_vars("branch_period").assign(extra=1.0))
    (folders[1] / "with/more.nc").write_bytes((folders[1] / "with/wear/q001.nc").read_bytes())
    (folders[0] / "table.csv").write_text("a\n1\n")
    found = compare(*folders)
    assert [one[:3] for one in found.differences] == [
        ("table.csv", "", "only in A"),
        ("with/more.nc", "", "only in B"),
        ("with/wear/q001.nc", "branch_period", "only in A"),
        ("with/wear/q001.nc", "extra", "only in B"),
    ]


def test_a_tolerance_counts_small_relative_differences_as_equal_and_says_so(runs, capsys):
    folders = runs(changed("wear_depth", (0, 0), 1e-6 * (1 + 1e-9)))
    assert compare(*folders, tolerance=1e-8).within == 1
    assert main(["compare", *map(str, folders), "--tolerance", "1e-8"]) == EQUAL
    printed = capsys.readouterr().out
    assert "1 variable equal within the relative tolerance 1e-08" in printed
    assert "equal within the tolerance: 1 file compared" in printed
    assert only(compare(*folders, tolerance=1e-10)).differing == 1


def test_a_tolerance_forgives_neither_missing_values_nor_flags(runs):
    assert not compare(*runs(changed("wear_depth", (0, 0), np.nan)), tolerance=0.5).equal
    assert not compare(*runs(changed("motion_class", 0, 2)), tolerance=0.9).equal


def test_settings_that_differ_are_listed_by_key(runs, capsys):
    config = {"case": {"bulk_temperature": 90.0}, "wear": {"law": "janakiraman", "pressure": "mean"}}
    folders = runs(changed("wear_depth", (0, 0), 9.0).assign_attrs(config=json.dumps(config)))
    assert compare(*folders).settings == [
        Setting("case.bulk_temperature", 100.0, 90.0, "with/wear/q001.nc"),
        Setting("wear.pressure", None, "mean", "with/wear/q001.nc"),
    ]
    main(["compare", *map(str, folders)])
    assert 'settings that differ: case.bulk_temperature 100.0 / 90.0; wear.pressure not set / "mean"\n' in (
        capsys.readouterr().out
    )


def test_a_setting_that_another_stage_reads_in_the_other_run_does_not_differ(runs):
    folders = runs(wear().assign_attrs(config=json.dumps({"case": {"bulk_temperature": 100.0}})))
    law = xr.Dataset({"one": 1.0}, attrs={"config": json.dumps({"wear": {"law": "janakiraman"}})})
    law.to_netcdf(folders[1] / "other.nc")
    law.assign_attrs(config="{}").to_netcdf(folders[0] / "other.nc")
    assert compare(*folders).settings == []


def test_tables_differ_cell_by_cell_with_row_column_and_unit(runs):
    ours, theirs = "claim,verdict,s [mm]\none,agree,1.0\ntwo,agree,2.0\n", "claim,verdict,s [mm]\none,agree,1.0\n"
    found = compare(*runs(claims=(ours, theirs + "two,differs,2.5\n")))
    number, word = found.differences
    assert (number.variable, number.unit) == ("s [mm]", "mm")
    assert (number.absolute, *number.place) == (0.5, {"claim": ("two", "")}, 2.0, 2.5)
    assert word.place == ({"claim": ("two", "")}, "agree", "differs")
    assert [one.what for one in compare(*runs(claims=(ours, theirs))).differences] == ["2 values in A, 1 in B"] * 3


def test_cells_that_differ_as_text_alone_are_a_difference(runs):
    assert only(compare(*runs(claims=("a,b\n1,1.0\n", "a,b\n1,1.00\n")))).place.b == "1.00"


def test_tables_of_how_a_run_was_made_are_not_compared(runs):
    assert compare(*runs(versions=("a\n1\n", "a\n2\n"), parameters=("a\n1\n", "a\n2\n"))).files == 1


def test_hidden_folders_are_no_results(runs):
    folders = runs()
    (folders[0] / ".cache").mkdir()
    (folders[0] / ".cache" / "other.csv").write_text("a\n1\n")
    assert compare(*folders).equal


def test_parents_of_results_and_single_files_are_taken(runs):
    a, b = runs(changed("wear_depth", (0, 0), 9.0))
    assert only(compare(a.parent, b)).variable == "wear_depth"
    found = only(compare(a / "with/wear/q001.nc", b / "with/wear/q001.nc"))
    assert found.file == "q001.nc"


def test_exit_status_and_table_say_what_differs(runs, capsys):
    folders = runs(changed("wear_depth", (1, 2), 5.5e-6))
    assert main(["compare", *map(str, folders)]) == DIFFERENT
    printed = capsys.readouterr().out.splitlines()
    assert printed == [
        "with/wear/q001.nc",
        "  wear_depth: 1 of 6 values differ; largest difference 5e-07 m at gear = gear, path = 0.015 m "
        "(A 5e-06, B 5.5e-06), relative 0.0909091",
        "different: 1 variable in 1 file; 1 file compared",
    ]
    assert main(["compare", str(folders[0]), str(folders[0])]) == EQUAL
    assert capsys.readouterr().out == "equal, bit for bit: 1 file compared\n"


def test_wear_cycles_share_a_line_that_names_the_worst(runs, capsys):
    small, large = changed("wear_depth", (0, 0), 2e-6), changed("wear_depth", (1, 2), 8e-6)
    runs(small)
    folders = runs(large, "with/wear/q002.nc")
    assert main(["compare", *map(str, folders)]) == DIFFERENT
    assert capsys.readouterr().out.splitlines()[:2] == [
        "with/wear/*.nc",
        "  wear_depth: 2 of 12 values differ in 2 files; largest difference 3e-06 m at gear = gear, path = 0.015 m, "
        "q002.nc (A 5e-06, B 8e-06), largest relative 0.5 at gear = pinion, path = 0.005 m, q001.nc",
    ]


def test_the_table_for_machines_holds_everything(runs, capsys):
    folders = runs(changed("wear_depth", (0, 0), np.inf))
    assert main(["compare", *map(str, folders), "--json"]) == DIFFERENT
    table = json.loads(capsys.readouterr().out)
    (difference,) = table.pop("differences")
    assert table == {"equal": False, "files": 1, "tolerance": 0.0, "within_tolerance": 0, "settings": []}
    assert difference["absolute"] == difference["relative"] == "inf"
    assert difference["place"] == {"at": {"gear": ["pinion", ""], "path": [0.005, "m"]}, "a": 1e-6, "b": "inf"}


@pytest.mark.parametrize(
    ("names", "message"),
    [
        (("none", "a"), "no such file or folder"),
        (("empty", "a"), "holds no netCDF file and no CSV table"),
        (("text.txt", "a"), "neither a netCDF file (.nc) nor a CSV table (.csv)"),
        (("a/results/with/wear/q001.nc", "a"), "one is a folder, the other a file"),
        (("a/results/with/wear/q001.nc", "t.csv"), "files of two kinds"),
        (("a/results/with/wear/q001.nc", "broken.nc"), "not a readable netCDF file"),
        (("t.csv", "broken.csv"), "not a readable CSV table"),
    ],
)
def test_unusable_input_is_refused_in_one_sentence(runs, tmp_path, capsys, names, message):
    runs()
    (tmp_path / "empty").mkdir()
    (tmp_path / "text.txt").write_text("")
    (tmp_path / "t.csv").write_text("a\n1\n")
    (tmp_path / "broken.nc").write_bytes(b"CDF but not quite")
    (tmp_path / "broken.csv").write_bytes(b"\xff\xfe\xff")
    assert main(["compare", *(str(tmp_path / name) for name in names)]) == UNUSABLE
    said = capsys.readouterr()
    assert message in said.err
    assert said.err.startswith("gearwear compare: ")
    assert said.err.count("\n") == 1
    assert said.out == ""


def test_a_tolerance_outside_its_range_is_refused(runs):
    with pytest.raises(BadFile, match="tolerance: -1 must be at least 0 and below 1"):
        compare(*runs(), tolerance=-1)


def test_read_gives_variables_and_settings(runs):
    folder, _ = runs()
    variables, config = read(folder / "with/wear/q001.nc")
    assert variables["wear_depth"].dims == ("gear", "path")
    assert config["wear"] == {"law": "janakiraman"}
