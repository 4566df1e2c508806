"""A job that an executor starts on another machine reads the workflow anew: only what was planned is done."""

import pytest

from gearwear.run.token import VARIABLE


@pytest.fixture(scope="module")
def project(make_project):
    return make_project("orders")


@pytest.mark.parametrize(
    "given, answer",
    [(None, f"{VARIABLE} is not set"), ("0123456789abcdef run", "changed while the workflow was running")],
)
def test_a_job_elsewhere_without_the_plan_of_its_run_makes_nothing(project, monkeypatch, given, answer):
    monkeypatch.delenv(VARIABLE, raising=False)
    if given:
        monkeypatch.setenv(VARIABLE, given)
    job = project.snakemake("--cores", "1", "--mode", "remote", "results/geometry.nc")
    assert job.returncode == 1
    assert answer in job.stdout and "Traceback" not in job.stdout, job.stdout[-3000:]
    assert not (project.folder / "results" / "geometry.nc").exists()
