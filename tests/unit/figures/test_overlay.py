"""The curves of two runs over each other: what is drawn, where, and what is left out."""

import numpy as np
import pytest
import xarray as xr

import gearwear
from gearwear.cli import DIFFERENT, UNUSABLE, main
from gearwear.errors import BadFile
from gearwear.figures import overlay as module
from gearwear.figures.overlay import overlay

NAMES = [f"fig{number:02d}" for number in range(6, 13)]


def write(folder, torque, cases=("cold", "hot"), swept=("hot",)):
    pair = gearwear.GearPair((26, 78), 3.175e-3, 16e-3, (16e-3, 55e-3), mesh_cells=24)
    folder.mkdir(parents=True)
    pair.geometry.to_netcdf(folder / "geometry.nc")
    for case in cases:
        bulk = {"cold": 20.0, "hot": 100.0}[case]
        worn = pair.wear(torque, 3400.0, 1e8, bulk_temperature=bulk, force="quasi_static")
        for cycle in range(2):
            files = {
                "wear": worn[["wear_depth"]].isel(wear_cycle=cycle, drop=True),
                "mesh_stiffness": pair.mesh_stiffness(bulk_temperature=bulk),
                "transmission_error": pair.transmission_error(torque, bulk_temperature=bulk),
                "backlash": pair.backlash(torque, bulk_temperature=bulk),
            }
            for name, dataset in files.items():
                (folder / case / name).mkdir(parents=True, exist_ok=True)
                dataset.to_netcdf(folder / case / name / f"q{cycle:03d}.nc")
        pair.thermal_growth(bulk).to_netcdf(folder / case / "deformation.nc")
    for case in swept:
        path = folder / case / "sweeps" / "restart" / "mesh_frequency.nc"
        path.parent.mkdir(parents=True)
        table = {
            "section_displacement": (("point", "sample"), np.array([[1.0, 1.0], [2.0, 3.0]]) * torque),
            "period": ("point", [1, 0]),
            "lyapunov_exponent": ("point", [-0.1, 0.1]),
            "mesh_frequency": ("point", [0.5, 1.0]),
        }
        xr.Dataset(table).to_netcdf(path)


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    folder = tmp_path_factory.mktemp("runs")
    for name, torque in (("a", 135.0), ("b", 120.0)):
        write(folder / name / "results", torque)
    return folder / "a", folder / "b"


@pytest.fixture(scope="module")
def figures_of():
    """Return a function that gives the figures of two runs by name, without writing them."""

    def of(a, b, folder):
        figures = {}
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(module, "_write", lambda figure, path: figures.update({path.name: figure}) or [path])
            overlay(a, b, folder)
        return figures

    return of


@pytest.fixture(scope="module")
def drawn(runs, figures_of, tmp_path_factory):
    return figures_of(*runs, tmp_path_factory.mktemp("figures"))


def test_every_figure_is_drawn(drawn):
    assert list(drawn) == NAMES


def test_a_figure_is_two_files_with_both_runs_in_two_colours(runs, tmp_path, monkeypatch):
    monkeypatch.setattr(module, "_FIGURES", {name: module._FIGURES[name] for name in ("fig09", "fig12")})
    written = overlay(*runs, tmp_path / "figures")
    assert [path.name for path in written] == ["fig09.png", "fig09.svg", "fig12.png", "fig12.svg"]
    for path in written:
        content = path.read_bytes()
        if path.suffix == ".svg":
            assert b"#0072b2" in content
            assert b"#d55e00" in content
            assert f"A: {runs[0]}".encode() in content
        else:
            assert content.startswith(b"\x89PNG")


def test_the_curves_are_those_of_the_last_wear_cycle_of_either_run(runs, drawn):
    cold = drawn["fig06"].axes[0]
    assert cold.get_title(loc="left") == "cold"
    for line, run in zip(cold.get_lines()[::2], runs, strict=True):
        depth = xr.load_dataset(run / "results/cold/wear/q001.nc")["wear_depth"].sel(gear="pinion").values
        values = line.get_ydata()
        assert np.array_equal(values[~np.isnan(values)], 1e6 * depth)


def test_every_case_has_a_row_and_every_quantity_a_column(drawn):
    assert {name: len(figure.axes) for name, figure in drawn.items()} == {
        "fig06": 4,
        "fig07": 4,
        "fig08": 4,
        "fig09": 2,
        "fig10": 6,
        "fig11": 2,
        "fig12": 2,
    }


def test_the_section_has_one_dot_a_period_and_all_of_a_motion_that_does_not_repeat(drawn):
    sections = drawn["fig12"].axes[0].get_lines()
    assert sections[0].get_ydata().tolist() == [135.0, 270.0, 405.0]
    assert sections[1].get_ydata().tolist() == [120.0, 240.0, 360.0]


def test_what_one_run_lacks_is_left_out(runs, figures_of, tmp_path):
    write(tmp_path / "c", 100.0, cases=("cold",), swept=())
    assert set(figures_of(runs[0], tmp_path / "c", tmp_path)) == set(NAMES) - {"fig12"}


def test_runs_without_a_case_in_common_are_refused(runs, tmp_path):
    write(tmp_path / "c", 100.0, cases=(), swept=())
    with pytest.raises(BadFile, match="have no case in common"):
        overlay(runs[0], tmp_path / "c", tmp_path / "figures")
    (tmp_path / "c" / "geometry.nc").rename(tmp_path / "c" / "other.nc")
    with pytest.raises(BadFile, match="must be two results folders with geometry.nc"):
        overlay(runs[0], tmp_path / "c", tmp_path / "figures")


def test_the_command_names_the_files_and_keeps_the_exit_status(runs, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(module, "_FIGURES", {"fig11": module._FIGURES["fig11"]})
    arguments = ["compare", *map(str, runs), "--figures"]
    assert main([*arguments, str(tmp_path / "figures")]) == DIFFERENT
    assert [line.rpartition("/")[2] for line in capsys.readouterr().err.splitlines()] == ["fig11.png", "fig11.svg"]
    (tmp_path / "file").write_text("")
    assert main([*arguments, str(tmp_path / "file")]) == UNUSABLE
    assert "cannot be made" in capsys.readouterr().err
