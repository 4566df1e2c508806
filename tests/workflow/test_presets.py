"""The presets: their configurations, what they plan, and two of them run small."""

import re
from pathlib import Path

import numpy as np
import pytest
import yaml
from snakemake.utils import update_config

from gearwear.codes.branch_codes import SPECIAL_POINTS
from gearwear.config.check import check
from gearwear.io import store

ROOT = Path(__file__).resolve().parents[2]
PRESETS = sorted(path.stem for path in (ROOT / "config" / "presets").glob("*.yaml"))
OTHER_PAIRS = ["chen-shao", "fzg-c", "kahraman-blankenship"]
OSCILLATORS = ["ks-1991"]
PAPER = ["benchmark", "paper"]

SHORT = {
    "grid": {"mesh_cells": 80},
    "settling": {"transient_periods": 100, "longest_transient": 800, "sampled_periods": 80, "largest_period": 16},
}


def read(name):
    return yaml.safe_load((ROOT / "config" / name).read_text(encoding="utf-8"))


def merged(name):
    config = read("config.yaml")
    update_config(config, read(f"presets/{name}.yaml"))
    return config


@pytest.fixture(scope="module")
def project(make_project):
    return make_project("presets")


def run(project, folder, name, overlay, *arguments):
    """Run snakemake with a preset and an overlay in a folder of its own and return the folder."""
    path = project.folder / f"{name}-small.yaml"
    path.write_text(yaml.safe_dump(overlay))
    configs = [project.folder / "config" / file for file in ("config.yaml", f"presets/{name}.yaml")]
    files = [str(file) for file in (*configs, path)]
    made = project.snakemake("-j1", "--directory", str(folder), "--configfile", *files, "--", *arguments)
    assert made.returncode == 0, made.stdout[-8000:]
    return folder / "results"


def planned(project, folder, name):
    """Return the files that `all` would make."""
    files = [str(project.folder / "config" / file) for file in ("config.yaml", f"presets/{name}.yaml")]
    return set(project.summary("all", "--directory", str(folder), "--configfile", *files))


def test_every_preset_is_named_here_and_in_the_documentation():
    assert sorted(OTHER_PAIRS + OSCILLATORS + PAPER) == PRESETS
    text = (ROOT / "docs" / "how-to" / "presets.md").read_text(encoding="utf-8")
    assert re.findall(r"^\| `([a-z0-9-]+)` \|", text, flags=re.MULTILINE) == [
        "paper",
        "fzg-c",
        "kahraman-blankenship",
        "chen-shao",
        "benchmark",
        "ks-1991",
    ]


@pytest.mark.parametrize("name", PRESETS)
def test_every_preset_is_a_valid_configuration(name):
    config = check(merged(name))
    assert config["figures"]["claims"] == (name in PAPER + OSCILLATORS)
    assert bool(config["oscillators"]) == (name in OSCILLATORS)


def test_the_preset_of_the_paper_is_the_default():
    assert merged("paper") == read("config.yaml")


@pytest.mark.parametrize("name", OTHER_PAIRS)
def test_another_pair_plans_every_figure_and_no_claims(project, tmp_path, name):
    files = planned(project, tmp_path, name)
    assert {f"results/figures/fig{number:02d}.svg" for number in range(6, 19)} <= files
    assert not [path for path in files if "claims" in path]


def test_a_given_oscillator_plans_nothing_of_a_gear_pair(project, tmp_path):
    files = planned(project, tmp_path, "ks-1991")
    assert "results/ks_1991/excitation.nc" in files
    own = {path for path in files if path.startswith("results/ks_1991/")}
    figures = {path for path in files if path.startswith("results/figures/")}
    tables = {f"results/{name}.{kind}" for name in ("parameters", "versions") for kind in ("csv", "html")}
    assert files == own | figures | tables
    kinds = {path.split("/")[2] for path in own}
    assert kinds == {"excitation.nc", "sweeps", "branches", "portraits", "basins"}
    stems = {Path(path).stem for path in figures}
    of_case = {f"{kind}_ks_1991_mesh_frequency" for kind in ("portraits", "basins")}
    assert stems == {"fig12", "fig15", "exponents"} | of_case


def test_the_oscillator_of_1991_has_the_known_motion_and_folds(project, tmp_path):
    """Section at 0.5 and folds of period 1 of the set of Kahraman and Singh (1991), as in config/validation.yaml."""
    overlay = SHORT | {
        "sweeps": {"mesh_frequency": {"points": 41}, "ste": {"cases": ["with"]}},
        "basins": {"points": {"mesh_frequency": {"ks_1991": [0.445]}}, "resolution": 8},
    }
    results = run(project, tmp_path, "ks-1991", overlay, "all")
    assert not list(results.glob("geometry.nc")) and not (results / "with").exists()
    portraits = store.load(results / "ks_1991" / "portraits" / "mesh_frequency.nc")
    point = portraits.isel(point=int(np.argmin(abs(portraits["mesh_frequency"].values - 0.5))))
    assert int(point["motion_class"]) == 1
    section = [float(point[f"section_{name}"][-1]) for name in ("displacement", "velocity")]
    assert section == pytest.approx([1.03825291165, 0.08857427185], abs=1e-9)
    branches = store.load(results / "ks_1991" / "branches" / "mesh_frequency.nc")
    folds = branches["special_point"].values == SPECIAL_POINTS["fold"]
    folds &= branches["branch_period"].values[branches["branch_index"].values] == 1
    found = np.sort(branches["mesh_frequency"].values[folds])
    assert found == pytest.approx([0.437007, 0.455324, 0.598153, 0.8358377], abs=1e-6)


def test_the_test_gears_of_the_rig_run_from_the_pair_to_the_diagram(project, tmp_path):
    one_step = merged("fzg-c")["wear"]["cycles_per_update"]
    overlay = SHORT | {"cases": {"with": {"running_cycles": one_step}}, "sweeps": {"mesh_frequency": {"points": 5}}}
    results = run(project, tmp_path, "fzg-c", overlay, "results/figures/fig12.svg")
    geometry = store.load(results / "geometry.nc")
    assert float(geometry["contact_ratio"]) == pytest.approx(1.46, abs=5e-3)  # report C14 of GEARpie
    depth = store.load(results / "with" / "wear" / "q001.nc")["wear_depth"].values
    assert depth.max() > 0 and (depth >= 0).all()
    assert "paper" not in (results / "figures" / "fig12.svg").read_text(encoding="utf-8")
