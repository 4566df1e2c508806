"""Model translational in the workflow: what is left out, and what is refused."""

import pytest


@pytest.fixture(scope="module")
def project(make_project):
    return make_project("translational")


def test_the_study_is_made_without_branches(project):
    jobs = project.jobs("all", *project.smoke({"dynamics": {"model": "translational"}}))
    assert {"response", "sweep", "portraits", "basins", "claims"} <= set(jobs)
    assert "branches" not in jobs


def test_what_needs_branches_is_refused_with_one_message(project):
    refused = project.snakemake("-n", "onsets", *project.smoke({"dynamics": {"model": "translational"}}))
    assert refused.returncode != 0
    assert "dynamics.model: translational has neither branches of periodic orbits" in refused.stdout
    assert "Traceback (most recent call last)" not in refused.stdout
