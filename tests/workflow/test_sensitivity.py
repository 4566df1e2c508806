"""The sensitivity in the workflow: its plan, what re-runs it, and bad ranges."""

import re

import pytest


@pytest.fixture(scope="module")
def project(make_project):
    return make_project("sensitivity")


def planned(project, settings, *targets):
    return project.snakemake("-n", *project.smoke(settings), "--", *targets)


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
        "studies/sensitivity/lubricant_viscosity_law_vogel/",
    } <= found
    assert f"total {len(found) + 3}" in re.sub(" +", " ", plan.stdout)


def test_other_defaults_make_other_members_and_those_that_the_configuration_refuses_are_not_computed(project):
    settings = {"heat": {"growth": "eulerian"}, "lubricant": {"dynamic_viscosity_40": 0.005}}
    found = measured(planned(project, settings, "sensitivity"))
    assert {f"studies/sensitivity/{name}/" for name in ("heat_growth_paper", "friction_law_thresholds")} <= found
    assert "studies/sensitivity/heat_growth_eulerian/" not in found  # the default now
    assert "studies/sensitivity/lubricant_viscosity_law_vogel/" not in found  # refused for this oil


def test_a_member_can_be_asked_for_with_all_its_files_and_nothing_of_it_belongs_to_all(project):
    file = "results/studies/sensitivity/heat_growth_eulerian/with/deformation.nc"
    plan = planned(project, {}, "all", file)
    assert plan.returncode == 0 and "heat_growth_eulerian/with: computing the thermal growth" in plan.stdout
    assert not measured(plan)


def test_a_bad_range_is_one_clear_error(project):
    run = planned(project, {"sensitivity": {"pinion_torque": {"low": 170.0}}}, "sensitivity")
    assert run.returncode != 0
    assert (
        "configuration: 1 problem\n"
        "  sensitivity.pinion_torque.high: 162.0 is not above sensitivity.pinion_torque.low, 170.0; exchange them or "
        "widen the range\n"
    ) in run.stdout
