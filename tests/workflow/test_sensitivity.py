"""The sensitivity in the workflow: its plan, what re-runs it, and bad ranges."""

import re

import pytest
import yaml


@pytest.fixture(scope="module")
def project(make_project):
    return make_project("sensitivity")


def planned(project, overlay, *arguments):
    path = project.folder / "overlay.yaml"
    path.write_text(yaml.safe_dump(overlay))
    return project.snakemake("--configfile", "config/config.yaml", "config/smoke.yaml", path.name, "-n", *arguments)


def measured(run):
    assert run.returncode == 0, run.stdout
    return set(re.findall(r"route to chaos: results/(\S*)measures\.nc\.$", run.stdout, flags=re.MULTILINE))


def test_every_variation_is_one_job_beside_the_study_itself(project):
    plan = planned(project, {}, "sensitivity")
    found = measured(plan)
    assert {
        "",
        "studies/sensitivity/heat_growth_eulerian/",
        "studies/sensitivity/dynamics_harmonics_full/",
        "studies/sensitivity/damping_ratio_low/",
    } <= found
    assert f"total {len(found) + 3}" in re.sub(" +", " ", plan.stdout)


def test_another_default_makes_other_members(project):
    found = measured(planned(project, {"heat": {"growth": "eulerian"}}, "sensitivity"))
    assert "studies/sensitivity/heat_growth_paper/" in found
    assert "studies/sensitivity/heat_growth_eulerian/" not in found


def test_an_option_that_the_configuration_refuses_is_not_computed_and_the_rest_is(project):
    found = measured(planned(project, {"lubricant": {"dynamic_viscosity_40": 0.005}}, "sensitivity"))
    assert "studies/sensitivity/lubricant_viscosity_law_vogel/" not in found
    assert "studies/sensitivity/friction_law_thresholds/" in found


def test_a_member_can_be_asked_for_with_all_its_files(project):
    file = "results/studies/sensitivity/heat_growth_eulerian/with/deformation.nc"
    plan = planned(project, {}, "--", file)
    assert plan.returncode == 0 and "heat_growth_eulerian/with: growing the flanks" in plan.stdout


def test_nothing_of_it_belongs_to_all(project):
    plan = planned(project, {}, "all")
    assert plan.returncode == 0 and "measure_member" not in plan.stdout


def test_a_bad_range_is_one_clear_error(project):
    run = planned(project, {"sensitivity": {"pinion_torque": {"low": 170.0}}}, "sensitivity")
    assert run.returncode != 0
    assert (
        "configuration: 1 problem\n"
        "  sensitivity.pinion_torque.high: 162.0 is not above sensitivity.pinion_torque.low, 170.0; exchange them or "
        "widen the range\n"
    ) in run.stdout
