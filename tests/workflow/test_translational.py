"""Model translational in the workflow: what is left out, and what is refused."""

import pytest
import yaml


@pytest.fixture(scope="module")
def asked(make_project):
    """Return a function that plans a target of the translational study and returns how that went."""
    project = make_project("translational")
    (project.folder / "bearings.yaml").write_text(yaml.safe_dump({"dynamics": {"model": "translational"}}))
    files = ("config/config.yaml", "config/smoke.yaml", "bearings.yaml")
    return lambda target: project.snakemake("-n", target, "--configfile", *files)


def test_the_study_is_made_without_branches(asked):
    plan = asked("all")
    assert plan.returncode == 0, plan.stdout
    for rule in ("solve_response", "sweep_part", "carry_sweep", "trace_portraits", "map_basins", "judge_claims"):
        assert rule in plan.stdout
    assert "continue_orbits" not in plan.stdout


def test_what_needs_branches_is_refused_with_one_message(asked):
    refused = asked("onsets")
    assert refused.returncode != 0
    assert "dynamics.model: translational has neither branches of periodic orbits" in refused.stdout
    assert "Traceback (most recent call last)" not in refused.stdout
