"""The whole workflow on the smoke configuration."""

import csv
import json
import zipfile
from pathlib import Path

import netCDF4
import pytest

SMOKE = ("--configfile", "config/config.yaml", "config/smoke.yaml")
FIGURES = [f"fig{number:02d}" for number in range(6, 19)]
FIGURES += ["wear_history", "contact_temperature", "load_sharing", "mesh_force", "exponents"]


def test_every_promised_file_is_there(smoke_run):
    results = smoke_run.folder / "results"
    for figure in FIGURES:
        for kind in ("svg", "png"):
            assert (results / "figures" / f"{figure}.{kind}").stat().st_size > 2000
    last = {"without": 0, "temperature_only": 0, "with": 3, "wear_only": 2, "n0700_t060": 1, "n1400_t080": 2}
    for case, cycles in last.items():
        for stage in ("wear", "mesh_stiffness", "transmission_error", "backlash", "response"):
            made = sorted(path.name for path in (results / case / stage).iterdir())
            assert made == [f"q{q:03d}.nc" for q in range(cycles + 1)]
    assert not list(results.rglob("*.tmp"))


def test_all_claims_are_judged_and_counted(smoke_run):
    with open(smoke_run.folder / "results" / "claims.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 54
    assert list(rows[0]) == ["id", "figure", "says", "expected", "found", "verdict"]
    assert {row["verdict"] for row in rows} <= {"agree", "differs", "not decided"}
    agree = sum(row["verdict"] == "agree" for row in rows)
    assert f"Claims of the paper: {agree} of 54 agree" in smoke_run.printed
    page = (smoke_run.folder / "results" / "claims.html").read_text(encoding="utf-8")
    assert f"{agree} of 54 agree" in page and page.count('<tr class="') == 54


def test_the_list_of_parameters_has_the_values_of_the_run(smoke_run):
    with open(smoke_run.folder / "results" / "parameters.csv", newline="") as file:
        rows = {row["key"]: row for row in csv.DictReader(file)}
    assert rows["grid.mesh_cells"]["value"] == "80"
    assert (rows["gear_pair.module"]["value"], rows["gear_pair.module"]["unit"]) == ("0.003175", "m")
    assert all(row["meaning"] and row["origin"] for row in rows.values())
    assert rows["grid.mesh_cells"]["origin"] == "smoke.yaml"
    assert rows["gear_pair.module"]["origin"].startswith("field: ")


def test_every_warning_is_on_the_screen_once(smoke_run):
    with open(smoke_run.folder / "results" / "warnings.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    said = [line for line in smoke_run.printed.splitlines() if line.startswith("warning: ")]
    assert len(said) == len(rows) == len(set(said))


def test_every_job_left_a_log_and_a_benchmark(smoke_run):
    results = smoke_run.folder / "results"
    logs = {path.relative_to(results / "logs").with_suffix("") for path in (results / "logs").rglob("*.log")}
    costs = {
        path.relative_to(results / "benchmarks").with_suffix("") for path in (results / "benchmarks").rglob("*.tsv")
    }
    assert logs and logs == costs


def test_every_file_says_what_it_is(smoke_run):
    files = sorted((smoke_run.folder / "results").rglob("*.nc"))
    assert len(files) > 60
    for path in files:
        with netCDF4.Dataset(path) as file:
            assert file.Conventions == "CF-1.11"
            assert len(file.lineage) == len(file.code) == 16
            json.loads(file.config), json.loads(file.inputs)
            for name, variable in file.variables.items():
                assert variable.long_name, (path, name)
                labels = variable.dtype is str or variable.dtype.kind in "iU"
                assert labels or variable.units, (path, name)


@pytest.mark.parametrize(
    "pattern, variables",
    [
        ("with/wear/q001.nc", ["wear_depth"]),
        ("with/mesh_stiffness/q001.nc", ["mesh_stiffness", "pair_stiffness"]),
        ("with/transmission_error/q001.nc", ["transmission_error", "load_sharing_factor", "elastic_deflection"]),
        ("with/backlash/q001.nc", ["backlash", "backlash_path"]),
        ("with/response/q001.nc", ["mesh_force"]),
        ("with/temperature.nc", ["contact_temperature", "flash_temperature"]),
        ("with/deformation.nc", ["thermal_growth"]),
        *[
            (
                f"with/sweeps/{order}/{sweep}.nc",
                [sweep, "section_displacement", "section_velocity", "motion_class", "period"],
            )
            for order in ("restart", "up", "down")
            for sweep in ("mesh_frequency", "ste", "backlash")
        ],
        ("with/basins/mesh_frequency.nc", ["basin", "attractors", "share", "share_error", "undecided_share"]),
        ("without/sweeps/restart/mesh_frequency.nc", ["lyapunov_exponent", "contact_loss_share"]),
        *[
            (f"with/branches/{sweep}.nc", [sweep, "branch_displacement", "floquet_real", "stable", "special_point"])
            for sweep in ("mesh_frequency", "ste", "backlash")
        ],
    ],
)
def test_public_names(smoke_run, pattern, variables):
    with netCDF4.Dataset(smoke_run.folder / "results" / pattern) as file:
        assert set(variables) <= set(file.variables)


def test_the_report_holds_every_figure_and_page_with_its_caption(smoke_run):
    run = smoke_run.snakemake("all", *SMOKE, "--report", "report.zip")
    assert run.returncode == 0, run.stdout
    with zipfile.ZipFile(smoke_run.folder / "report.zip") as report:
        names = {Path(name).name for name in report.namelist()}
        page = report.read("report/report.html").decode()
    pages = {"claims.html", "claims.csv", "parameters.html", "versions.html", "warnings.html", "basins_with_ste.svg"}
    assert names >= pages | {f"{figure}.svg" for figure in FIGURES}
    for word in ("A dot for every wear cycle computed", "Case with: 100 °C bulk temperature, 0.3", "The graph beside"):
        assert word in page or json.dumps(word)[1:-1] in page, word


def test_a_case_is_handed_over_with_every_wear_cycle(smoke_run):
    run = smoke_run.snakemake("-j2", *SMOKE, "--", "results/with/handover/dictionary.csv")
    assert run.returncode == 0, run.stdout
    folder = smoke_run.folder / "results" / "with" / "handover"
    assert {path.name for path in folder.iterdir()} == {
        "handover.nc",
        *(f"{table}.csv" for table in ("mesh", "wear", "states", "gears", "dictionary")),
    }
    with open(folder / "states.csv", newline="") as file:
        states = list(csv.DictReader(file))
    assert [row["wear_cycle"] for row in states] == ["0", "1", "2", "3"]
    assert float(states[-1]["running_cycles"]) > float(states[0]["running_cycles"]) == 0


def test_bad_config_stops_before_any_job(smoke_run, tmp_path):
    bad = smoke_run.folder / "bad.yaml"
    bad.write_text("dynamics: {dampng_ratio: 0.1}\nwear: {cycles_per_update: .nan}\n")
    run = smoke_run.snakemake("-j2", "all", "--directory", str(tmp_path), "--configfile", str(bad))
    assert run.returncode != 0
    assert "dynamics.dampng_ratio" in run.stdout and "damping_ratio" in run.stdout
    assert "wear.cycles_per_update" in run.stdout
    assert "Traceback" not in run.stdout
    assert not list(tmp_path.rglob("*.nc"))


def test_a_jam_stops_with_quantity_value_and_limit(smoke_run, tmp_path):
    bad = tmp_path / "bad.yaml"
    bad.write_text("backlash: {half_backlash: 1.0e-6}")
    target = "results/with/backlash/q000.nc"
    run = smoke_run.snakemake("-j2", target, "--directory", str(tmp_path), "--configfile", str(bad))
    assert run.returncode != 0
    for word in ("jam", "half backlash", "um"):
        assert word in run.stdout
    assert not list(tmp_path.rglob("*.tmp"))


def test_truncated_input_is_named(smoke_run, tmp_path):
    target = "results/with/temperature.nc"
    made = smoke_run.snakemake("-j2", "--directory", str(tmp_path), "results/geometry.nc")
    assert made.returncode == 0, made.stdout
    geometry = tmp_path / "results" / "geometry.nc"
    geometry.write_bytes(geometry.read_bytes()[:4000])
    run = smoke_run.snakemake("-j2", "--directory", str(tmp_path), target)
    assert run.returncode != 0
    assert "results/geometry.nc: not a readable netCDF file" in run.stdout
    assert not (tmp_path / target).exists()
