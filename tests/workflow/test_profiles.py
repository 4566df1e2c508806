"""The profile for Slurm names rules that exist, and behaves as the default one otherwise."""

import re
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
PROFILES = ROOT / "profiles"
DEFAULT, SLURM = (yaml.safe_load((PROFILES / name / "config.yaml").read_text()) for name in ("default", "slurm"))
# The most that any job took, with numba compiling, and the two snakemakes beside it on the node.
LARGEST_JOB = 485 + 2 * 171


def test_slurm_keeps_the_lines_of_the_default_profile():
    assert DEFAULT.items() <= SLURM.items()


@pytest.mark.parametrize("key", ["set-resources", "groups"])
def test_the_profile_names_rules_that_exist(rules, key):
    assert set(SLURM[key]) <= set(rules)


def test_every_figure_is_grouped_but_those_outside_all(rules):
    figures = {name for name in rules if name.startswith("plot_")}
    alone = {"plot_checks", "plot_map", "plot_onsets", "plot_sensitivity", "plot_calibration", "plot_study"}
    assert figures - set(SLURM["groups"]) == alone


def test_no_group_asks_for_a_wildcard_that_its_rule_lacks(rules):
    for rule, group in SLURM["groups"].items():
        assert set(re.findall(r"{(\w+)}", group)) <= set(rules[rule]["wildcards"]), rule


def test_components_belong_to_groups():
    assert set(SLURM["group-components"]) <= set(SLURM["groups"].values())


def test_time_and_memory_are_whole_and_enough_for_the_largest_job():
    for resources in [SLURM["default-resources"], *SLURM["set-resources"].values()]:
        assert all(isinstance(value, int) and value > 0 for value in resources.values())
    assert max(one.get("mem_mb", 0) for one in SLURM["set-resources"].values()) > LARGEST_JOB


def test_the_lock_of_the_plugin_agrees_with_that_of_the_program():
    pattern = re.compile(r"^([\w.-]+)==(\S+)", flags=re.MULTILINE)
    base, plugin = (
        set(pattern.findall((ROOT / name).read_text()))
        for name in ("requirements.lock", "profiles/slurm/requirements.lock")
    )
    shared = {name for name, _ in base} & {name for name, _ in plugin}
    assert {pair for pair in plugin if pair[0] in shared} <= base
    assert "snakemake-executor-plugin-slurm" not in {name for name, _ in base}
